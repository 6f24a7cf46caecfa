"""Chamber blocks to body (G, Fig. 2; heights as corrected in docs/theory.md)."""

from collections.abc import Callable

import numpy as np

from actuators.design.blocks import BlockBar
from actuators.geometry.body import CAVITY, OUTSIDE, Body, Membrane, Region
from actuators.materials import material

BOTTOM, TOP = 0, 1
END, GAP, WALL, CHAMBER = range(4)
SHEET_TO_RUBBER = 1000.0
"""Stiffness of an embedded sheet along the axis over that of as much of the rubber around it."""


def block_body(bar: BlockBar) -> Body:
    """Whole bar. Lattice: x' = X1 on the middle plane, sheared along X1 by cot(theta) X2 between
    the end pieces and straightened within them, so that clamp and free end are square; y' = X2;
    z' = X3. End pieces are solid over the full height."""
    e, t1, t2, t3 = bar.end_length, bar.half_gap, bar.wall_thickness, bar.half_chamber
    x_lines: list[float] = [0.0, e]
    kinds: list[int] = [END]
    for k in range(bar.chamber_count):
        base = e + k * bar.pitch
        if k > 0:
            x_lines.pop()  # the two half gaps between neighbours are one
            kinds.pop()
        x_lines += [base + t1, base + t1 + t2, base + t1 + t2 + 2 * t3]
        x_lines += [base + t1 + 2 * t2 + 2 * t3, base + bar.pitch]
        kinds += [GAP, WALL, CHAMBER, WALL, GAP]
    x_lines.append(bar.length)
    kinds.append(END)
    length, cot = bar.length, bar.cot_theta

    def shear(x: np.ndarray) -> np.ndarray:
        return np.clip(np.minimum(x, length - x) / e, 0.0, 1.0) * cot

    return _blocks(bar, np.array(x_lines), np.array(kinds), shear, period=None)


def block_cell(bar: BlockBar) -> Body:
    """One pitch, from the middle of a gap to the middle of the next, sheared throughout."""
    t1, t2, t3 = bar.half_gap, bar.wall_thickness, bar.half_chamber
    x_lines = np.cumsum([0.0, t1, t2, 2 * t3, t2, t1])
    cot = bar.cot_theta

    def shear(x: np.ndarray) -> np.ndarray:
        return np.full_like(x, cot)

    kinds = np.array([GAP, WALL, CHAMBER, WALL, GAP])
    return _blocks(bar, x_lines, kinds, shear, period=bar.pitch)


def sheet_stiffness(bar: BlockBar) -> float:
    """Stiffness of the bar's embedded sheet along the axis [N/m], 0 without one: a thousand times
    E t of the rubber it lies in."""
    if bar.sheet is None:
        return 0.0
    return SHEET_TO_RUBBER * material(bar.bottom_material).youngs_modulus * bar.sheet.thickness


def _blocks(
    bar: BlockBar,
    x_lines: np.ndarray,
    kinds: np.ndarray,
    shear: Callable[[np.ndarray], np.ndarray],
    *,
    period: float | None,
) -> Body:
    y_lines = _across(bar)
    bottom = [bar.bottom_thickness]
    membranes: tuple[Membrane, ...] = ()
    if bar.sheet is not None:
        membranes = (Membrane("embedded layer", bar.sheet.height, sheet_stiffness(bar)),)
        if bar.sheet.height > 0.0:
            bottom = [bar.sheet.height, bar.bottom_thickness - bar.sheet.height]
    foot = [bar.foot_height]
    if bar.channel_width > 0:  # the foot closes the channel under the open gaps
        foot = [bar.channel_height, bar.foot_height - bar.channel_height]
    z_lines = np.cumsum([0.0, *bottom, *foot, bar.wall_height, bar.roof_thickness])
    y_middle = np.abs(y_lines[:-1] + y_lines[1:]) / 2
    inside = y_middle < bar.chamber_width / 2
    channel = y_middle < bar.channel_width / 2

    floor = len(bottom)
    fill = np.full((len(kinds), len(y_middle), len(z_lines) - 1), TOP, dtype=np.int8)
    fill[:, :, :floor] = BOTTOM
    fill[kinds == GAP, :, -2:] = OUTSIDE
    fill[np.outer(kinds == CHAMBER, inside), floor:-1] = CAVITY
    chambers = np.flatnonzero(kinds == CHAMBER)
    row = np.zeros(len(kinds), dtype=bool)
    row[chambers[0] : chambers[-1] + 1] = True
    if period is not None:
        row[:] = True  # neighbours continue the channel
    if bar.channel_width > 0:
        fill[np.outer(row, channel), floor] = CAVITY

    def place(lattice: np.ndarray) -> np.ndarray:
        x, y, z = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
        return np.stack([x + shear(x) * y, y, z], axis=-1)

    return Body(
        lines=(x_lines, y_lines, z_lines),
        fill=fill,
        regions=(
            Region("bottom layer", bar.bottom_material),
            Region("chamber blocks", bar.top_material),
        ),
        place=place,
        symmetric=bar.cot_theta == 0.0,
        period=period,
        membranes=membranes,
    )


def _across(bar: BlockBar) -> np.ndarray:
    """Lattice lines across the bar; the middle plane where it is one of symmetry."""
    halves = [bar.chamber_width / 2, bar.width / 2]
    if bar.channel_width > 0:
        halves.insert(0, bar.channel_width / 2)
    middle = [0.0] if bar.cot_theta == 0.0 else []
    return np.array([-h for h in reversed(halves)] + middle + halves)
