"""Thick sphere under inner pressure, neo-Hooke, incompressible: closed form.

p/mu = 2/lb + 1/(2 lb^4) - 2/la - 1/(2 la^4), with la, lb the stretches at the inner radius A and
the outer radius B: lb^3 - 1 = (la^3 - 1) (A/B)^3. An octant is computed in spherical coordinates:
its three planes pass through the origin, so that the cavity's volume needs no caps.
"""

import numpy as np
import pytest

from actuators.geometry import CAVITY, Body, Region
from actuators.materials import Material, NeoHooke
from actuators.mechanics.continuum.newton import Equilibrium, Target, solve_equilibrium
from actuators.mechanics.continuum.system import ContinuumSystem
from actuators.mechanics.direct_solver import open_solver
from actuators.meshing import mesh_body

INNER, OUTER, MU = 5e-3, 10e-3, 4e4
# reference/fe_benchmarks.csv, A/B = 0.5: inner stretch -> p/mu (the limit lies at 1.8281)
CLOSED_FORM = {1.1: 0.287155, 1.25: 0.551869, 1.5: 0.755433, 1.8281: 0.816424, 2.0: 0.806927}


def octant() -> Body:
    def place(lattice: np.ndarray) -> np.ndarray:
        polar, around, r = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
        return np.stack(
            [r * np.sin(polar) * np.cos(around), r * np.sin(polar) * np.sin(around),
             r * np.cos(polar)], axis=-1,
        )  # fmt: skip

    quarter = np.array([0.0, np.pi / 2])
    return Body(
        (quarter, quarter, np.array([0.0, INNER, OUTER])),
        np.array([[[CAVITY, 0]]], dtype=np.int8), (Region("rubber", "test"),), place, False,
    )  # fmt: skip


def pressures(parts: int) -> dict[float, float]:
    """p/mu at each inner stretch, by prescribing the volume; the limit point is passed."""
    mesh = mesh_body(octant(), uniform=(parts, parts, parts))
    free = np.ones_like(mesh.nodes, dtype=bool)
    flat = np.abs(mesh.nodes) < 1e-12 * OUTER
    free[flat] = False  # on each coordinate plane, nothing moves across it
    rubber = Material("test", "test", NeoHooke(MU), 1000.0, "test", bulk_to_shear=1e6)
    system = ContinuumSystem(mesh, [rubber], free=free)
    solver = open_solver(system.indptr, system.indices)
    state, pressure = system.rest(), 0.0
    volume, _ = system.volume(state)
    found: dict[float, float] = {}
    for stretch in np.unique([*np.arange(1.05, 2.0, 0.05), *CLOSED_FORM]):
        result = solve_equilibrium(
            system, solver, state, Target(pressure, volume=volume * stretch**3), tolerance=1e-9
        )
        assert isinstance(result, Equilibrium)
        state, pressure = result.state, result.pressure
        found[float(stretch)] = pressure / MU
    return {stretch: found[stretch] for stretch in CLOSED_FORM}


def test_inflated_sphere_follows_its_closed_form_past_the_limit_point() -> None:
    found = pressures(4)
    assert found == pytest.approx(CLOSED_FORM, rel=2e-3)
    assert found[2.0] < found[1.8281] > found[1.5]


def test_pressure_converges_with_the_order_of_the_energy() -> None:
    errors = [abs(pressures(n)[1.5] - CLOSED_FORM[1.5]) for n in (2, 4)]
    # quadratic displacement: the pressure, conjugate to the volume, converges with order 4
    assert np.log2(errors[0] / errors[1]) > 3.0
