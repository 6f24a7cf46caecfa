"""Small bodies that the contact tests press against something."""

from collections.abc import Callable, Sequence

import numpy as np

from actuators.geometry import Body, Region
from actuators.geometry.body import OUTSIDE
from actuators.materials import Material, NeoHooke
from actuators.mechanics.continuum.contact import Interaction
from actuators.mechanics.continuum.newton import Equilibrium, Target, solve_equilibrium
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.mechanics.direct_solver import open_solver
from actuators.meshing import HexMesh

MU = 1e5
RUBBER = Material("test", "test", NeoHooke(MU), 1000.0, "test")
Place = Callable[[np.ndarray], np.ndarray]


def straight(lattice: np.ndarray) -> np.ndarray:
    return np.array(lattice, dtype=float)


def box(size: Sequence[float], place: Place = straight) -> Body:
    """A solid block of ``size`` [m], its middle at X2 = 0."""
    lines = [np.array([0.0, length]) for length in size]
    fill = np.zeros((1, 1, 1), np.int8)
    return Body(
        (lines[0], lines[1] - size[1] / 2, lines[2]), fill, (Region("a", "a"),), place, False
    )


def two_blocks(gap: float, place: Place = straight) -> Body:
    """Two blocks of 10 x 10 x 5 mm above each other, ``gap`` [m] apart."""
    side, height = np.array([0.0, 10e-3]), np.array([0.0, 5e-3, 5e-3 + gap, 10e-3 + gap])
    fill = np.array([0, OUTSIDE, 0], np.int8).reshape(1, 1, 3)
    return Body((side, side - 5e-3, height), fill, (Region("a", "a"),), place, False)


def press(
    mesh: HexMesh, free: np.ndarray, moved: np.ndarray, contacts: Sequence[Interaction],
    steps: int = 1,
) -> tuple[ContinuumSystem, State]:  # fmt: skip
    """Equilibrium with the displacements ``moved`` (n, 3) of the nodes that are not ``free``,
    reached in steps."""
    system = ContinuumSystem(mesh, [RUBBER], free=free, interactions=contacts)
    solver = open_solver(system.indptr, system.indices)
    state = system.rest()
    for step in range(1, steps + 1):
        start = np.where(free, state.displacement, moved * step / steps)
        found = solve_equilibrium(
            system, solver, State(start, state.pressure), Target(0.0), tolerance=1e-8,
            most_iterations=30,
        )  # fmt: skip
        assert isinstance(found, Equilibrium), found
        state = found.state
    return system, state


def reaction(system: ContinuumSystem, state: State, held: np.ndarray) -> np.ndarray:
    """(3,) force [N] on the body at the nodes ``held``."""
    return system.balance(state, 0.0).residual[held].sum(axis=0)
