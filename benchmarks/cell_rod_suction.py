"""Cell and rod under suction against 3D finite elements: presets and random designs of every family
while their cavities shrink to seven tenths.

    python -m benchmarks.cell_rod_suction measure [--mesh medium] [--only PATTERN] [--seconds 600]
    python -m benchmarks.cell_rod_suction write

``measure`` adds 3D answers to ``cell_rod_suction.jsonl``, one line of JSON each, and leaves out
those that stand there, so that it can be stopped and begun again. Their paths are led by the
cavity's volume, which goes on where suction alone would let a chamber collapse. ``write`` asks cell
and rod at the same pressures and puts the table into docs/cell_rod.md. Errors are distances of the
tips over the longest way of the tip up to there: weight moves it one way and suction back.
"""

import argparse
import json
import math
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from actuators.design import FAMILIES, Design, parse_design, preset
from actuators.geometry.volumes import exact_volumes
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Response
from actuators.mechanics.scene import STANDARD_GRAVITY, VACUUM, Scene
from benchmarks.random_questions import random_design

FILE = Path(__file__).with_suffix(".jsonl")
PAGE = Path(__file__).parent.parent / "docs" / "cell_rod.md"
BEGIN, END = "<!-- suction -->\n", "\n<!-- end of suction -->"
NAMED = (
    "slab-rectangle-low", "oblique-90", "printed-14", "bellows-9-2.0",
    "slab-ellipse-low", "oblique-45", "bellows-13-1.6", "slab-triangle-high",
)  # fmt: skip
SEED, RANDOM, CHAMBERS = 31, 5, (5, 7)
"""Random designs of each family. Every other one is asked without weight."""
LEFT = (0.95, 0.9, 0.85, 0.8, 0.75, 0.7)
PATIENCE_S = 120.0
"""Processor seconds of a 3D answer; it keeps what it has found by then."""
STEPS = 40

Entry = dict[str, Any]


@dataclass(frozen=True)
class Case:
    """A design that is sucked at, with or without its weight."""

    name: str
    design: Design
    weight: bool


def cases() -> Iterator[Case]:
    """Presets, and random designs: the same ones whatever was asked before."""
    for name in NAMED:
        yield Case(name, preset(name).design, True)
    for number in range(RANDOM):
        for k, family in enumerate(FAMILIES):
            rng = np.random.default_rng([SEED, k, number])
            design = random_design(rng, family, CHAMBERS)
            yield Case(f"random {family} {number + 1}", design, number % 2 == 0)


def in_3d(case: Case, mesh: str) -> Entry:
    """The 3D answer as a line of the file: tips and pressures where so much is :data:`LEFT`."""
    from actuators.mechanics.continuum import solve

    rest = exact_volumes(case.design).cavity
    scene = Scene(volume_to=LEFT[-1] * rest, steps=len(LEFT), gravity=_gravity(case.weight))
    begun = time.process_time()
    answer = solve(
        case.design, scene, mesh=mesh,
        cancelled=lambda: time.process_time() - begun > PATIENCE_S,
    )  # fmt: skip
    return {
        "case": case.name, "mesh": mesh, "weight": case.weight,
        "design": case.design.to_document(),
        "outcome": answer.outcome.value, "unknowns": answer.unknowns,
        "cpu": round(time.process_time() - begun, 1),
        "path": [_kept(point.to_document(), rest) for point in answer.path],
    }  # fmt: skip


def _kept(point: dict[str, Any], rest: float) -> dict[str, Any]:
    return {
        "left": _short(point["cavity_volume_ml"] * 1e-6 / rest),
        "pressure_kPa": _short(point["pressure_kPa"]),
        "moved_mm": [_short(x) for x in point["tip_displacement_mm"]],
    }


def _gravity(weight: bool) -> tuple[float, float, float] | None:
    return STANDARD_GRAVITY if weight else None


def measure(mesh: str, only: str, seconds: float) -> None:
    """Add the 3D answers that are missing, for so many seconds on the clock."""
    there = {(entry["case"], entry["mesh"]) for entry in read()}
    end = time.monotonic() + seconds
    for case in cases():
        if only not in case.name or (case.name, mesh) in there:
            continue
        if time.monotonic() > end:
            return
        entry = in_3d(case, mesh)
        with FILE.open("a") as out:
            out.write(json.dumps(entry) + "\n")
        told = [(p["left"], p["pressure_kPa"]) for p in entry["path"]]
        print(case.name, mesh, entry["outcome"], f"{entry['cpu']} s", told, flush=True)


def read() -> list[Entry]:
    """The 3D answers kept."""
    return [json.loads(line) for line in FILE.read_text().splitlines()] if FILE.exists() else []


@dataclass(frozen=True)
class Compared:
    """``pressure``: (k,) [Pa] at which so much of the cavity is :data:`LEFT` in 3D, falling, as far
    as 3D's has no extreme and there is so much air outside; ``error``: (k,) of cell-rod's tip
    there, over the longest way up to it; not a number beyond its end. ``answer``: that of cell-rod,
    asked for the last pressure."""

    pressure: np.ndarray
    error: np.ndarray
    answer: Response

    @property
    def trusted(self) -> np.ndarray:
        """(k,) whether cell-rod trusts itself there."""
        to = self.answer.trusted_to
        return np.isfinite(self.error) & (np.abs(self.pressure) <= abs(to or math.inf))

    @property
    def expected(self) -> float:
        """Error that cell-rod expects as far as it trusts itself."""
        scene = Scene(1e-3 * float(self.pressure[-1]), steps=1, gravity=self.answer.scene.gravity)
        near = predict(self.answer.design, scene, rung="cell-rod")
        assert near.error_estimate is not None
        return near.error_estimate


def compared(entry: Entry) -> Compared:
    """Cell and rod of today beside a 3D answer kept."""
    left, pressure, moved = _downwards(entry["path"])
    scene = Scene(float(pressure[-1]), steps=STEPS, gravity=_gravity(entry["weight"]))
    answer = predict(parse_design(entry["design"]), scene, rung="cell-rod")
    at = np.array([point.pressure for point in answer.path])
    tips = np.array([point.tip_displacement for point in answer.path])
    found = np.stack(
        [np.interp(-pressure, -at, column, right=math.nan) for column in tips.T], axis=1
    )
    way = np.maximum.accumulate(np.linalg.norm(moved, axis=1))
    # without weight nothing has moved at rest
    error = np.linalg.norm(found - moved, axis=1)[1:] / way[1:]
    levels = np.array([share for share in LEFT if share >= left[-1]])
    return Compared(
        np.interp(-levels, -left, pressure), np.interp(-levels, -left[1:], error), answer
    )


def _downwards(path: list[dict[str, Any]]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Share of the cavity (k,), pressure (k,) [Pa] and way of the tip (k, 3) [m] of a 3D path, down
    to where its suction has an extreme, or leaves no air."""
    left = np.array([p["left"] for p in path])
    pressure = np.array([p["pressure_kPa"] for p in path]) * 1e3
    moved = np.array([p["moved_mm"] for p in path]) * 1e-3
    new = np.append(True, np.diff(left) < 0.0)  # a path taken up again repeats its last point
    left, pressure, moved = left[new], pressure[new], moved[new]
    ended = np.flatnonzero((np.diff(pressure) >= 0.0) | (pressure[1:] < -VACUUM))
    end = int(ended[0]) + 1 if len(ended) else len(pressure)
    return left[:end], pressure[:end], moved[:end]


def table() -> str:
    """Markdown table of all 3D answers kept."""
    heads = [f"{share:.0%} left" for share in LEFT]
    lines = [
        f"| design | weight | mesh | {' | '.join(heads)} | trusted to, kPa | expected, % |",
        f"|{' --- |' * (len(LEFT) + 5)}",
    ]
    for entry in sorted(read(), key=_order):
        row = compared(entry)
        cells = [_cell(row, k) if k < len(row.pressure) else "" for k in range(len(LEFT))]
        if len(row.pressure) < len(LEFT):
            cells[len(row.pressure)] = _ended(entry)
        to = row.answer.trusted_to
        trusted = "further" if to is None else f"{to / 1e3:.3g}"
        lines.append(
            f"| {entry['case']} | {'yes' if entry['weight'] else 'no'} | {entry['mesh']} | "
            f"{' | '.join(cells)} | {trusted} | {100 * row.expected:.2g} |"
        )
    return "\n".join(lines)


def _order(entry: Entry) -> tuple[int, str]:
    return [case.name for case in cases()].index(entry["case"]), entry["mesh"]


def _cell(row: Compared, k: int) -> str:
    pressure = f"{row.pressure[k] / 1e3:.3g}"
    if not np.isfinite(row.error[k]):
        return f"no answer ({pressure})"
    told = f"{100 * row.error[k]:.2g} ({pressure})"
    return told if row.trusted[k] else f"*{told}*"


def _ended(entry: Entry) -> str:
    if entry["outcome"] != "converged":
        return f"3D: {entry['outcome'].replace('_', ' ')}"
    return "more than vacuum" if entry["path"][-1]["pressure_kPa"] < -VACUUM / 1e3 else "extreme"


def write() -> None:
    """Put the table on its page."""
    text = table()
    head, _, rest = PAGE.read_text().partition(BEGIN)
    _, _, tail = rest.partition(END)
    PAGE.write_text(f"{head}{BEGIN}{text}{END}{tail}")
    print(text)


def _short(value: float) -> float:
    return float(f"{value:.6g}")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("what", choices=("measure", "write"))
    parser.add_argument("--mesh", default="coarse")
    parser.add_argument("--only", default="")
    parser.add_argument("--seconds", type=float, default=math.inf)
    asked = parser.parse_args()
    if asked.what == "measure":
        measure(asked.mesh, asked.only, asked.seconds)
    else:
        write()


if __name__ == "__main__":
    main()
