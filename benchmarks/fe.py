"""Error against time on the mini pneu-net: our engine beside NGSolve, in one run.

    python -m benchmarks.fe [--ngsolve-elements 177]

Ours: the path on the coarsest mesh, then one nested solve on each graded mesh; NGSolve: the path in
eight steps of plain Newton on the same meshes up to the given size. Wall and processor seconds,
after a warm-up that compiles or loads every kernel. Set NUMBA_NUM_THREADS and MKL_NUM_THREADS to
choose threads.
"""

import argparse
import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from actuators.mechanics.continuum import warm
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.refinement import Anchor, Refinement
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.direct_solver import open_solver
from actuators.meshing import mesh_body
from benchmarks.mini_pneu_net import (
    GRAVITY,
    MATERIALS,
    PRESSURE,
    REFERENCE_TIP,
    mini_pneu_net,
)

T = TypeVar("T")
LAYERS = ((1, 0, 0), (1, 1, 0), (1, 0, 1), (1, 1, 1), (2, 1, 1), (2, 2, 2))


@dataclass(frozen=True)
class Clock:
    """Wall and processor time of one call [s]."""

    wall: float
    cpu: float


def timed(call: Callable[[], T]) -> tuple[T, Clock]:
    wall, cpu = time.perf_counter(), time.process_time()
    result = call()
    return result, Clock(time.perf_counter() - wall, time.process_time() - cpu)


def open_system(layers: tuple[int, int, int]) -> ContinuumSystem:
    mesh = mesh_body(mini_pneu_net().half(), layers=layers)
    return ContinuumSystem(mesh, MATERIALS, free=clamped(mesh), gravity=GRAVITY)


def row(
    name: str, system: ContinuumSystem, displacement: np.ndarray, iterations: int, clock: Clock
) -> None:
    error = -displacement[2] / REFERENCE_TIP - 1
    print(
        f"{name:28s} {len(system.mesh.elements):6d} {system.unknowns:8d} {iterations:5d} "
        f"{clock.wall:8.2f} {clock.cpu:8.2f}   {-displacement[2] * 1e3:8.4f} {error * 100:+7.2f} %",
        flush=True,
    )


def ours() -> None:
    system = open_system((0, 0, 0))
    solver = open_solver(system.indptr, system.indices)
    path, clock = timed(lambda: PathFollower(system, solver).follow(PRESSURE, None))
    end = path.points[-1]
    tip = system.mesh.underside_line[-1]
    row("ours, whole path", system, end.state.displacement[tip], path.iterations, clock)
    for layers in LAYERS:

        def nested(layers: tuple[int, int, int] = layers) -> tuple[Anchor, int]:
            fine = open_system(layers)
            transfer = Refinement(system, fine, open_solver(fine.indptr, fine.indices), path)
            anchor = transfer.anchor(Anchor(system, end))
            if anchor is None:
                raise RuntimeError(f"no answer on layers {layers}")
            return anchor, transfer.iterations

        (anchor, iterations), clock = timed(nested)
        at = anchor.found.state.displacement[anchor.system.mesh.underside_line[-1]]
        row(f"ours, nested {layers}", anchor.system, at, iterations, clock)


def ngsolve(most_elements: int) -> None:
    try:
        from benchmarks.ngsolve_engine import NgsolveProblem
    except ImportError:
        print("NGSolve is not installed: no comparison")
        return
    for layers in ((0, 0, 0), *LAYERS):
        system = open_system(layers)
        if len(system.mesh.elements) > most_elements:
            continue
        problem = NgsolveProblem(system.mesh, MATERIALS, GRAVITY)
        iterations, clock = timed(lambda problem=problem: problem.raise_load(PRESSURE, 8))
        at = problem.displacement(int(system.mesh.underside_line[-1]))
        row(f"NGSolve, whole path {layers}", system, at, iterations, clock)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--ngsolve-elements", type=int, default=177)
    most = parser.parse_args().ngsolve_elements
    warm.exercise()
    print(f"threads: {os.environ.get('NUMBA_NUM_THREADS', 'all')} (numba), "
          f"{os.environ.get('MKL_NUM_THREADS', 'all')} (MKL); reference tip 35.10 mm")  # fmt: skip
    print(f"{'':28s} {'elem.':>6s} {'unkn.':>8s} {'iter.':>5s} {'wall s':>8s} {'cpu s':>8s}   "
          f"{'tip mm':>8s} {'error':>9s}")  # fmt: skip
    ours()
    ngsolve(most)


if __name__ == "__main__":
    main()
