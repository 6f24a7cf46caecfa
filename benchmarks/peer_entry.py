"""One engine on one mesh of one problem, in this process: prints a JSON line for benchmarks.peers.

    python -m benchmarks.peer_entry ENGINE PROBLEM LEVEL

Timed is everything from the mesh to the tip at the end pressure: set-up, the whole path, solving.
Imports and compiled kernels are loaded before.
"""

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

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


def clock() -> tuple[float, float]:
    return time.perf_counter(), time.process_time()


def ours(problem: PeerProblem, layers: Layers) -> Found:
    """The path on the coarsest mesh, then one nested solve on the mesh in question."""
    from actuators.mechanics.continuum import warm
    from actuators.mechanics.continuum.path import PathFollower
    from actuators.mechanics.continuum.refinement import Anchor, Refinement
    from actuators.mechanics.continuum.system import ContinuumSystem, clamped
    from actuators.mechanics.direct_solver import SymmetricSolver, open_solver

    def system_on(mesh: HexMesh) -> tuple[ContinuumSystem, SymmetricSolver]:
        system = ContinuumSystem(mesh, problem.materials, free=clamped(mesh), gravity=GRAVITY)
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
    return Found(tip, system.unknowns, iterations, done[0] - wall, done[1] - cpu)


def ngsolve(problem: PeerProblem, layers: Layers) -> Found:
    """The same element, law and loads in NGSolve's own forms; plain Newton in equal steps."""
    from benchmarks.ngsolve_engine import NgsolveProblem

    mesh = mesh_body(problem.half(), layers=layers)
    tip = tuple(float(x) for x in mesh.nodes[mesh.underside_line[-1]])

    def attempt(steps: int) -> tuple[np.ndarray, int, int]:
        other = NgsolveProblem(mesh, problem.materials, GRAVITY)
        iterations = other.raise_load(problem.pressure, steps, TOLERANCE)
        return other.displacement((tip[0], tip[1], tip[2])), other.unknowns, iterations

    return first_that_works(attempt)


def felupe(problem: PeerProblem, layers: Layers) -> Found:
    """Triquadratic displacement with two discontinuous fields; plain Newton in equal steps."""
    from benchmarks.felupe_engine import FelupeProblem

    mesh = mesh_body(problem.half(), layers=layers)

    def attempt(steps: int) -> tuple[np.ndarray, int, int]:
        other = FelupeProblem(mesh, problem.materials, GRAVITY)
        iterations = other.raise_load(problem.pressure, steps, TOLERANCE)
        return other.displacement(int(mesh.underside_line[-1])), other.unknowns, iterations

    return first_that_works(attempt)


def first_that_works(attempt: Callable[[int], tuple[np.ndarray, int, int]]) -> Found:
    for steps in STEPS:
        wall, cpu = clock()
        try:
            tip, unknowns, iterations = attempt(steps)
        except (RuntimeError, ValueError) as error:
            print(f"{steps} steps: {error}", file=sys.stderr)
            continue
        done = clock()
        if np.isfinite(tip).all():
            return Found(tip, unknowns, iterations, done[0] - wall, done[1] - cpu, f"{steps} steps")
    raise RuntimeError("no number of steps worked")


def calculix(problem: PeerProblem, layers: Layers) -> Found:
    """The exported deck with C3D20R, its own automatic steps; reading the deck is timed too."""
    from actuators.export.inp import ELEMENTS, deck

    mesh = mesh_body(problem.half(), layers=layers)
    text = deck(mesh, problem.materials, Scene(problem.pressure))
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "model.inp").write_text(text)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        wall = time.perf_counter()
        done = subprocess.run(["ccx", "model"], cwd=folder, capture_output=True, check=False)
        wall = time.perf_counter() - wall
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        rows = Path(folder, "model.dat").read_text().split("\n")
        status = Path(folder, "model.sta").read_text().split("\n")
    if done.returncode != 0 or b"Job finished" not in done.stdout:
        raise RuntimeError("CalculiX gave up")
    last = [row.split() for row in rows if row.strip()][-1]
    iterations = sum(int(row.split()[3]) for row in status[2:] if row.strip())
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    kept = np.unique(mesh.elements[:, ELEMENTS["C3D20R"]])
    held = 3 * np.isin(mesh.clamp_nodes, kept).sum() + np.isin(mesh.symmetry_nodes, kept).sum()
    tip = np.array([float(x) for x in last[1:4]]) * 1e-3
    return Found(tip, 3 * len(kept) - int(held), iterations, wall, cpu, "own steps")


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
        "note": found.note, "threads": os.environ.get("OMP_NUM_THREADS", "all"),
    }))  # fmt: skip


if __name__ == "__main__":
    main()
