"""The shear compliance of a pitch."""

import numpy as np
import pytest

from actuators.design import preset
from actuators.geometry import build_cell
from actuators.geometry.body import Body, Region
from actuators.materials import Material, NeoHooke, material
from actuators.mechanics.cell.periodic import coarse_mesh, solve_cell
from actuators.mechanics.cell.shear import shear_compliance

RUBBER = Material("a", "a", NeoHooke(5e4), 1000.0, "test")


def beam(width: float, pitch: float = 0.01) -> Body:
    """A plain bar, 10 mm high."""
    lines = (
        np.array([0.0, 0.25, 0.75, 1.0]) * pitch,
        np.array([-1.0, 0.0, 1.0]) * width / 2,
        np.linspace(0.0, 0.01, 4),
    )
    fill = np.zeros((3, 2, 3), dtype=np.int8)
    return Body(lines, fill, (Region("a", "a"),), lambda x: x, False, period=pitch)


def test_a_narrow_bar_shears_as_timoshenko_says() -> None:
    """Plane stress: 6/5 of V/(mu A), whatever Poisson's ratio; 1 % for the mesh and the width."""
    body = beam(0.001)
    area = 0.001 * 0.01
    expected = 1.2 / (RUBBER.shear_modulus * area)
    assert shear_compliance(body, (RUBBER,)) == pytest.approx(expected, rel=0.01)


def test_the_pitch_of_a_plain_bar_does_not_matter() -> None:
    short, long = (shear_compliance(beam(0.004, pitch), (RUBBER,)) for pitch in (0.006, 0.012))
    assert short == pytest.approx(long, rel=0.01)


def test_walls_between_chambers_shear_like_a_ladder() -> None:
    """A slab gives way several times as much as its rubber alone would."""
    body = build_cell(preset("slab-rectangle-low").design, 0)
    records = tuple(material(region.material) for region in body.regions)
    solid = sum(m.shear_modulus * h * 0.045 for m, h in zip(records, (0.004, 0.012), strict=False))
    assert 1 / shear_compliance(body, records) < solid / 2
    stiffness = solve_cell(body, records, coarse_mesh(body)).stiffness
    # 3 C_s / (C L^2): a ninth of a tip force's deflection
    share = 3 * shear_compliance(body, records) / np.linalg.inv(stiffness)[2, 2] / 0.089**2
    assert 0.08 < share < 0.15
