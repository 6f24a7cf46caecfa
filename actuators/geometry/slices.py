"""Plane cuts through a body as polygons: the section on the middle plane and the planform at the
height of the chambers. Lengths in mm, for drawings."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
import shapely
from shapely.geometry import LineString, MultiPolygon, Polygon

from actuators.geometry.body import CAVITY, OUTSIDE, Body

PARTS_OF_A_CURVED_BLOCK = 16
SMALLEST_DETAIL_MM = 0.01

Kind = Literal["rubber", "cavity", "beyond", "hidden"]
Stretch = tuple[float, float]


@dataclass(frozen=True)
class Shape:
    """One area of a cut, in mm. ``region`` is the name of the rubber, empty for air.

    ``kind``: rubber cut through; cavity cut through; rubber seen beyond the cut; cavity hidden
    beyond the rubber that is cut.
    """

    kind: Kind
    region: str
    area: Polygon | MultiPolygon


def section(body: Body) -> list[Shape]:
    """Cut X2 = 0 seen from -X2, and the walls beside the channel; coordinates (X1, X3)."""
    x, y, z = body.lines
    middle = int(np.searchsorted(y, 0.0, side="right")) - 1
    parts = PARTS_OF_A_CURVED_BLOCK if body.curved else 1
    corners = np.stack(np.meshgrid(_cut(x, parts), [0.0], z, indexing="ij"), axis=-1)
    points = body.place(corners)[:, 0][..., [0, 2]]
    fill = np.repeat(body.fill, parts, axis=0)
    at_cut, beside = fill[:, middle], fill[:, middle + 1]
    beyond = np.full_like(at_cut, OUTSIDE)
    if (beside == CAVITY).any():  # else the chambers are as narrow as the channel: only side walls
        beyond = np.where((at_cut == CAVITY) & (beside >= 0), beside, OUTSIDE)
    return [
        *_shapes(body, at_cut, points),
        *_shapes(body, beyond, points, rubber="beyond"),
    ]


def planform(body: Body) -> list[Shape]:
    """Cut through the chambers' upper part seen from above; coordinates (X1, X2)."""
    if body.curved:
        return list(_planform_of_a_profile(body))
    x, y, z = body.lines
    layers_with_air = np.flatnonzero((body.fill == CAVITY).any(axis=(0, 1)))
    cut = int(layers_with_air[-1])
    height = (z[cut] + z[cut + 1]) / 2

    def placed(x: np.ndarray) -> np.ndarray:
        corners = np.stack(np.meshgrid(x, y, [height], indexing="ij"), axis=-1)
        return body.place(corners)[:, :, 0, :2]

    points, middles = placed(x), placed((x[:-1] + x[1:]) / 2)
    curved = np.abs(middles - (points[:-1] + points[1:]) / 2).max() * 1e3 > SMALLEST_DETAIL_MM / 10
    parts = PARTS_OF_A_CURVED_BLOCK if curved else 1
    if curved:
        points = placed(_cut(x, parts))

    def spread(fill: np.ndarray) -> np.ndarray:
        return np.repeat(fill, parts, axis=0)

    at_cut = body.fill[:, :, cut]
    beyond, hidden = np.full_like(at_cut, OUTSIDE), np.full_like(at_cut, OUTSIDE)
    for layer in range(cut):
        fill = body.fill[:, :, layer]
        beyond = np.where((at_cut == OUTSIDE) & (fill >= 0), fill, beyond)
        hidden = np.where((at_cut != CAVITY) & (fill == CAVITY), fill, hidden)
    return [
        *_shapes(body, spread(beyond), points, rubber="beyond"),
        *_shapes(body, spread(at_cut), points),
        *_shapes(body, spread(hidden), points, cavity="hidden"),
    ]


def _planform_of_a_profile(body: Body) -> Iterator[Shape]:
    """Planform of a body whose profile (X1, X3) is the same over each column across: cut half way
    between the lowest and the highest roof of the cavity."""
    x, y, z = body.lines
    x = _cut(x, PARTS_OF_A_CURVED_BLOCK)
    fill = np.repeat(body.fill, PARTS_OF_A_CURVED_BLOCK, axis=0)
    points = body.place(np.stack(np.meshgrid(x, [0.0], z, indexing="ij"), axis=-1))[:, 0]
    points = points[..., [0, 2]]
    roof = int(np.flatnonzero((body.fill == CAVITY).any(axis=(0, 1)))[-1]) + 1
    level = float(points[:, roof, 1].min() + points[:, roof, 1].max()) / 2 * 1e3
    ends = (float(points[0, 0, 0]) * 1e3, float(points[-1, 0, 0]) * 1e3)
    found: dict[tuple[Kind, str], list[Polygon]] = {}
    for column in range(len(y) - 1):
        whole, air = [ends], list[Stretch]()
        sides = (float(y[column]) * 1e3, float(y[column + 1]) * 1e3)
        for shape in _shapes(body, fill[:, column], points):
            line = shape.area.intersection(LineString([(ends[0], level), (ends[1], level)]))
            cut = [(p.bounds[0], p.bounds[2]) for p in shapely.get_parts(line) if not p.is_empty]
            whole = _without(whole, cut)
            _add(found, (shape.kind, shape.region), cut, sides)
            if shape.kind == "cavity":
                air = _without([(shape.area.bounds[0], shape.area.bounds[2])], cut)
        _add(found, ("beyond", body.regions[body.fill[0, column, -1]].name), whole, sides)
        _add(found, ("hidden", ""), air, sides)
    for kind in ("beyond", "rubber", "cavity", "hidden"):
        for (own, region), boxes in found.items():
            area = shapely.union_all(boxes)
            if own == kind and isinstance(area, (Polygon, MultiPolygon)):
                yield Shape(kind=own, region=region, area=area)


def _without(whole: list[Stretch], parts: list[Stretch]) -> list[Stretch]:
    """Stretches of X1 less others, details too small to draw left out."""
    kept: list[Stretch] = []
    for begin, end in whole:
        at = begin
        for left, right in sorted(parts):
            until = min(left, end)
            if until - at > SMALLEST_DETAIL_MM:
                kept.append((at, until))
            at = max(at, right)
        if end - at > SMALLEST_DETAIL_MM:
            kept.append((at, end))
    return kept


def _add(
    found: dict[tuple[Kind, str], list[Polygon]],
    key: tuple[Kind, str],
    stretches: list[Stretch],
    sides: Stretch,
) -> None:
    """Stretches of X1 as rectangles between two lines across."""
    if stretches:
        boxes = [shapely.box(left, sides[0], right, sides[1]) for left, right in stretches]
        found.setdefault(key, []).extend(boxes)


def _cut(line: np.ndarray, parts: int) -> np.ndarray:
    """Lattice lines with every interval in equal parts."""
    share = np.arange(parts) / parts
    return np.append((line[:-1, None] + np.diff(line)[:, None] * share).ravel(), line[-1])


def _shapes(
    body: Body,
    fill: np.ndarray,
    points: np.ndarray,
    rubber: Kind = "rubber",
    cavity: Kind = "cavity",
) -> Iterator[Shape]:
    """Boxes of one kind united. ``fill`` (n, m); ``points`` (n + 1, m + 1, 2) [m]."""
    mm = points * 1e3
    rings = np.stack([mm[:-1, :-1], mm[1:, :-1], mm[1:, 1:], mm[:-1, 1:]], axis=2)
    for value in np.unique(fill[fill != OUTSIDE]):
        # neighbouring boxes share their corners to the last bit, which makes this union cheap
        united = shapely.coverage_union_all(shapely.polygons(rings[fill == value]))
        area = shapely.simplify(united, SMALLEST_DETAIL_MM)
        if not isinstance(area, (Polygon, MultiPolygon)):
            raise TypeError(f"a cut through boxes gave a {area.geom_type}")
        region = body.regions[value].name if value >= 0 else ""
        yield Shape(kind=rubber if value >= 0 else cavity, region=region, area=area)
