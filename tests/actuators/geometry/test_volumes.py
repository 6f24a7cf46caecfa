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


def test_printed_blocks_by_hand() -> None:
    volumes = exact_volumes(preset("printed-14").design)
    assert volumes.bottom == pytest.approx(103e-3 * 17e-3 * 2.5e-3)
    # 14 chambers of 3.5 x 13.8 x 11 mm; 13 pieces of channel, 3.4 x 3 x 1.5 mm
    assert volumes.cavity == pytest.approx(14 * 3.5e-3 * 13.8e-3 * 11e-3 + 13 * 3.4e-3 * 4.5e-6)
    envelope = 103e-3 * 17e-3 * 15e-3
    gaps = 14 * 1e-3 * 17e-3 * 10e-3  # half ones at either end
    assert volumes.rubber + volumes.cavity == pytest.approx(envelope - gaps)
