"""Chambers in a row: shared cells, interpolated widths, mass."""

from typing import cast

import numpy as np
import pytest

from actuators.design import SlabDesign, preset
from actuators.geometry import build_cell
from actuators.geometry.volumes import masses
from actuators.mechanics.cell.cache import cell_response
from actuators.mechanics.cell.row import chamber_row


def test_what_does_not_enter_the_cell_asks_for_no_new_one() -> None:
    design = preset("oblique-60").design
    first = cell_response(build_cell(design, 0))
    longer = design.changed(length=180, chamber_count=20, inlet_height=3)
    assert cell_response(build_cell(longer, 3)) is first
    assert cell_response(build_cell(design.changed(roof_thickness=2.1), 0)) is not first


def test_a_softer_material_is_a_new_cell() -> None:
    design = preset("oblique-60").design
    soft = design.changed(top_material="ecoflex-00-30")
    first, second = (cell_response(build_cell(d, 0)) for d in (design, soft))
    assert second.free[2] > first.free[2]


@pytest.mark.parametrize("name", ["slab-triangle-high", "slab-ellipse-high"])
def test_interpolated_widths_answer_as_cells_of_their_own(name: str) -> None:
    design = cast(SlabDesign, preset(name).design)
    row = chamber_row(design)
    for index in (0, design.chamber_count // 2, design.chamber_count - 2):
        own = cell_response(build_cell(design, index))
        np.testing.assert_allclose(row.free[index, [0, 2]], own.free[[0, 2]], rtol=5e-3)
        np.testing.assert_allclose(np.diag(row.stiffness[index]), np.diag(own.stiffness), rtol=1e-3)


def test_the_rows_mass_and_its_ends_are_the_bodys() -> None:
    design = cast(SlabDesign, preset("slab-rectangle-low").design)
    row = chamber_row(design)
    total = sum(masses(design))
    ends = (design.length - design.chamber_count * design.pitch) * design.width
    solid = design.bottom_thickness * 1130 + (design.height - design.bottom_thickness) * 1070
    # half a channel's length of air at either end of the row is counted as air but is solid
    channel = design.wall_length * design.channel_width * design.chamber_height * 1070
    assert row.line_mass.sum() * row.pitch + ends * solid + channel == pytest.approx(
        total, rel=1e-9
    )


def test_cavity_of_the_row_is_the_designs() -> None:
    from actuators.geometry.volumes import exact_volumes

    design = preset("oblique-45").design.changed(channel_width=0)
    assert chamber_row(design).cavity_volume.sum() == pytest.approx(
        exact_volumes(design).cavity, rel=1e-9
    )
