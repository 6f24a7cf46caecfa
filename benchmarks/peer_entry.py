"""One engine on one mesh of one problem, in this process: prints a JSON line for benchmarks.peers.

    python -m benchmarks.peer_entry ENGINE PROBLEM LEVEL

Timed is everything from the mesh to the tip at the end pressure: set-up, the whole path, solving.
Imports and compiled kernels are loaded before.
"""

import json
import os
import resource
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from actuators.mechanics.continuum.contact import ContactLaw, Obstacle, contact_law, outside
from actuators.mechanics.continuum.contact.build import CONCENTRATED
from actuators.mechanics.obstacles import Plate
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh, mesh_body
from benchmarks.mini_pneu_net import GRAVITY
from benchmarks.peer_problems import PROBLEMS, Layers, PeerProblem

TOLERANCE = 1e-5
"""Largest correction of a displacement over the body's size; CalculiX keeps its own criterion."""
STEPS = (8, 16, 32, 64)
"""Equal load steps tried by plain Newton's method. Only the first try that works is timed."""


@dataclass(frozen=True)
class Found:
    tip: np.ndarray
    unknowns: int
    iterations: int
    wall: float
    cpu: float
    note: str = ""
    force: float | None = None


def clock() -> tuple[float, float]:
    return time.perf_counter(), time.process_time()


def stop(problem: PeerProblem, mesh: HexMesh) -> tuple[Plate, ContactLaw] | None:
    """The plate, and how hard all programs press on it: as hard as ours takes a scene's plate."""
    if problem.plate is None:
        return None
    return problem.plate, contact_law(mesh, problem.materials, CONCENTRATED * problem.pressure)


def ours(problem: PeerProblem, layers: Layers) -> Found:
    """The path on the coarsest mesh, then one nested solve on the mesh in question."""
    from actuators.mechanics.continuum import warm
    from actuators.mechanics.continuum.contact.report import obstacle_force
    from actuators.mechanics.continuum.path import PathFollower
    from actuators.mechanics.continuum.refinement import Anchor, Refinement
    from actuators.mechanics.continuum.system import ContinuumSystem, clamped
    from actuators.mechanics.direct_solver import SymmetricSolver, open_solver

    def system_on(mesh: HexMesh) -> tuple[ContinuumSystem, SymmetricSolver]:
        plate = stop(problem, mesh)
        obstacles = [] if plate is None else [Obstacle(outside(mesh), plate[1], plate[0])]
        system = ContinuumSystem(
            mesh, problem.materials, free=clamped(mesh), gravity=GRAVITY, interactions=obstacles
        )
        return system, open_solver(system.indptr, system.indices)

    warm.exercise()
    body = problem.half()
    meshes = [mesh_body(body, layers=each) for each in (problem.ladder[0], layers)]
    wall, cpu = clock()
    coarse, solver = system_on(meshes[0])
    path = PathFollower(coarse, solver).follow(problem.pressure, None)
    system, end, iterations = coarse, path.points[-1], path.iterations
    if layers != problem.ladder[0]:
        system, solver = system_on(meshes[1])
        transfer = Refinement(coarse, system, solver, path)
        anchor = transfer.anchor(Anchor(coarse, end))
        if anchor is None:
            raise RuntimeError("no answer on the finer mesh")
        end, iterations = anchor.found, iterations + transfer.iterations
    done = clock()
    tip = end.state.displacement[system.mesh.underside_line[-1]]
    force = obstacle_force(system, end)
    return Found(tip, system.unknowns, iterations, done[0] - wall, done[1] - cpu, force=force)


def ngsolve(problem: PeerProblem, layers: Layers) -> Found:
    """The same element, law and loads in NGSolve's own forms; plain Newton in equal steps."""
    from benchmarks.ngsolve_engine import NgsolveProblem

    mesh = mesh_body(problem.half(), layers=layers)
    return first_that_works(
        lambda: NgsolveProblem(mesh, problem.materials, GRAVITY, stop(problem, mesh)),
        problem.pressure, int(mesh.underside_line[-1]),
    )  # fmt: skip


def felupe(problem: PeerProblem, layers: Layers) -> Found:
    """Triquadratic displacement with two discontinuous fields; plain Newton in equal steps."""
    from benchmarks.felupe_engine import FelupeProblem

    mesh = mesh_body(problem.half(), layers=layers)
    return first_that_works(
        lambda: FelupeProblem(mesh, problem.materials, GRAVITY, stop(problem, mesh)),
        problem.pressure, int(mesh.underside_line[-1]),
    )  # fmt: skip


class Stepped(Protocol):
    """A program that raises the load in equal steps of plain Newton."""

    @property
    def unknowns(self) -> int: ...

    def raise_load(self, pressure: float, steps: int, tolerance: float) -> int: ...

    def displacement(self, node: int) -> np.ndarray: ...

    def plate_force(self) -> float | None: ...


def first_that_works(make: Callable[[], Stepped], pressure: float, tip: int) -> Found:
    for steps in STEPS:
        wall, cpu = clock()
        other = make()
        try:
            iterations = other.raise_load(pressure, steps, TOLERANCE)
        except (RuntimeError, ValueError) as error:
            print(f"{steps} steps: {error}", file=sys.stderr)
            continue
        done = clock()
        moved = other.displacement(tip)
        if np.isfinite(moved).all():
            return Found(
                moved, other.unknowns, iterations, done[0] - wall, done[1] - cpu, f"{steps} steps",
                other.plate_force(),
            )  # fmt: skip
    raise RuntimeError("no number of steps worked")


def calculix(problem: PeerProblem, layers: Layers) -> Found:
    """The exported deck with C3D20R, its own automatic steps; reading the deck is timed too."""
    from benchmarks.calculix_engine import run_calculix

    mesh = mesh_body(problem.half(), layers=layers)
    scene = Scene(problem.pressure, gravity=GRAVITY, plate=problem.plate, self_contact="off")
    plate = stop(problem, mesh)
    found = run_calculix(mesh, problem.materials, scene, law=None if plate is None else plate[1])
    return Found(
        found.tip, found.unknowns, found.iterations, found.wall, found.cpu, "own steps", found.force
    )


ENGINES: dict[str, Callable[[PeerProblem, Layers], Found]] = {
    "ours": ours, "NGSolve": ngsolve, "FElupe": felupe, "CalculiX": calculix,
}  # fmt: skip


def main() -> None:
    engine, name, layers = sys.argv[1], sys.argv[2], tuple(map(int, sys.argv[3].split(",")))
    problem = PROBLEMS[name]
    chosen = (layers[0], layers[1], layers[2])
    elements = len(mesh_body(problem.half(), layers=chosen).elements)
    found = ENGINES[engine](problem, chosen)
    own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    # of a spawned program this is at least the spawning process's own
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss if engine == "CalculiX" else own
    print(json.dumps({
        "engine": engine, "problem": name, "layers": chosen, "elements": elements,
        "unknowns": found.unknowns, "iterations": found.iterations, "wall_s": found.wall,
        "cpu_s": found.cpu, "peak_MB": peak / 1024, "tip_mm": (found.tip * 1e3).tolist(),
        "plate_N": None if found.force is None else 2 * found.force, "note": found.note,
        "threads": os.environ.get("OMP_NUM_THREADS", "all"),
    }))  # fmt: skip


if __name__ == "__main__":
    main()
