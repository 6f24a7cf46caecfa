"""Slab design to body (S, Fig. 3): layers of planar outlines, stacked."""

from collections.abc import Callable

import numpy as np

from actuators.design.slab import SlabDesign
from actuators.geometry.body import CAVITY, Body, Region

BOTTOM, TOP = 0, 1


def slab_body(design: SlabDesign) -> Body:
    """Whole slab. Lattice: x' = X1; y' in -3..3 counts the borders across (1: channel, 2: end of
    the arms, 3: outline), which bend with the planform; z' = X3."""
    starts = design.chamber_starts()
    ends = starts + design.chamber_length
    x_lines = np.concatenate([[0.0], np.stack([starts, ends], axis=-1).ravel(), [design.length]])
    is_chamber = np.zeros(len(x_lines) - 1, dtype=bool)
    is_chamber[1:-1:2] = True
    in_row = np.ones_like(is_chamber)
    in_row[[0, -1]] = False

    def half_width(x: np.ndarray) -> np.ndarray:
        return design.half_width(x)

    return _stack(design, x_lines, is_chamber, in_row, half_width, period=None)


def slab_cell(design: SlabDesign, index: int) -> Body:
    """One pitch around chamber ``index`` (half a wall on either side), made prismatic: the planform
    keeps the width it has at the chamber's middle, so that tapered bodies are taken chamber by
    chamber."""
    middle = float(design.chamber_starts()[index]) + design.chamber_length / 2
    width = float(design.half_width(middle))
    wall = design.wall_length / 2
    x_lines = np.array([0.0, wall, wall + design.chamber_length, design.pitch])

    def half_width(x: np.ndarray) -> np.ndarray:
        return np.full_like(np.asarray(x, dtype=float), width)

    chambers = np.array([False, True, False])
    return _stack(design, x_lines, chambers, np.ones(3, bool), half_width, period=design.pitch)


def _stack(
    design: SlabDesign,
    x_lines: np.ndarray,
    is_chamber: np.ndarray,
    in_row: np.ndarray,
    half_width: Callable[[np.ndarray], np.ndarray],
    *,
    period: float | None,
) -> Body:
    y_lines = np.array([-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0])
    z_lines = np.cumsum(
        [0.0, design.bottom_thickness, design.chamber_height, design.roof_thickness]
    )
    fill = np.full((len(x_lines) - 1, 6, 3), TOP, dtype=np.int8)
    fill[:, :, 0] = BOTTOM
    fill[is_chamber, 1:5, 1] = CAVITY
    fill[in_row, 2:4, 1] = CAVITY
    channel = design.channel_width / 2
    side_wall = design.side_wall
    row = x_lines[:-1][in_row][0], x_lines[1:][in_row][-1]

    def place(lattice: np.ndarray) -> np.ndarray:
        x, y, z = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
        in_reach = np.clip(x, *row)
        outline = half_width(in_reach)
        arm = outline - side_wall
        a = np.abs(y)
        across = np.where(
            a <= 1.0,
            a * channel,
            np.where(a <= 2.0, channel + (a - 1.0) * (arm - channel), arm + (a - 2.0) * side_wall),
        )
        # beyond the chambers the borders narrow with the outline: a tip narrower than its two side
        # walls would fold the lattice over
        across = across * (half_width(x) / outline)
        return np.stack([x, np.sign(y) * across, z], axis=-1)

    return Body(
        lines=(x_lines, y_lines, z_lines),
        fill=fill,
        regions=(
            Region("bottom layer", design.bottom_material),
            Region("top layer", design.top_material),
        ),
        place=place,
        symmetric=True,
        period=period,
    )
