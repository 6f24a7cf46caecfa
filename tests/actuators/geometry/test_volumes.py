"""Closed-form volumes against hand calculation and numerical integration."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from scipy.integrate import quad

from actuators.design import ObliqueDesign, SlabDesign, preset
from actuators.geometry.volumes import exact_volumes, masses, slab_planform_area
from tests.actuators.design_space import obliques, slabs


def test_rectangle_by_hand() -> None:
    volumes = exact_volumes(preset("slab-rectangle-low").design)
    assert volumes.bottom == pytest.approx(45e-3 * 89e-3 * 4e-3)
    # six chambers of 80/11 mm by 38 mm, five channel pieces of 80/11 mm by 4 mm, 6 mm high
    assert volumes.cavity == pytest.approx(80e-3 / 11 * (6 * 38e-3 + 5 * 4e-3) * 6e-3)


@settings(max_examples=40, deadline=None, derandomize=True)
@given(slabs())
def test_planform_area_is_the_integral_of_the_width(design: SlabDesign) -> None:
    area, _ = quad(lambda x: 2 * float(design.half_width(x)), 0.0, design.length, epsrel=1e-12)
    assert slab_planform_area(design) == pytest.approx(area, rel=1e-9)


@settings(max_examples=40, deadline=None, derandomize=True)
@given(obliques())
def test_the_angle_does_not_change_volumes(design: ObliqueDesign) -> None:
    straight = design.changed(theta=90)
    assert exact_volumes(design) == exact_volumes(straight)


@pytest.mark.parametrize("name", ["slab-ellipse-high", "oblique-30"])
def test_masses_are_volume_times_density(name: str) -> None:
    from actuators.materials import material

    design = preset(name).design
    bottom, top = masses(design)
    volumes = exact_volumes(design)
    assert bottom == pytest.approx(volumes.bottom * material(design.bottom_material).density)
    assert top == pytest.approx(volumes.top * material(design.top_material).density)
    assert all(math.isfinite(m) and 1e-4 < m < 1 for m in (bottom, top)), "grams, not tonnes"
    assert np.isclose(bottom + top, volumes.rubber * 1e3, rtol=0.2), "silicone is near 1 g/ml"
