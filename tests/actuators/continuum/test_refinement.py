"""A path carried to a finer mesh."""

import pytest

from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.refinement import Anchor, Refinement
from actuators.mechanics.continuum.system import ContinuumSystem, State, clamped
from actuators.mechanics.direct_solver import SymmetricSolver, open_solver
from actuators.meshing import mesh_body
from benchmarks.mini_pneu_net import GRAVITY, MATERIALS, PRESSURE, mini_pneu_net


def open_layers(layers: tuple[int, int, int]) -> tuple[ContinuumSystem, SymmetricSolver]:
    mesh = mesh_body(mini_pneu_net().half(), layers=layers)
    system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh), gravity=GRAVITY)
    return system, open_solver(system.indptr, system.indices)


class NothingFromCoarseStates(Refinement):
    """Where walls press on each other: no point but the first is found from the coarse one."""

    def _at(self, index: int, start: State) -> Equilibrium | None:
        return super()._at(index, start) if index == 0 else None


def test_a_finer_mesh_takes_its_own_steps_where_no_shared_point_can_be_started_from() -> None:
    system, solver = open_layers((0, 0, 0))
    path = PathFollower(system, solver).follow(PRESSURE, (0.5 * PRESSURE, PRESSURE))
    at = Anchor(system, path.points[-1])
    fine, solver = open_layers((1, 0, 0))
    usual = Refinement(system, fine, solver, path).anchor(at)
    assert usual is not None
    refinement = NothingFromCoarseStates(system, fine, solver, path)
    own = refinement.anchor(at)
    assert own is not None
    assert refinement.shared == len(path.points)
    assert own.found.pressure == usual.found.pressure
    assert own.found.volume == pytest.approx(usual.found.volume, rel=1e-5)
