"""Oblique design to body (G, Fig. 2; heights as corrected in docs/theory.md)."""

from collections.abc import Callable

import numpy as np

from actuators.design.oblique import ObliqueDesign
from actuators.geometry.body import CAVITY, OUTSIDE, Body, Region

BOTTOM, TOP = 0, 1
END, GAP, WALL, CHAMBER = range(4)


def oblique_body(design: ObliqueDesign) -> Body:
    """Whole bar. Lattice: x' = X1 on the middle plane, sheared along X1 by cot(theta) X2 between
    the end pieces and straightened within them, so that clamp and free end are square; y' = X2;
    z' = X3. End pieces are solid over the full height."""
    e, t1, t2, t3 = (
        design.end_length, design.half_gap, design.wall_thickness, design.half_chamber,
    )  # fmt: skip
    x_lines: list[float] = [0.0, e]
    kinds: list[int] = [END]
    for k in range(design.chamber_count):
        base = e + k * design.pitch
        if k > 0:
            x_lines.pop()  # the two half gaps between neighbours are one
            kinds.pop()
        x_lines += [base + t1, base + t1 + t2, base + t1 + t2 + 2 * t3]
        x_lines += [base + t1 + 2 * t2 + 2 * t3, base + design.pitch]
        kinds += [GAP, WALL, CHAMBER, WALL, GAP]
    x_lines.append(design.length)
    kinds.append(END)
    length, cot = design.length, design.cot_theta

    def shear(x: np.ndarray) -> np.ndarray:
        return np.clip(np.minimum(x, length - x) / e, 0.0, 1.0) * cot

    return _blocks(design, np.array(x_lines), np.array(kinds), shear, period=None)


def oblique_cell(design: ObliqueDesign) -> Body:
    """One pitch, from the middle of a gap to the middle of the next, sheared throughout."""
    t1, t2, t3 = design.half_gap, design.wall_thickness, design.half_chamber
    x_lines = np.cumsum([0.0, t1, t2, 2 * t3, t2, t1])
    cot = design.cot_theta

    def shear(x: np.ndarray) -> np.ndarray:
        return np.full_like(x, cot)

    kinds = np.array([GAP, WALL, CHAMBER, WALL, GAP])
    return _blocks(design, x_lines, kinds, shear, period=design.pitch)


def _blocks(
    design: ObliqueDesign,
    x_lines: np.ndarray,
    kinds: np.ndarray,
    shear: Callable[[np.ndarray], np.ndarray],
    *,
    period: float | None,
) -> Body:
    halves = [design.chamber_width / 2, design.width / 2]
    if design.channel_width > 0:
        halves.insert(0, design.channel_width / 2)
    symmetric = design.cot_theta == 0.0
    middle = [0.0] if symmetric else []
    y_lines = np.array([-h for h in reversed(halves)] + middle + halves)
    has_channel = design.channel_width > 0
    foot = [design.foot_height]
    if has_channel:  # the foot closes the channel under the open gaps
        foot = [design.channel_height, design.foot_height - design.channel_height]
    z_lines = np.cumsum(
        [0.0, design.bottom_thickness, *foot, design.wall_height, design.roof_thickness]
    )
    y_middle = np.abs(y_lines[:-1] + y_lines[1:]) / 2
    inside = y_middle < design.chamber_width / 2
    channel = y_middle < design.channel_width / 2

    fill = np.full((len(kinds), len(y_middle), len(z_lines) - 1), TOP, dtype=np.int8)
    fill[:, :, 0] = BOTTOM
    fill[kinds == GAP, :, -2:] = OUTSIDE
    fill[np.outer(kinds == CHAMBER, inside), 1:-1] = CAVITY
    chambers = np.flatnonzero(kinds == CHAMBER)
    row = np.zeros(len(kinds), dtype=bool)
    row[chambers[0] : chambers[-1] + 1] = True
    if period is not None:
        row[:] = True  # neighbours continue the channel
    if has_channel:
        fill[np.outer(row, channel), 1] = CAVITY

    def place(lattice: np.ndarray) -> np.ndarray:
        x, y, z = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
        return np.stack([x + shear(x) * y, y, z], axis=-1)

    return Body(
        lines=(x_lines, y_lines, z_lines),
        fill=fill,
        regions=(
            Region("bottom layer", design.bottom_material),
            Region("chamber blocks", design.top_material),
        ),
        place=place,
        symmetric=symmetric,
        period=period,
    )
