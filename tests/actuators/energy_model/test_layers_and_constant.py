"""Layers hold the volumes of the chamber they stand for; c is computed, published or refused."""

import numpy as np
import pytest

from actuators.design import Design, preset
from actuators.errors import QuestionError
from actuators.geometry import build_cell
from actuators.mechanics.cell.periodic import volumes_of
from actuators.mechanics.energy_model import (
    check_constant,
    computed_constant,
    design_layers,
    published_constant,
    rod_strains,
)


@pytest.mark.parametrize(
    "name", ["slab-rectangle-low", "slab-ellipse-high", "oblique-45", "printed-14"]
)
def test_layers_hold_the_rubber_and_air_of_the_chamber(name: str) -> None:
    design: Design = preset(name).design
    if name.startswith(("oblique", "printed")):
        design = design.changed(channel_width=0)  # the layers leave the channel out
    layers = design_layers(design)
    rubber, air = volumes_of(build_cell(design, 2))
    thickness = np.diff(layers.height[2])
    assert (layers.rubber[2] * thickness).sum() == pytest.approx(rubber, rel=1e-12)
    assert (layers.air[2] * thickness).sum() == pytest.approx(air, rel=1e-12)


@pytest.mark.parametrize(("theta", "c"), [(15, 0.12), (30, 1), (45, 2.72), (60, 3), (90, 5)])
def test_published_constant_is_the_papers_table_2(theta: int, c: float) -> None:
    assert published_constant(preset(f"oblique-{theta}").design) == pytest.approx(c)


def test_published_constant_lies_between_the_rows_between_the_angles() -> None:
    design = preset("oblique-90").design.changed(theta=82.5)
    assert published_constant(design) == pytest.approx(4.5)


def test_no_published_constant_for_a_slab_says_what_to_do() -> None:
    with pytest.raises(QuestionError, match="oblique family only") as caught:
        published_constant(preset("slab-rectangle-low").design)
    assert caught.value.field == "c"
    assert caught.value.mend


@pytest.mark.parametrize("bad", ["fitted", -1, 0, float("nan"), float("inf"), True, None, 1e9])
def test_a_constant_that_is_none_is_refused(bad: object) -> None:
    with pytest.raises(QuestionError):
        check_constant(bad)


def test_computed_constant_is_the_ratio_of_curvatures_where_nothing_twists() -> None:
    energy = rod_strains(design_layers(preset("oblique-90").design))
    cell = np.array([0.3, 0.0, 7.0, 0.0]) * energy[0, 2]
    assert computed_constant(np.tile(cell, (len(energy), 1)), energy) == pytest.approx(7.0)


def test_computed_constant_stays_finite_where_the_bending_vanishes() -> None:
    theta = float(np.degrees(np.arctan(1 / np.sqrt(2))))
    energy = rod_strains(
        design_layers(preset("oblique-45").design.changed(theta=theta, length=120))
    )
    assert computed_constant(3 * energy, energy) == pytest.approx(3.0)
