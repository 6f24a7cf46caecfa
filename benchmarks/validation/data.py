"""docs/validation_data.json: what the page is made from, kept with it."""

import json
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.validation.case import Case
from benchmarks.validation.store import kept
from benchmarks.verification.table import rows

DATA = Path("docs/validation_data.json")
KEPT_KEYS = (
    "pressure_kPa", "tip_displacement_mm", "tip_rotation_deg", "bending_angle_deg",
    "curvature_per_m", "torsion_per_m", "max_principal_stretch", "plate_force_N",
    "max_contact_pressure_kPa",
)  # fmt: skip
KEPT_ABOUT = (
    "group", "outcome", "error_estimate_percent", "unknowns", "assumptions", "notes", "code",
)  # fmt: skip


@dataclass(frozen=True)
class Answer:
    """One kept answer."""

    document: dict[str, Any]

    @property
    def path(self) -> list[dict[str, Any]]:
        return self.document["path"]

    @property
    def outcome(self) -> str:
        return self.document["outcome"]

    @property
    def error_percent(self) -> float | None:
        return self.document["error_estimate_percent"]

    def column(self, key: str) -> np.ndarray:
        """(k,) values along the path, or (k, 3) of a vector; nan where there is none."""
        values = [p.get(key) for p in self.path]
        return np.array([np.nan if v is None else v for v in values], dtype=float)

    def at(self, pressure: float, key: str) -> float:
        """Value at ``pressure`` [kPa], interpolated; nan beyond the path."""
        known = self.column("pressure_kPa")
        if pressure > known[-1] * (1 + 1e-9):
            return float("nan")
        return float(np.interp(pressure, known, self.column(key)))


def collect(cases: Iterable[Case]) -> dict[str, Any]:
    """The verification table, computed now, and every answer there is: those kept on this machine,
    and for the other cases what the file already holds, with the commit that solved it."""
    before = json.loads(DATA.read_text())["cases"] if DATA.exists() else {}
    found: dict[str, Any] = {}
    for case in cases:
        answer = kept(case)
        if answer is not None:
            found[case.key] = _trimmed(answer)
        elif case.key in before:
            found[case.key] = before[case.key]
    return {"verification": [_short(row.document()) for row in rows()], "cases": found}


def write(data: dict[str, Any]) -> None:
    """One line a case, so that a change shows in a diff."""
    lines = ["{", '"verification": [']
    lines += [",\n".join(json.dumps(row) for row in data["verification"]), "],", '"cases": {']
    lines += [",\n".join(f"{json.dumps(k)}: {json.dumps(v)}" for k, v in data["cases"].items())]
    DATA.write_text("\n".join([*lines, "}", "}"]) + "\n")


def read() -> tuple[list[dict[str, Any]], dict[str, Answer]]:
    """Verification rows and answers by key."""
    data = json.loads(DATA.read_text())
    return data["verification"], {k: Answer(v) for k, v in data["cases"].items()}


def _trimmed(document: dict[str, Any]) -> dict[str, Any]:
    short = {key: document.get(key) for key in KEPT_ABOUT}
    short["accuracy"] = document["question"]["accuracy"]
    short["processor_s"] = document["processor_s"]
    short["path"] = [{k: p[k] for k in KEPT_KEYS if p.get(k) is not None} for p in document["path"]]
    return _short(short)


def _short(value: Any) -> Any:
    """Numbers to six digits."""
    if isinstance(value, float):
        return float(f"{value:.6g}")
    if isinstance(value, dict):
        return {k: _short(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_short(v) for v in value]
    return value
