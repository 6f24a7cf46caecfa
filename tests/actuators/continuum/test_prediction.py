"""Extrapolation of a path from its last two states."""

import numpy as np

from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.prediction import predict, predict_by_volume
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.meshing import mesh_body
from benchmarks.mini_pneu_net import MATERIALS, mini_pneu_net


def test_states_are_extrapolated_by_what_told_them_apart() -> None:
    mesh = mesh_body(mini_pneu_net().half())
    system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh))
    rest = system.rest()
    moved = rest.moved(1.0, rest)
    moved.displacement[:, 2] = -1e-6 * mesh.nodes[:, 0]
    first = Equilibrium(rest, 1e3, 2e-6, 1, 0)
    further = Equilibrium(moved, 2e3, 3e-6, 1, 0)
    ahead = predict(system, [first, further], 3e3).displacement
    np.testing.assert_allclose(ahead[:, 2], 2 * moved.displacement[:, 2], rtol=1e-4, atol=1e-15)
    # a walk by the volume may meet one pressure twice, one by the pressure one volume
    same = Equilibrium(moved, 1e3, 3e-6, 1, 0)
    assert predict(system, [first, same], 2e3) is moved
    flat = Equilibrium(moved, 2e3, 2e-6, 1, 0)
    assert predict_by_volume(system, [first, flat], 4e-6) == (moved, 2e3)
