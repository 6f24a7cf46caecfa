"""CalculiX, and what its files say."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

needs_ccx = pytest.mark.skipif(
    shutil.which("ccx") is None,
    reason="CALCULIX IS MISSING (apt-get install calculix-ccx): decks are NOT run by a program",
)


def run_ccx(folder: Path, text: str, timeout: float = 600) -> list[list[float]]:
    """Numbers printed into the .dat file, row by row."""
    (folder / "model.inp").write_text(text)
    done = subprocess.run(
        ["ccx", "model"], cwd=folder, capture_output=True, text=True, check=False, timeout=timeout,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:]
    assert "Job finished" in done.stdout, done.stdout[-2000:]
    rows = [line.split() for line in (folder / "model.dat").read_text().splitlines()]
    return [[float(word) for word in row] for row in rows if row and row[0][0] in "-0123456789"]


def sections(text: str) -> dict[str, list[str]]:
    """Data lines under each keyword line (the last of equal ones)."""
    out: dict[str, list[str]] = {}
    here: list[str] = []
    for line in text.splitlines():
        if line.startswith("**"):
            continue
        if line.startswith("*"):
            here = out.setdefault(line, [])
        else:
            here.append(line)
    return out
