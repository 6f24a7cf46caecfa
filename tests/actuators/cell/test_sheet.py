"""Embedded sheets in the periodic cell."""

import dataclasses

import numpy as np
import pytest

from actuators.design import preset
from actuators.geometry import Body, Membrane, Region, build_cell
from actuators.materials import material
from actuators.mechanics.cell.cache import cell_response
from actuators.mechanics.cell.periodic import CellMesh, solve_cell
from actuators.mechanics.cell.sheet import sheet_stiffness
from actuators.mechanics.rod.section import layered_section, sheet_section

ONE = material("elastosil-m4601")


def bar(plane: float, stiffness: float) -> Body:
    """A solid bar of 12 x 7 mm with a sheet, its lattice that of a cell."""
    x = np.array([0.0, 0.002, 0.006, 0.008])
    y = np.array([-0.006, 0.0, 0.006])
    z = np.array([0.0, 0.004, 0.007])
    regions = (Region("all", "elastosil-m4601"),)
    sheets = (Membrane("sheet", plane, stiffness),)
    fill = np.zeros((3, 2, 2), dtype=np.int8)
    return Body((x, y, z), fill, regions, lambda p: np.asarray(p, dtype=float), True, 0.008, sheets)


@pytest.mark.parametrize("plane", [0.0, 0.004, 0.007])
def test_a_bar_with_a_sheet_is_a_beam_with_a_sheet(plane: float) -> None:
    fine = ((1, 1), (2,), (3, 3))
    found = solve_cell(bar(plane, 2e3), (ONE,), CellMesh(fine, fine)).stiffness
    section = sheet_section(0.012, 2e3, plane) + layered_section(
        0.012, np.array([0.007]), np.array([ONE.youngs_modulus]), np.array([ONE.shear_modulus])
    )
    for i, j in ((0, 0), (0, 2), (2, 2), (3, 3)):
        assert found[i, j] == pytest.approx(section[i, j], rel=2e-3)


def test_only_stretch_along_the_axis_costs_energy() -> None:
    """On a skew parallelogram: a uniform du1/dX1, any du1/dX2."""
    corner = np.stack(np.meshgrid(np.arange(3.0), np.arange(3.0)), axis=-1).reshape(9, 2)
    face = np.column_stack([corner[:, 0] + 0.6 * corner[:, 1], corner[:, 1], np.full(9, 4.0)])
    matrix = sheet_stiffness(face[None], np.array([5.0]))[0]
    stretched, sheared = 0.1 * face[:, 0], 0.1 * face[:, 1]
    assert stretched @ matrix @ stretched == pytest.approx(5.0 * 0.01 * 4.0)
    assert np.abs(matrix @ sheared).max() < 1e-12


def test_the_layer_keeps_its_length_and_the_cell_bends_about_it() -> None:
    design = preset("printed-14").design
    held = cell_response(build_cell(design, 0))
    loose = cell_response(build_cell(design.changed(layer="none"), 0))
    at_layer = held.free[0] + 0.75e-3 * held.free[2]
    assert abs(at_layer) < 1e-2 * held.free[2] * 0.75e-3
    assert 0.5 * loose.free[2] < held.free[2] < loose.free[2]


def test_a_stiffer_sheet_is_another_cell() -> None:
    cell = build_cell(preset("printed-14").design, 0)
    (sheet,) = cell.membranes
    softer = dataclasses.replace(cell, membranes=(dataclasses.replace(sheet, stiffness=1e3),))
    assert cell_response(softer) is not cell_response(cell)
    assert cell_response(build_cell(preset("printed-14").design, 3)) is cell_response(cell)
