"""How far the instant rungs are from the cell and rod: random designs of every family, at every
strain that they come to.

    python -m benchmarks.instant_error [--designs 200] [--seconds 600] [--seed 21]

Writes quantiles of the error of the tip's displacement, by family and by the largest strain of the
linear cell, into the package (``typical_errors.json``), and prints them. Designs are random ones
(``benchmarks/random_questions.py``) of 5 to 9 chambers, inflated under gravity.
"""

import argparse
import json
import math
import time
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np

from actuators.design import FAMILIES, Design
from actuators.errors import QuestionError
from actuators.mechanics.cell.row import chamber_row
from actuators.mechanics.ladder import typical as typical_module
from actuators.mechanics.ladder.answer import STILL
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Response
from actuators.mechanics.scene import STRONGEST, Scene
from benchmarks.random_questions import STRAINS, random_design

FILE = Path(typical_module.__file__).parent / typical_module.FILE
REFERENCE = "cell-rod"
CHAMBERS = (5, 9)
"""Fewer than five, and the reference misses the ends of the body itself."""
LEVELS = 7
STEPS = 12
FEWEST = 10
"""Designs that a level needs before it is written down."""
JUDGED = ("closed-form", "energy")


def levels(family: str) -> np.ndarray:
    """Strains at which errors are read off, (LEVELS,)."""
    low, high = STRAINS[family]
    return np.geomspace(low / 2, high, LEVELS)


def errors_of(design: Design) -> dict[str, np.ndarray] | None:
    """Error of each judged rung at every level, (LEVELS,), not a number beyond where the reference
    ends; None where the reference has no answer."""
    per_pressure = chamber_row(design).largest_strain
    strain = levels(design.family)
    scene = Scene(min(float(strain[-1]) / per_pressure, STRONGEST), steps=STEPS)
    try:
        best = predict(design, scene, rung=REFERENCE)
    except QuestionError as refusal:
        print(f"{design.family}: {refusal}")
        return None
    if len(best.path) < 2:
        return None
    return {
        rung: _errors(predict(design, scene, rung=rung), best, strain / per_pressure)
        for rung in JUDGED
    }


def _errors(answer: Response, best: Response, at: np.ndarray) -> np.ndarray:
    count = min(len(answer.path), len(best.path))
    pressure = np.array([p.pressure for p in best.path[:count]])
    wanted = np.array([p.tip_displacement for p in best.path[:count]])
    tried = np.array([p.pressure for p in answer.path])
    moved = np.array([p.tip_displacement for p in answer.path])
    moved = np.stack([np.interp(pressure, tried, column) for column in moved.T], axis=1)
    way = np.maximum(np.linalg.norm(wanted, axis=1), STILL * answer.design.length)
    off = np.linalg.norm(moved - wanted, axis=1) / way
    return np.interp(at, pressure, off, right=np.nan)


def measure(seed: int, designs: int, seconds: float) -> dict[str, dict[str, list[np.ndarray]]]:
    """Errors by rung and family, of up to ``designs`` designs of each in ``seconds`` [s] of
    processor time."""
    rng = np.random.default_rng(seed)
    found: dict[str, dict[str, list[np.ndarray]]] = {
        rung: {family: [] for family in FAMILIES} for rung in JUDGED
    }
    begun = time.process_time()
    for _ in range(designs):
        for family in FAMILIES:
            if time.process_time() - begun > seconds:
                return found
            errors = errors_of(random_design(rng, family, CHAMBERS))
            for rung, values in (errors or {}).items():
                found[rung][family].append(values)
    return found


def quantiles(family: str, errors: list[np.ndarray], source: str) -> dict[str, Any] | None:
    """Half and four fifths of the designs at each level that enough of them came to."""
    if not errors:
        return None
    table = np.array(errors)
    there = np.isfinite(table).sum(axis=0) >= FEWEST
    if there.sum() < 2:
        return None
    half, most = np.nanquantile(table[:, there], [0.5, 0.8], axis=0)
    return {
        "strain": [_short(x) for x in levels(family)[there]],
        "half_below_percent": [_short(100 * x) for x in half],
        "four_of_five_below_percent": [_short(100 * x) for x in most],
        "source": f"{len(errors)} random designs against {source}",
    }


def _short(value: float) -> float:
    return float(f"{max(value, 1e-4):.2g}") if math.isfinite(value) else value


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--designs", type=int, default=200)
    parser.add_argument("--seconds", type=float, default=600.0)
    parser.add_argument("--seed", type=int, default=21)
    asked = parser.parse_args()
    found = measure(asked.seed, asked.designs, asked.seconds)
    document = json.loads(FILE.read_text(encoding="utf-8"))
    source = f"{REFERENCE}, {date.today()}"
    for rung, families in found.items():
        for family, errors in families.items():
            entry = quantiles(family, errors, source)
            if entry is None:
                print(f"{rung}, {family}: too few answers ({len(errors)})")
                continue
            document["rungs"][rung][family] = entry
            _print(rung, family, entry)
    FILE.write_text(_compact(document) + "\n", encoding="utf-8")


def _print(rung: str, family: str, entry: dict[str, Any]) -> None:
    columns = ("strain", "half_below_percent", "four_of_five_below_percent")
    rows = zip(*(entry[name] for name in columns), strict=True)
    cells = "; ".join(f"{100 * s:.3g} %: {h:.2g} / {m:.2g} %" for s, h, m in rows)
    print(f"{rung}, {family} ({entry['source']}): {cells}")


def _compact(document: dict[str, Any]) -> str:
    """One line per list."""
    lines = ["{", ' "rungs": {']
    rungs = list(document["rungs"].items())
    for r, (rung, families) in enumerate(rungs):
        lines.append(f'  "{rung}": {{')
        for f, (family, entry) in enumerate(families.items()):
            lines.append(f'   "{family}": {{')
            parts = [f"    {json.dumps(key)}: {json.dumps(value)}" for key, value in entry.items()]
            lines.append(",\n".join(parts))
            lines.append("   }" + ("," if f < len(families) - 1 else ""))
        lines.append("  }" + ("," if r < len(rungs) - 1 else ""))
    return "\n".join([*lines, " }", "}"])


if __name__ == "__main__":
    main()
