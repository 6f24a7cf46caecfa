"""Bodies: lattices that do not fold, outlines that stay, cells that continue one another."""

import numpy as np
import pytest
from hypothesis import given, settings

from actuators.design import PRESETS, Design, SlabDesign, parse_design, preset
from actuators.geometry import CAVITY, build_body, build_cell
from actuators.geometry.derived import derived
from actuators.geometry.surface import body_surface
from tests.actuators.design_space import designs, slabs


def jacobians(design: Design) -> np.ndarray:
    """Determinant of the lattice's map by central differences inside every block."""
    body = build_body(design)
    inside = np.array([0.05, 0.5, 0.95])
    parts = [(x[:-1, None] + np.diff(x)[:, None] * inside).ravel() for x in body.lines]
    grid = np.stack(np.meshgrid(*parts, indexing="ij"), axis=-1)
    columns = []
    for axis in range(3):
        step = np.zeros(3)
        step[axis] = 1e-4 * np.diff(body.lines[axis]).min()
        columns.append((body.place(grid + step) - body.place(grid - step)) / (2 * step[axis]))
    return np.linalg.det(np.stack(columns, axis=-1))


@settings(max_examples=60, deadline=None, derandomize=True)
@given(designs())
def test_no_lattice_folds(design: Design) -> None:
    assert jacobians(design).min() > 0


def test_a_tip_narrower_than_its_side_walls_does_not_fold() -> None:
    """The channel and arms end with the chambers; beyond, the tip may be a point."""
    design = parse_design(
        {"family": "slab", "planform": "triangle", "tip_width_mm": 1, "tip_wall_mm": 50}
    )
    assert jacobians(design).min() > 0


@settings(max_examples=40, deadline=None, derandomize=True)
@given(slabs())
def test_a_slab_is_as_wide_as_its_outline_everywhere(design: SlabDesign) -> None:
    body = build_body(design)
    x = np.linspace(0.0, design.length, 101)
    edge = body.place(np.stack([x, np.full_like(x, 3.0), np.zeros_like(x)], axis=-1))
    np.testing.assert_allclose(edge[:, 1], design.half_width(x), rtol=1e-12)
    arm = body.place(np.stack([x, np.full_like(x, 2.0), np.zeros_like(x)], axis=-1))
    row = (x >= design.root_wall) & (x <= design.length - design.tip_wall)
    wall = design.half_width(x[row]) - arm[row, 1]
    np.testing.assert_allclose(wall, design.side_wall, rtol=1e-9)


@pytest.mark.parametrize("name", PRESETS)
def test_a_half_model_is_half_the_body(name: str) -> None:
    body = build_body(preset(name).design)
    if not body.symmetric:
        with pytest.raises(ValueError, match="symmetric"):
            body.half()
        return
    half, whole = body_surface(body.half(), max_edge=5e-3), body_surface(body, max_edge=5e-3)
    assert 2 * half.volume == pytest.approx(whole.volume, rel=1e-9)


@pytest.mark.parametrize("name", ["slab-rectangle-low", "slab-triangle-high", "oblique-30"])
def test_the_ends_of_a_cell_differ_by_its_period(name: str) -> None:
    cell = build_cell(preset(name).design, 1)
    assert cell.period is not None
    _, y, z = cell.lines
    grid = np.stack(np.meshgrid(cell.lines[0][[0, -1]], y, z, indexing="ij"), axis=-1)
    start, end = cell.place(grid)
    np.testing.assert_allclose(end - start, np.broadcast_to([cell.period, 0, 0], start.shape))
    np.testing.assert_array_equal(cell.fill[0] == CAVITY, cell.fill[-1] == CAVITY)


@pytest.mark.parametrize("name", PRESETS)
def test_what_follows_from_a_design_is_finite_and_positive(name: str) -> None:
    values = derived(preset(name).design)
    assert all(d.value > 0 and np.isfinite(d.value) and d.unit for d in values)
    assert len({d.label for d in values}) == len(values)


def test_the_printed_body_lies_on_its_layer() -> None:
    design = preset("printed-14").design
    (sheet,) = build_body(design).membranes
    assert sheet.plane in build_body(design).lines[2]
    assert sheet.stiffness == pytest.approx(1000 * 12e6 * 0.5e-3, rel=1e-6)
    assert build_body(design).half().membranes == (sheet,)
    assert build_cell(design, 0).membranes == (sheet,)
    assert build_body(design.changed(layer_height=0)).membranes[0].plane == 0.0
    bare = build_body(design.changed(layer="none"))
    assert bare.membranes == ()
    assert len(bare.lines[2]) == len(build_body(design).lines[2]) - 1
