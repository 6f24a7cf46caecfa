"""The drawing: areas of its cuts against the exact volumes, lines against the parameters."""

import json
import math

import pytest
from hypothesis import example, given, settings
from shapely.geometry import Polygon

from actuators.design import PRESETS, BellowsDesign, Design, SlabDesign, preset
from actuators.geometry.dimensions import dimensions
from actuators.geometry.drawing import drawing
from actuators.geometry.volumes import exact_volumes, slab_cavity_area, slab_planform_area
from tests.actuators.design_space import designs, slabs

LENGTHS = ("length", "ratio", "angle", "count")


def area_of(view: dict, kind: str) -> float:
    """Even-odd area of all shapes of a kind [mm2]."""
    total = 0.0
    for shape in view["shapes"]:
        if shape["kind"] == kind:
            pieces = [Polygon(ring) for ring in shape["rings"]]
            for piece in pieces:
                depth = sum(other.contains(piece) for other in pieces if other is not piece)
                total += -piece.area if depth % 2 else piece.area
    return total


@settings(max_examples=40, deadline=None, derandomize=True)
@given(slabs())
def test_areas_of_a_slab_planform_are_exact(design: SlabDesign) -> None:
    view = drawing(design)["views"]["planform"]
    cavity = slab_cavity_area(design) * 1e6
    # the outline is simplified to 0.01 mm
    slack = 0.01 * (2 * design.length * 1e3) * (2 + design.chamber_count)
    assert area_of(view, "cavity") == pytest.approx(cavity, abs=slack)
    rubber = slab_planform_area(design) * 1e6 - cavity
    assert area_of(view, "rubber") == pytest.approx(rubber, abs=slack)


NARROW_CHANNEL = BellowsDesign(
    length=0.01, width=0.0022, total_height=0.00315, chamber_count=1, wall_thickness=0.00085,
    gap=0.0001, channel_height=0.0003, end_length=0.0037, bottom_thickness=0.0003,
    material="ninjaflex-ogden-002",
)  # fmt: skip


@settings(max_examples=60, deadline=None, derandomize=True)
@given(designs())
@example(NARROW_CHANNEL)
def test_every_design_can_be_drawn_as_compact_json(design: Design) -> None:
    picture = drawing(design)
    text = json.dumps(picture, allow_nan=False, separators=(",", ":"))
    curves = 3_000 * design.chamber_count if isinstance(design, BellowsDesign) else 0
    assert len(text) < 30_000 + curves
    shown = {line["parameter"] for line in picture["dimensions"]}
    known = {p.name for p in design.parameters()}
    assert shown <= known
    hidden = {p.name for p in design.parameters() if p.kind in LENGTHS} - shown
    unseen = {"tip_width", "side_radius", "wall_ratio", "channel_width", "channel_height",
              "layer_height", "layer_thickness", "gap"}  # fmt: skip
    assert hidden <= unseen, "only dimensions that this design does not have are left out"
    for line in picture["dimensions"]:
        left, bottom, right, top = picture["views"][line["view"]]["bounds"]
        for x, y in (line["from"], line["to"]):
            assert left < x < right
            assert bottom < y < top


@pytest.mark.parametrize("name", PRESETS)
def test_each_dimension_line_is_as_long_as_its_parameter(name: str) -> None:
    design = preset(name).design
    for line in dimensions(design):
        parameter = next(p for p in design.parameters() if p.name == line.parameter)
        if parameter.kind == "length" and line.kind == "distance":
            assert math.dist(line.start, line.end) == pytest.approx(
                getattr(design, line.parameter) * 1e3, abs=1e-9
            )
        if line.kind == "angle":
            assert line.centre is not None
            x, y = (b - a for a, b in zip(line.centre, line.end, strict=True))
            assert math.atan2(y, x) == pytest.approx(getattr(design, line.parameter))
        if line.kind == "radius":
            assert line.centre is not None
            assert math.dist(line.centre, line.end) == pytest.approx(design.side_radius * 1e3)


@pytest.mark.parametrize("name", ["oblique-15", "oblique-45", "oblique-90"])
def test_oblique_planform_shows_chambers_gaps_and_channel(name: str) -> None:
    design = preset(name).design
    view = drawing(design)["views"]["planform"]
    n = design.chamber_count
    chambers = n * 2 * design.half_chamber * design.chamber_width * 1e6
    gaps = n * 2 * design.half_gap * design.width * 1e6
    assert area_of(view, "cavity") == pytest.approx(chambers, rel=1e-3)
    assert area_of(view, "beyond") == pytest.approx(gaps, rel=1e-3)
    channel = (exact_volumes(design).cavity * 1e9 - chambers * design.chamber_height * 1e3) / (
        design.channel_height * 1e3
    )
    assert area_of(view, "hidden") == pytest.approx(channel, rel=1e-3)
