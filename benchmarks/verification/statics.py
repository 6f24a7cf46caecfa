"""What the problems share: dead loads, a ramp, reactions, materials."""

from collections.abc import Callable, Sequence

import numpy as np

from actuators.geometry import Body, Region
from actuators.materials import HyperelasticLaw, Material
from actuators.mechanics.continuum.newton import Equilibrium, Target, solve_equilibrium
from actuators.mechanics.continuum.outer_loads import OuterLoads
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.mechanics.direct_solver import SymmetricSolver, open_solver

INCOMPRESSIBLE = 1e6
"""kappa/mu that stands for an incompressible solid: volumes are kept to one part in 10^6."""
TOLERANCE = 1e-9
"""Largest correction over the body's size."""


def dead_load(forces: np.ndarray) -> OuterLoads:
    """Nodal forces (n, 3) [N] that keep their direction."""
    return OuterLoads(forces, np.empty((0, 9), dtype=np.int32), 0.0)


def rubber(law: HyperelasticLaw, *, bulk_to_shear: float = INCOMPRESSIBLE) -> Material:
    return Material("test", "test", law, 1000.0, "test", bulk_to_shear=bulk_to_shear)


def solid_block(
    size: tuple[float, float, float], place: Callable[[np.ndarray], np.ndarray] | None = None
) -> Body:
    """One box of this size at the origin, mapped by ``place``."""
    return Body(
        (np.array([0.0, size[0]]), np.array([0.0, size[1]]), np.array([0.0, size[2]])),
        np.zeros((1, 1, 1), dtype=np.int8), (Region("rubber", "test"),),
        place or (lambda lattice: np.array(lattice, dtype=float)), False,
    )  # fmt: skip


def solver_of(system: ContinuumSystem) -> SymmetricSolver:
    return open_solver(system.indptr, system.indices)


def solved(
    system: ContinuumSystem, solver: SymmetricSolver, start: State, target: Target
) -> Equilibrium:
    """The equilibrium near ``start``, to the last digits; RuntimeError where there is none."""
    found = solve_equilibrium(
        system, solver, start, target, tolerance=TOLERANCE, most_iterations=30
    )  # fmt: skip
    if not isinstance(found, Equilibrium):
        raise RuntimeError(found.reason)
    return found


def ramp(system: ContinuumSystem, solver: SymmetricSolver, shares: Sequence[float]) -> list[State]:
    """States under these shares of the system's loads, one after the other from rest."""
    done = [(0.0, system.rest())]
    found: list[State] = []
    for share in shares:
        while done[-1][0] < share:
            done.append(_next(system, solver, done, float(share)))
        found.append(done[-1][1])
    return found


def _next(
    system: ContinuumSystem, solver: SymmetricSolver, done: list[tuple[float, State]], share: float
) -> tuple[float, State]:
    """The state at ``share``, or at the half, quarter, ... of the way where that fails."""
    last, start = done[-1]
    for halving in range(12):
        goal = last + (share - last) / 2**halving
        guess = start
        if len(done) > 1:
            before, older = done[-2]
            guess = start.moved((goal - last) / (last - before), start.moved(-1.0, older))
        result = solve_equilibrium(
            system, solver, guess, Target(0.0, loads=goal), tolerance=TOLERANCE, most_iterations=30
        )
        if isinstance(result, Equilibrium):
            return goal, result.state
    raise RuntimeError(f"no equilibrium beyond a share of {last:g}")


def simpson_weights(mesh_index: np.ndarray, lines: np.ndarray) -> np.ndarray:
    """Integral of each quadratic shape function along ``lines``; ``mesh_index`` (k,) counts lines
    and the middles between them."""
    weights = np.zeros(2 * len(lines) - 1)
    for first, width in enumerate(np.diff(lines)):
        weights[2 * first : 2 * first + 3] += width * np.array([1.0, 4.0, 1.0]) / 6.0
    return weights[mesh_index]
