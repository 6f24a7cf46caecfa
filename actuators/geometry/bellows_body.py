"""Bellows to body: the wavy skin is one strip of the lattice.

x' is X1 on the floor under the cavity, z' the height that each row has in the end pieces. In the
skin's row x' runs along the strip and z' through its thickness, valley, straight wall and crown one
interval each. The cavity's two rows lie between floor and skin (side walls and end pieces fill them
with rubber): the lower one stands upright on the floor, the upper one fans out from it to the skin,
with the bend between them inside the bellows. Every piece is ruled between two curves, and none
folds over: the determinants of all of them are sums of positive terms.
"""

import numpy as np

from actuators.design.bellows import BellowsDesign
from actuators.design.wave import Wave
from actuators.geometry.body import CAVITY, Body, Region

BOTTOM, TOP = 0, 1
WALL_FROM, WALL_TO = 1 / 3, 2 / 3
"""Part of the floor inside a half bellows, from the wall's plane to the middle, where the lattice's
lines to the straight wall begin; before it those to the valley, after it those to the crown."""
BEND = 0.4
"""Height of the bend between the cavity's rows under the crown, over the crown's radius."""
BOTTOM_ROW, LOWER_ROW, UPPER_ROW, SKIN_ROW = range(4)


def bellows_body(design: BellowsDesign) -> Body:
    """Whole body: end piece, bellows, end piece."""
    wave, end = design.wave, design.end_length
    marks = _marks(wave)
    rows = [end + k * wave.pitch + marks[:-1] for k in range(design.chamber_count)]
    x_lines = np.concatenate([[0.0], *rows, [design.length - end, design.length]])
    in_row = np.ones(len(x_lines) - 1, dtype=bool)
    in_row[[0, -1]] = False
    return _profile(design, x_lines, in_row, end, period=None)


def bellows_cell(design: BellowsDesign) -> Body:
    """One pitch, from the middle of a valley to the middle of the next."""
    marks = _marks(design.wave)
    return _profile(design, marks, np.ones(len(marks) - 1, dtype=bool), 0.0, period=design.pitch)


def _marks(wave: Wave) -> np.ndarray:
    """Lattice lines over one pitch (7,): valley, wall, crown and their mirror images."""
    half = np.array([0.0, *_floor_marks(wave), wave.pitch / 2])
    return np.concatenate([half, wave.pitch - half[-2::-1]])


def _floor_marks(wave: Wave) -> tuple[float, float]:
    return wave.valley + WALL_FROM * wave.crown, wave.valley + WALL_TO * wave.crown


def _profile(
    design: BellowsDesign,
    x_lines: np.ndarray,
    in_row: np.ndarray,
    start: float,
    *,
    period: float | None,
) -> Body:
    wave, count = design.wave, design.chamber_count if period is None else 1
    inner, outer = design.inner_width / 2, design.width / 2
    floor, channel = wave.floor, wave.channel
    z_lines = np.cumsum([0.0, floor, channel / 2, channel / 2, wave.thickness])
    fill = np.full((len(x_lines) - 1, 4, 4), TOP, dtype=np.int8)
    fill[:, :, BOTTOM_ROW] = BOTTOM
    fill[in_row, 1:3, LOWER_ROW : UPPER_ROW + 1] = CAVITY

    def place(lattice: np.ndarray) -> np.ndarray:
        x, y, z = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
        pitch_number = np.clip(np.floor((x - start) / wave.pitch), 0, count - 1)
        along = x - start - pitch_number * wave.pitch
        second = along > wave.pitch / 2
        from_valley = np.clip(np.where(second, wave.pitch - along, along), 0.0, None)
        curves = _curves(wave, from_valley)
        height = np.minimum(z, floor)
        shift = np.zeros_like(x)
        for number in range(3):
            low, high = z_lines[number + 1], z_lines[number + 2]
            share = np.clip((z - low) / (high - low), 0.0, 1.0)
            (x0, z0), (x1, z1) = curves[number], curves[number + 1]
            shift = shift + share * (x1 - x0)
            height = height + share * (z1 - z0)
        at_end = (along <= 0.0) | (along >= wave.pitch)
        shift = np.where(at_end, 0.0, np.where(second, -shift, shift))
        return np.stack([x + shift, y, np.where(at_end, z, height)], axis=-1)

    return Body(
        lines=(x_lines, np.array([-outer, -inner, 0.0, inner, outer]), z_lines),
        fill=fill,
        regions=(Region("bottom layer", design.material), Region("bellows", design.material)),
        place=place,
        symmetric=True,
        period=period,
        curved=True,
    )


def _curves(wave: Wave, v: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
    """Points (X1 from the valley's middle, X3) over a half pitch for the floor's X1 = ``v``: on the
    floor, at the bend, inside and outside of the skin."""
    begin, end = _floor_marks(wave)
    in_valley = np.clip(v / begin, 0.0, 1.0)
    in_wall = np.clip((v - begin) / (end - begin), 0.0, 1.0)
    in_crown = np.clip((v - end) / (wave.pitch / 2 - end), 0.0, 1.0)
    valley, crown = in_valley * np.pi / 2, in_crown * np.pi / 2
    # sine and cosine of a quarter turn, exact at both ends: neighbours must share their nodes
    sin_v, cos_v = np.sin(valley), np.where(in_valley == 1.0, 0.0, np.cos(valley))
    sin_c, cos_c = np.sin(crown), np.where(in_crown == 1.0, 0.0, np.cos(crown))
    straight = in_wall * wave.straight

    def skin(low: float, high: float) -> tuple[np.ndarray, np.ndarray]:
        """Circles of radius ``low`` in the valley and ``high`` in the crown."""
        return (
            low * sin_v + high * (1.0 - cos_c),
            wave.valley_centre - low * cos_v + straight + high * sin_c,
        )

    floor = np.full_like(v, wave.floor)
    inset = WALL_FROM * wave.crown * in_valley
    bend_x = np.where(in_valley < 1.0, wave.valley * sin_v + inset, v)
    bend_z = (
        wave.valley_centre - wave.valley * cos_v - wave.channel / 2 * (1.0 - in_valley)
        + straight + BEND * wave.crown * sin_c
    )  # fmt: skip
    return [
        (v, floor),
        (bend_x, bend_z),
        skin(wave.valley, wave.crown),
        skin(wave.gap / 2, wave.crown_outside),
    ]
