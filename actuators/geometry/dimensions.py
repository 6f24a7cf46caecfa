"""Dimension lines of a drawing: which length in the picture belongs to which parameter. In mm."""

import math
from dataclasses import dataclass
from typing import Literal

from actuators.design import BellowsDesign, Design, ObliqueDesign, PrintedDesign, SlabDesign
from actuators.design.blocks import BlockBar

View = Literal["section", "planform"]
Point = tuple[float, float]

NEAR, FAR = 5.0, 11.0
"""Distance of dimension lines from the body [mm]."""


@dataclass(frozen=True)
class Dimension:
    """One dimension line. ``start`` and ``end`` are its arrow tips; ``anchors`` the points on the
    body that it measures, from which witness lines run to the tips. An angle turns from ``start``
    to ``end`` about ``centre``; a radius points from ``start`` towards the arc at ``end``."""

    parameter: str
    view: View
    start: Point
    end: Point
    anchors: tuple[Point, ...] = ()
    kind: Literal["distance", "angle", "radius"] = "distance"
    centre: Point | None = None


def dimensions(design: Design) -> list[Dimension]:
    """A dimension for every geometric parameter that the design's picture shows."""
    if isinstance(design, SlabDesign):
        return _slab(design)
    if isinstance(design, ObliqueDesign):
        return _oblique(design)
    if isinstance(design, PrintedDesign):
        return _printed(design)
    if isinstance(design, BellowsDesign):
        return _bellows(design)
    raise TypeError(f"no drawing for {type(design).__name__}")


def _along(
    parameter: str, view: View, start: float, end: float, level: float, body: tuple[float, float]
) -> Dimension:
    """Horizontal line at height ``level`` between X1 = start and end; ``body``: where the witness
    lines touch the body at either end."""
    anchors = ((start, body[0]), (end, body[1]))
    return Dimension(parameter, view, (start, level), (end, level), anchors)


def _across(
    parameter: str, view: View, low: float, high: float, x: float, body: tuple[float, float]
) -> Dimension:
    """Vertical line at X1 = ``x`` between two heights; ``body``: X1 of its witness points."""
    anchors = ((body[0], low), (body[1], high))
    return Dimension(parameter, view, (x, low), (x, high), anchors)


def _layers(names: dict[str, float]) -> list[Dimension]:
    """Chain of thicknesses at the clamp end, from the underside up."""
    chain: list[Dimension] = []
    low = 0.0
    for name, thickness in names.items():
        high = low + thickness * 1e3
        chain.append(_across(name, "section", low, high, -NEAR, (0.0, 0.0)))
        low = high
    return chain


def _slab(design: SlabDesign) -> list[Dimension]:
    def half(x: float) -> float:
        return float(design.half_width(x / 1e3)) * 1e3

    n, length, width = design.chamber_count, design.length * 1e3, design.width * 1e3
    chamber, wall = design.chamber_length * 1e3, design.wall_length * 1e3
    first = design.root_wall * 1e3
    last = length - design.tip_wall * 1e3
    above, below = width / 2 + NEAR, -width / 2 - NEAR
    ends = (-half(0.0), -half(length))
    widest = length / 2 if design.planform == "ellipse" else 0.0
    arm = first + chamber / 2
    channel_x = first + chamber + wall / 2 if n > 1 else arm
    channel = design.channel_width * 1e3 / 2
    lines = [
        _along("length", "planform", 0.0, length, below, ends),
        _across("width", "planform", -width / 2, width / 2, -NEAR, (widest, widest)),
        _along("root_wall", "planform", 0.0, first, above, (half(0.0), half(first))),
        _along("chamber_count", "planform", first, last, above, (half(first), half(last))),
        _along("tip_wall", "planform", last, length, above, (half(last), half(length))),
        _across("channel_width", "planform", -channel, channel, channel_x, (channel_x, channel_x)),
        _across(
            "side_wall", "planform", half(arm) - design.side_wall * 1e3, half(arm), arm, (arm, arm)
        ),
        *_layers(
            {"bottom_thickness": design.bottom_thickness,
             "chamber_height": design.chamber_height,
             "roof_thickness": design.roof_thickness}
        ),
    ]  # fmt: skip
    if n > 1:
        start = first + chamber
        level = (channel + half(start) - design.side_wall * 1e3) / 2
        lines.append(_along("wall_ratio", "planform", start, start + wall, level, (level, level)))
    if design.planform == "triangle":
        tip = half(length)
        lines.append(
            _across("tip_width", "planform", -tip, tip, length + NEAR, (length, length))
        )  # fmt: skip
    if design.planform == "ellipse":
        lines.append(_side_radius(design))
    return lines


def _side_radius(design: SlabDesign) -> Dimension:
    length, radius = design.length * 1e3, design.side_radius * 1e3
    centre = (length / 2, design.width * 500 - radius)
    x = 0.75 * length
    end = (x, float(design.half_width(x / 1e3)) * 1e3)
    reach = min(0.4 * length, radius) / radius
    start = (end[0] + reach * (centre[0] - end[0]), end[1] + reach * (centre[1] - end[1]))
    return Dimension("side_radius", "planform", start, end, (end,), "radius", centre)


def _oblique(design: ObliqueDesign) -> list[Dimension]:
    bar = design.bar
    n, length, width = bar.chamber_count, bar.length * 1e3, bar.width * 1e3
    t1, t2, t3 = bar.half_gap * 1e3, bar.wall_thickness * 1e3, bar.half_chamber * 1e3
    height, roof = bar.height * 1e3, (bar.height - bar.roof_thickness) * 1e3
    centres = bar.chamber_centres() * 1e3
    middle, last = float(centres[n // 2]), float(centres[-1])
    gap = middle - t1 - t2 - t3
    foot = (bar.bottom_thickness + bar.foot_height) * 1e3
    half, skew = bar.chamber_width * 500, bar.cot_theta
    reach = 0.75 * width
    return [
        *_bar(bar),
        _across(
            "chamber_width", "planform", -half, half, length + NEAR,
            (last - skew * half, last + skew * half),
        ),
        _along("half_gap", "section", gap, gap + t1, height + NEAR, (foot, height)),
        _along("wall_thickness", "section", gap + t1, gap + t1 + t2, height + NEAR, (height, roof)),
        _along("half_chamber", "section", middle - t3, middle, height + NEAR, (roof, roof)),
        Dimension(
            "theta", "planform", (middle + reach, 0.0),
            (middle + reach * math.cos(design.theta), reach * math.sin(design.theta)),
            kind="angle", centre=(middle, 0.0),
        ),
        _across("inlet_height", "section", 0.0, design.inlet_height * 1e3, -FAR, (0.0, 0.0)),
    ]  # fmt: skip


def _printed(design: PrintedDesign) -> list[Dimension]:
    bar = design.bar
    length, half, side = bar.length * 1e3, bar.chamber_width * 500, bar.width * 500
    t1, t2, t3 = bar.half_gap * 1e3, bar.wall_thickness * 1e3, bar.half_chamber * 1e3
    height, roof = bar.height * 1e3, (bar.height - bar.roof_thickness) * 1e3
    centres = bar.chamber_centres() * 1e3
    middle = float(centres[bar.chamber_count // 2])
    wall, last = middle - t2 - t3, float(centres[-1])
    lines = [
        *_bar(bar),
        _across("side_wall", "planform", half, side, length + NEAR, (last, last)),
        _along("gap", "section", wall - 2 * t1, wall, height + NEAR, (height, height)),
        _along("wall_thickness", "section", wall, wall + t2, height + NEAR, (height, roof)),
        _along("chamber_length", "section", middle - t3, middle + t3, height + NEAR, (roof, roof)),
    ]
    if bar.sheet is not None:
        level, thick = bar.sheet.height * 1e3, bar.sheet.thickness * 1e3
        ends = (length, length)
        lines += [
            _across("layer_height", "section", 0.0, level, length + NEAR, ends),
            _across(
                "layer_thickness", "section", level - thick / 2, level + thick / 2, length + FAR,
                ends,
            ),
        ]  # fmt: skip
    return lines


def _bellows(design: BellowsDesign) -> list[Dimension]:
    n, length, side = design.chamber_count, design.length * 1e3, design.width * 500
    wave, end, pitch = design.wave, design.end_length * 1e3, design.pitch * 1e3
    height, floor = design.height * 1e3, design.bottom_thickness * 1e3
    valley, level = end + (n // 2) * pitch, (wave.valley_centre + wave.straight / 2) * 1e3
    gap, wall = wave.gap * 500, wave.thickness * 1e3
    at_ends = (design.end_height * 1e3, design.end_height * 1e3)
    lines = [
        _along("length", "planform", 0.0, length, -side - NEAR, (-side, -side)),
        _across("width", "planform", -side, side, -NEAR, (0.0, 0.0)),
        _across("total_height", "section", 0.0, height, -FAR, (0.0, end + pitch / 2)),
        _along("chamber_count", "section", end, length - end, height + FAR, at_ends),
        _along(
            "wall_thickness", "section", valley + gap, valley + gap + wall, height + NEAR,
            (level, level),
        ),
        _along("end_length", "section", 0.0, end, height + NEAR, at_ends),
        _across(
            "channel_height", "section", floor, floor + design.channel_height * 1e3, valley,
            (valley, valley),
        ),
        *_layers({"bottom_thickness": design.bottom_thickness}),
    ]  # fmt: skip
    if n > 1:
        lines.append(
            _along("gap", "section", valley - gap, valley + gap, height + NEAR, (level, level))
        )
    return lines


def _bar(bar: BlockBar) -> list[Dimension]:
    """What all families of chamber blocks show under the same names."""
    n, length, width = bar.chamber_count, bar.length * 1e3, bar.width * 1e3
    height, side = bar.height * 1e3, bar.width * 500
    block = (bar.wall_thickness + bar.half_chamber) * 1e3
    centres = bar.chamber_centres() * 1e3
    first, last = float(centres[0]) - block, float(centres[-1]) + block
    gap = float(centres[n // 2]) - block - bar.half_gap * 1e3
    lines = [
        _along("length", "planform", 0.0, length, -side - NEAR, (-side, -side)),
        _across("width", "planform", -width / 2, width / 2, -NEAR, (0.0, 0.0)),
        _along("chamber_count", "section", first, last, height + FAR, (height, height)),
        *_layers(
            {"bottom_thickness": bar.bottom_thickness, "foot_height": bar.foot_height,
             "wall_height": bar.wall_height, "roof_thickness": bar.roof_thickness}
        ),
    ]  # fmt: skip
    if bar.channel_width > 0 and n > 1:
        channel, bottom = bar.channel_width * 500, bar.bottom_thickness * 1e3
        top = bottom + bar.channel_height * 1e3
        lines += [
            _across("channel_width", "planform", -channel, channel, gap, (gap, gap)),
            _across("channel_height", "section", bottom, top, gap, (gap, gap)),
        ]
    return lines
