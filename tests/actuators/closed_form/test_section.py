"""The equivalent section: a hand calculation, and what it does not claim."""

import numpy as np
import pytest

from actuators.design import SlabDesign, preset
from actuators.mechanics.closed_form import bending_rates
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene


def test_one_rubber_is_the_hand_calculation() -> None:
    """Box section by subtraction: outer 40 x 16, chamber 30 x 6 with its middle at 7 mm."""
    design = SlabDesign().changed(
        width=40, side_wall=5, bottom_thickness=4, chamber_height=6, roof_thickness=6,
        bottom_material="elastosil-m4601", top_material="elastosil-m4601",
    )  # fmt: skip
    outer, hole = 40 * 16, 30 * 6
    area = outer - hole
    neutral = (outer * 8 - hole * 7) / area
    inertia = 40 * 16**3 / 12 + outer * (8 - neutral) ** 2
    inertia -= 30 * 6**3 / 12 + hole * (7 - neutral) ** 2
    youngs = 483.5e3
    expected = hole * 1e-6 * (7 - neutral) * 1e-3 / (youngs * inertia * 1e-12) / 2  # half chamber
    # the bulk modulus of the record makes E differ from 483.5 kPa by 3e-4
    np.testing.assert_allclose(bending_rates(design), expected, rtol=1e-3)


def test_tapered_slabs_bend_chamber_by_chamber() -> None:
    rates = bending_rates(preset("slab-triangle-high").design)
    assert len(np.unique(rates)) == len(rates)


def test_a_slab_is_within_a_factor_of_two_of_its_cells() -> None:
    design = preset("slab-rectangle-low").design
    scene = Scene(10e3, gravity=None)
    closed, cell = (
        predict(design, scene, rung=rung).path[-1].curvature for rung in ("closed-form", "energy")
    )
    assert closed is not None
    assert cell is not None
    assert closed == pytest.approx(cell, rel=0.5)


def test_a_gapped_bar_bends_far_more_than_its_section_says() -> None:
    """What bends it is the bulging of its walls, which no section holds."""
    design = preset("oblique-90").design
    scene = Scene(10e3, gravity=None)
    closed, cell = (
        predict(design, scene, rung=rung).path[-1].curvature for rung in ("closed-form", "energy")
    )
    assert closed is not None
    assert cell is not None
    assert cell > 10 * closed > 0
