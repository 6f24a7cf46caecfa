"""Curved elements: the closed form where they are straight, exact modes where they are not."""

import numpy as np
import pytest

from actuators.design import BellowsDesign, preset
from actuators.geometry import build_cell
from actuators.materials import material
from actuators.mechanics.cell import curved, element
from actuators.mechanics.cell.cache import cell_response
from actuators.mechanics.cell.lattice import half_cell
from actuators.mechanics.cell.periodic import CellMesh, box_moments, solve_cell
from tests.actuators.cell.test_element import BULK, JACOBIAN, SHEAR, local_nodes


def bent() -> np.ndarray:
    """A twelfth of a thick ring, sheared: (27, 3)."""
    at = local_nodes()
    angle, radius = 0.25 * at[:, 0], 2.0 + 0.6 * at[:, 2]
    return np.column_stack(
        [radius * np.sin(angle), at[:, 1] + 0.2 * at[:, 0], radius * np.cos(angle)]
    )


def test_a_straight_element_is_the_closed_form() -> None:
    position = (local_nodes() @ JACOBIAN.T)[None]
    found = curved.stiffness(position, np.array([SHEAR]), np.array([BULK]))
    exact = element.stiffness(JACOBIAN[None], np.array([SHEAR]), np.array([BULK]))
    np.testing.assert_allclose(found, exact, atol=1e-12 * np.abs(exact).max())
    np.testing.assert_allclose(
        curved.divergence(position), element.divergence(JACOBIAN[None]), atol=1e-12
    )


def test_rigid_motion_costs_nothing_and_uniform_strain_its_energy() -> None:
    x = bent()
    matrix = curved.stiffness(x[None], np.array([SHEAR]), np.array([BULK]))[0]
    for motion in (np.tile([1.0, -2.0, 0.5], 27), np.cross([0.3, -0.2, 0.9], x).ravel()):
        assert np.abs(matrix @ motion).max() < 1e-12 * np.abs(matrix).max() * np.abs(motion).max()
    strain = np.random.default_rng(5).normal(size=(3, 3))
    strain = strain + strain.T
    _, volume = curved.gradients(x[None])
    deviator = strain - np.eye(3) * np.trace(strain) / 3
    density = SHEAR * (deviator**2).sum() + BULK * np.trace(strain) ** 2 / 2
    u = (x @ strain.T).ravel()
    assert u @ matrix @ u / 2 == pytest.approx(density * volume.sum(), rel=1e-12)


def test_largest_strain_is_that_of_a_uniform_one() -> None:
    x = bent()
    strain = np.diag([0.02, -0.01, -0.01])
    assert curved.largest_strain(x[None], (x @ strain).ravel()[None]) == pytest.approx(0.02)


def test_a_bellows_cell_holds_its_areas() -> None:
    design = preset("bellows-11-2.0").design
    assert isinstance(design, BellowsDesign)
    body = build_cell(design, 0)
    top = np.array(design.height)
    air = float(design.wave.air_below(top)) * design.inner_width
    whole = float(design.wave.body_below(top)) * design.width
    moments = box_moments(body)
    assert moments[body.fill < 0].sum(axis=0)[0] == pytest.approx(air, rel=1e-4)
    assert moments[body.fill >= 0].sum(axis=0)[0] == pytest.approx(whole - air, rel=1e-4)
    assert cell_response(body).cavity_volume == pytest.approx(air, rel=5e-3)


def test_a_bellows_cell_keeps_its_valleys_round() -> None:
    """Nothing is merged across the period: an element ends in the middle of every valley."""
    body = build_cell(preset("bellows-11-2.0").design, 0)
    ones = [[[1.0]] * (len(line) - 1) for line in (body.lines[0], body.lines[1][2:], body.lines[2])]
    cell = half_cell(body, ones)
    assert cell.turn == 6
    left = cell.coordinates()[0, 0, 0]
    assert left == pytest.approx(-body.lines[0][-1] / 2)


def test_a_bellows_bends_towards_its_bottom_and_does_not_twist() -> None:
    found = cell_response(build_cell(preset("bellows-9-2.4").design, 0))
    assert found.free[2] > 0
    assert abs(found.free[1]) < 1e-6 * found.free[2]
    scale = np.sqrt(np.outer(np.diag(found.stiffness), np.diag(found.stiffness)))
    assert np.linalg.eigvalsh(found.stiffness / scale).min() > 0
    assert found.cavity_compliance > 0


@pytest.mark.slow
@pytest.mark.parametrize("name", ["bellows-9-1.6", "bellows-11-2.0", "bellows-13-2.4"])
def test_coarse_mesh_is_within_4_percent_of_a_fine_one(name: str) -> None:
    """Bending stiffness is what converges slowest; the bend itself is within 2 %."""
    body = build_cell(preset(name).design, 0)
    records = tuple(material(r.material) for r in body.regions)
    fine = ((2, 3, 2, 2, 3, 2), (3, 2), (2, 2, 2, 2))
    coarse, reference = cell_response(body), solve_cell(body, records, CellMesh(fine, fine))
    assert coarse.free[2] == pytest.approx(reference.free[2], rel=0.02)
    np.testing.assert_allclose(np.diag(coarse.stiffness), np.diag(reference.stiffness), rtol=0.04)
