"""Everything that acts has a potential: the work of all forces round a closed loop is nothing.

Elastic forces, incompressibility, cavity pressure, weight, embedded sheets, a plate and the body
against itself, at once. Unlike a comparison of tangent and residual, this would also find a force
that is wrong in both.
"""

import dataclasses

import numpy as np
import pytest

from actuators.geometry import Membrane
from actuators.materials import MooneyRivlin
from actuators.mechanics.continuum.contact import Obstacle, SelfContact, contact_law, outside
from actuators.mechanics.continuum.contact.points import WALL_POINTS
from actuators.mechanics.continuum.system import ContinuumSystem, State, clamped
from actuators.mechanics.obstacles import Plate
from actuators.meshing import mesh_body
from tests.actuators.contact.pressed import two_blocks
from tests.actuators.continuum.boxes import block, rubber, skewed

LAW = MooneyRivlin(1.5e4, 0.5e4)
MU = LAW.initial_shear_modulus
SMALL = 2e-5
"""Size of the loop [m]."""


def round_a_loop(system: ContinuumSystem, base: State, pressure: float) -> tuple[float, float]:
    """Work round a triangle of states about ``base``, and the sum of its parts' sizes [J]."""
    rng = np.random.default_rng(5)
    corners = [
        State(base.displacement + SMALL * rng.standard_normal(base.displacement.shape),
              base.pressure + 0.1 * MU * rng.standard_normal(base.pressure.shape), base.sheet)
        for _ in range(3)
    ]  # fmt: skip
    points, weights = np.polynomial.legendre.leggauss(24)
    total = size = 0.0
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        moved = end.displacement - start.displacement
        squeezed = end.pressure - start.pressure
        work = 0.0
        for point, weight in zip((1 + points) / 2, weights / 2, strict=True):
            at = State(start.displacement + point * moved, start.pressure + point * squeezed,
                       base.sheet)  # fmt: skip
            found = system.balance(at, pressure)
            assert found.admissible
            work += weight * float((found.residual * moved).sum() + (found.inner * squeezed).sum())
        total += work
        size += abs(work)
    return total, size


def test_pressure_weight_sheets_and_a_plate_do_no_work_round_a_loop() -> None:
    sheets = (Membrane("lower", 4e-3, 0.05 * MU), Membrane("upper", 8e-3, 0.1 * MU))
    mesh = mesh_body(dataclasses.replace(block(skewed), membranes=sheets))
    material = rubber(LAW)
    plate = Obstacle(outside(mesh), contact_law(mesh, [material]), Plate(0.1e-3))
    system = ContinuumSystem(
        mesh, [material], free=clamped(mesh), gravity=(1.0, 2.0, -9.0), interactions=[plate]
    )
    lowered = np.zeros_like(mesh.nodes) + np.array([0.0, 0.0, -0.3e-3])
    base = dataclasses.replace(system.rest(), displacement=lowered)
    if len(base.sheet):
        base = dataclasses.replace(base, sheet=base.sheet + 0.01 * MU * 4e-3)
    assert np.linalg.norm(plate.force(mesh.nodes + lowered)) > 1e-3
    total, size = round_a_loop(system, base, 0.1 * MU)
    assert abs(total) < 1e-6 * size


def test_surfaces_of_the_body_do_no_work_on_each_other_round_a_loop() -> None:
    mesh = mesh_body(two_blocks(0.2e-3), uniform=(2, 2, 1))
    material = rubber(LAW)
    contact = SelfContact(
        outside(mesh, WALL_POINTS), contact_law(mesh, [material]), float(np.ptp(mesh.nodes[:, 2]))
    )
    free = np.ones_like(mesh.nodes, dtype=bool)
    system = ContinuumSystem(mesh, [material], free=free, interactions=[contact])
    lowered = np.zeros_like(mesh.nodes)
    lowered[mesh.nodes[:, 2] > 5.1e-3, 2] = -0.4e-3
    base = dataclasses.replace(system.rest(), displacement=lowered)
    bare = ContinuumSystem(mesh, [material], free=free)
    pushed = system.balance(base, 0.0).residual - bare.balance(base, 0.0).residual
    assert np.abs(pushed).sum() > 1e-2
    total, size = round_a_loop(system, base, 0.0)
    assert total == pytest.approx(0.0, abs=1e-6 * size)
