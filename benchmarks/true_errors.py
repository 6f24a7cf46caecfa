"""True errors beside estimated ones where walls press on each other.

    python -m benchmarks.true_errors PROBLEM [--to 1,1,1] [--keep FOLDER]

The path on the coarsest mesh, then its end on one finer mesh after the other, as a job climbs them;
the last mesh is the reference. What is kept in FOLDER is not computed again, so that a run can be
stopped and go on. Prints the rows of the table in docs/performance.md.
"""

import argparse
import json
import pickle
import time
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from actuators.design import preset
from actuators.design.base import Design
from actuators.geometry import Body, build_body
from actuators.mechanics.continuum.estimates import Measured, change, estimates, measure
from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.level import Level, open_level
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.refinement import Anchor, Refinement
from actuators.mechanics.continuum.tracer import Path as Found
from actuators.mechanics.scene import Scene
from actuators.meshing import mesh_body
from actuators.meshing.levels import Layers, levels_of


@dataclass(frozen=True)
class Problem:
    """``design`` in ``scene``: walls press on each other at the end."""

    title: str
    design: Design
    scene: Scene

    @property
    def body(self) -> Body:
        """Its half where it has one."""
        body = build_body(self.design)
        return body.half() if body.symmetric and self.scene.symmetric else body


PROBLEMS = {
    "oblique": Problem(
        "three chambers of oblique-60, 20 kPa",
        preset("oblique-60").design.changed(chamber_count=3, length=38),
        Scene(20e3, gravity=None),
    ),
    "straight": Problem(
        "two chambers of oblique-90, 8 kPa",
        preset("oblique-90").design.changed(
            chamber_count=2, length=26, channel_width=0, half_gap=0.15
        ),
        Scene(8e3, gravity=None),
    ),
    "bellows": Problem(
        "two bellows of bellows-11-2.0, 200 kPa",
        preset("bellows-11-2.0").design.changed(chamber_count=2, length=27.5, gap=0.2),
        Scene(200e3, gravity=None),
    ),
}


class Ladder:
    """Meshes of one problem, coarsest first, and the path's end on each."""

    def __init__(self, problem: Problem, keep: Path) -> None:
        self._problem, self._keep = problem, keep
        keep.mkdir(parents=True, exist_ok=True)
        self._coarse = self._level((0, 0, 0))
        self._path = self._followed()

    def measured(self, ladder: Sequence[Layers]) -> dict[Layers, Measured]:
        """What is compared, on each mesh."""
        before = Anchor(self._coarse.system, self._path.points[-1])
        out = {(0, 0, 0): measure(before.system, before.found)}
        for layers in ladder:
            before = self._end(layers, before)
            out[layers] = measure(before.system, before.found)
        return out

    def _level(self, layers: Layers) -> Level:
        return open_level(mesh_body(self._problem.body, layers=layers), self._problem.scene)

    def _followed(self) -> Found:
        file = self._keep / "path.pickle"
        if file.exists():
            return pickle.loads(file.read_bytes())
        began, level = time.process_time(), self._coarse
        half = self._coarse.system.mesh.is_half
        path = PathFollower(level.system, level.solver).reach(
            Goal.of(self._problem.scene, is_half=half)
        )
        print(f"path: {path.outcome.value}, {time.process_time() - began:.1f} s", flush=True)
        file.write_bytes(pickle.dumps(path))
        return path

    def _end(self, layers: Layers, before: Anchor) -> Anchor:
        file = self._keep / f"{'-'.join(map(str, layers))}.pickle"
        level = self._level(layers)
        if file.exists():
            return Anchor(level.system, pickle.loads(file.read_bytes()))
        began = time.process_time()
        climb = Refinement(self._coarse.system, level.system, level.solver, self._path)
        anchor = climb.anchor(before)
        if anchor is None or climb.shared < len(self._path.points):
            raise RuntimeError(f"no answer on {layers}")
        seconds = time.process_time() - began
        print(f"{layers}: {level.system.unknowns} unknowns, {climb.iterations} tangents, "
              f"{seconds:.1f} s", flush=True)  # fmt: skip
        file.write_bytes(pickle.dumps(anchor.found))
        return anchor


def rows(title: str, measured: dict[Layers, Measured]) -> list[str]:
    """Lines of the table: every mesh but the first and the last, and whether walls press."""
    *meshes, last = measured
    lines: list[str] = []
    for before, layers in pairwise(meshes):
        at = measured[layers]
        said = estimates(change(measured[before], at), layers, walls_meet=at.walls_meet)
        true = change(at, measured[last])
        cells = [
            f"{100 * value[name]:.2g}"
            for name in ("tip", "angle", "volume")
            for value in (true, said)
        ]
        lines.append(f"| {title} | {_named(layers)} | {' | '.join(cells)} |")
        title = ""
    return lines


def _named(layers: Layers) -> str:
    return f"({','.join(map(str, layers))})"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("problem", choices=PROBLEMS)
    parser.add_argument("--to", help="last mesh, such as 1,1,1; beyond the ladder's own too")
    parser.add_argument("--keep", type=Path, default=Path("/tmp/true_errors"))
    given = parser.parse_args()
    problem = PROBLEMS[given.problem]
    ladder = list(levels_of(problem.body)[1:])
    if given.to is not None:
        first, second, third = map(int, given.to.split(","))
        wanted = (first, second, third)
        at = ladder.index(wanted) if wanted in ladder else len(ladder)
        ladder = [*ladder[:at], wanted]
    measured = Ladder(problem, given.keep / given.problem).measured(ladder)
    for layers, each in measured.items():
        print(json.dumps({
            "layers": layers, "tip_mm": (1e3 * each.tip).tolist(),
            "angle_deg": float(np.degrees(each.angle)), "growth_ml": 1e6 * each.growth,
            "walls_meet": each.walls_meet,
        }))  # fmt: skip
    print("\n".join(rows(problem.title, measured)))


if __name__ == "__main__":
    main()
