"""The studio as `make run` starts it, on a data folder of its own."""

import os
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


class Run:
    """A supervisor on a data folder, and what it printed."""

    def __init__(self, data: Path, *options: str) -> None:
        self.data = data
        self.output = data.parent / f"{data.name}.out"
        clean = {k: v for k, v in os.environ.items() if not k.startswith("PNEUSTUDIO_")}
        with self.output.open("w") as out:
            self.process = subprocess.Popen(
                [sys.executable, "-m", "backend.supervisor", "--data", str(data), *options],
                stdout=out, stderr=out, cwd=ROOT, env=clean,
            )  # fmt: skip

    def said(self) -> str:
        return self.output.read_text()

    def address(self) -> str:
        """Of the page, once it answers."""
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            found = re.search(r"ready: (http://\S+)", self.said())
            if found:
                return found[1]
            assert self.process.poll() is None, self.said()
            time.sleep(0.05)
        raise TimeoutError(self.said())
