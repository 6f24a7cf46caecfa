"""A design as a drawing for the page: two cuts and their dimension lines, ready for JSON, in mm."""

from typing import Any

from shapely.geometry import MultiPolygon, Polygon
from shapely.geometry.polygon import orient

from actuators.design.base import Design
from actuators.design.parameter import Parameter
from actuators.geometry import build_body
from actuators.geometry.dimensions import Dimension, Point, dimensions
from actuators.geometry.slices import Shape, planform, section

DECIMALS = 3
MARGIN_MM = 3.0

_VIEWS = {
    "section": ("Section on the middle plane", "X1", "X3"),
    "planform": ("Planform at chamber height", "X1", "X2"),
}


def drawing(design: Design) -> dict[str, Any]:
    """Two views and their dimension lines.

    ``views`` by name: title, axes, ``bounds`` [left, bottom, right, top] around all that is drawn,
    and ``shapes`` (kind, region, material, rings; fill by the even-odd rule; drawn in this order).
    ``dimensions``: a line from ``from`` to ``to`` in a view for every parameter that the picture
    shows. ``regions``: which material parameter colours which region.
    """
    body = build_body(design)
    material_of = {region.name: region.material for region in body.regions}
    shapes = {"section": section(body), "planform": planform(body)}
    lines = dimensions(design)
    known = {p.name: p for p in design.parameters()}
    return {
        "unit": "mm",
        "views": {
            name: {
                "title": title,
                "horizontal": horizontal,
                "vertical": vertical,
                "bounds": _bounds(shapes[name], [d for d in lines if d.view == name]),
                "shapes": [_shape(shape, material_of) for shape in shapes[name]],
            }
            for name, (title, horizontal, vertical) in _VIEWS.items()
        },
        "dimensions": [_dimension(d, known[d.parameter], design) for d in lines],
        "regions": [
            {"name": region.name, "parameter": parameter, "material": region.material}
            for region, parameter in zip(body.regions, design.layer_materials, strict=True)
        ],
    }


def _shape(shape: Shape, material_of: dict[str, str]) -> dict[str, Any]:
    return {
        "kind": shape.kind,
        "region": shape.region or None,
        "material": material_of.get(shape.region),
        "rings": _rings(shape.area),
    }


def _rings(area: Polygon | MultiPolygon) -> list[list[list[float]]]:
    """Outer rings counter-clockwise, holes clockwise, none closed."""
    rings: list[list[list[float]]] = []
    for polygon in area.geoms if isinstance(area, MultiPolygon) else [area]:
        turned = orient(polygon)
        for ring in (turned.exterior, *turned.interiors):
            rings.append([_point((x, y)) for x, y in list(ring.coords)[:-1]])
    return rings


def _dimension(line: Dimension, parameter: Parameter, design: Design) -> dict[str, Any]:
    document: dict[str, Any] = {
        "parameter": line.parameter,
        "view": line.view,
        "kind": line.kind,
        "label": _label(parameter, design),
        "from": _point(line.start),
        "to": _point(line.end),
        "anchors": [_point(p) for p in line.anchors],
    }
    if line.centre is not None:
        document["centre"] = _point(line.centre)
    return document


def _label(parameter: Parameter, design: Design) -> str:
    value = getattr(design, parameter.name) / parameter.si_per_unit
    unit = "°" if parameter.kind == "angle" else f" {parameter.unit}" if parameter.unit else ""
    symbol = f"{parameter.symbol} = " if parameter.symbol else ""
    return f"{symbol}{value:.4g}{unit}"


def _bounds(shapes: list[Shape], lines: list[Dimension]) -> list[float]:
    boxes = [shape.area.bounds for shape in shapes]
    boxes += [(*p, *p) for line in lines for p in (line.start, line.end)]
    left, bottom, right, top = zip(*boxes, strict=True)
    corner = (min(left) - MARGIN_MM, min(bottom) - MARGIN_MM)
    return [*_point(corner), *_point((max(right) + MARGIN_MM, max(top) + MARGIN_MM))]


def _point(point: Point) -> list[float]:
    # adding zero turns -0.0 into 0.0
    return [round(point[0], DECIMALS) + 0.0, round(point[1], DECIMALS) + 0.0]
