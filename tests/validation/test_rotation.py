"""Nothing depends on where a body points: a state turned by 90 degrees, an actuator so built."""

import dataclasses

import numpy as np
import pytest

from actuators.materials import MooneyRivlin, NeoHooke
from actuators.mechanics.continuum.newton import Equilibrium, Target, solve_equilibrium
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.system import ContinuumSystem, State, clamped
from actuators.mechanics.direct_solver import open_solver
from actuators.meshing import HexMesh, mesh_body
from benchmarks.mini_pneu_net import MATERIALS, mini_pneu_net
from tests.actuators.continuum.boxes import block, rubber, skewed

PRESSURE = 4e3
WEIGHT = np.array([0.0, 0.0, -9.81])
QUARTER = {
    "X1": np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]]),
    "X2": np.array([[0, 0, 1.0], [0, 1.0, 0], [-1.0, 0, 0]]),
    "X3": np.array([[0, -1.0, 0], [1.0, 0, 0], [0, 0, 1.0]]),
}


@pytest.mark.parametrize("axis", QUARTER)
@pytest.mark.parametrize("law", [NeoHooke(4e4), MooneyRivlin(1.5e4, 0.5e4)], ids=["NH", "MR"])
def test_state_in_balance_stays_in_balance_when_it_turns(law, axis: str) -> None:
    """Inflated, held at one side, then turned as a whole: the forces turn with it."""
    mesh = mesh_body(block(skewed))
    system = ContinuumSystem(mesh, [rubber(law)], free=clamped(mesh))
    solver = open_solver(system.indptr, system.indices)
    found = solve_equilibrium(system, solver, system.rest(), Target(PRESSURE), tolerance=1e-10)
    assert isinstance(found, Equilibrium)
    before = system.balance(found.state, PRESSURE)
    turn, shift = QUARTER[axis], np.array([0.01, -0.02, 0.03])
    at = (mesh.nodes + found.state.displacement) @ turn.T + shift
    turned = State(at - mesh.nodes, found.state.pressure)
    after = system.balance(turned, PRESSURE)
    scale = np.abs(before.residual).max()
    assert scale > 1e-3  # the clamp's reactions
    assert after.residual == pytest.approx(before.residual @ turn.T, abs=1e-9 * scale)
    free = np.setdiff1d(np.arange(len(mesh.nodes)), mesh.clamp_nodes)
    assert np.abs(after.residual[free]).max() < 1e-6 * scale
    assert system.volume(turned)[0] == pytest.approx(found.volume, rel=1e-12)


def tip(mesh: HexMesh, gravity: np.ndarray) -> np.ndarray:
    g = (float(gravity[0]), float(gravity[1]), float(gravity[2]))
    system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh), gravity=g)
    solver = open_solver(system.indptr, system.indices)
    path = PathFollower(system, solver, tolerance=1e-9).follow(6e3, [6e3])
    return path.points[-1].state.displacement[mesh.underside_line[-1]]


@pytest.fixture(scope="module")
def upright() -> tuple[HexMesh, np.ndarray]:
    mesh = mesh_body(mini_pneu_net())
    return mesh, tip(mesh, WEIGHT)


@pytest.mark.parametrize("axis", QUARTER)
def test_actuator_built_in_another_direction_answers_in_that_direction(
    axis: str, upright: tuple[HexMesh, np.ndarray]
) -> None:
    mesh, expected = upright
    turn = QUARTER[axis]
    turned = dataclasses.replace(mesh, nodes=mesh.nodes @ turn.T)
    assert tip(turned, turn @ WEIGHT) == pytest.approx(
        turn @ expected, abs=1e-6 * float(np.linalg.norm(expected))
    )
