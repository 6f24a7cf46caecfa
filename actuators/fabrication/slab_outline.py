"""Outlines of a slab in mm, as polygons whose arcs are followed to 2 micrometres."""

import math

import numpy as np
from shapely.geometry import Polygon

from actuators.design.slab import SlabDesign

CHORD_ERROR_MM = 0.002


def planform_outline(design: SlabDesign) -> Polygon:
    """Outline of the body seen from above."""
    return _mirrored(_side(design, 0.0, design.length, inset=0.0))


def cavity_outline(design: SlabDesign) -> Polygon:
    """Chambers and channel seen from above: one connected piece, as a core is cut."""
    channel = design.channel_width * 500
    border: list[np.ndarray] = []
    starts = design.chamber_starts()
    for k, start in enumerate(map(float, starts)):
        end = start + design.chamber_length
        if k > 0:
            border.append(np.array([[start * 1e3, channel]]))
        border.append(_side(design, start, end, inset=design.side_wall))
        if k < len(starts) - 1:
            border.append(np.array([[end * 1e3, channel]]))
    return _mirrored(np.concatenate(border))


def _mirrored(border: np.ndarray) -> Polygon:
    """Polygon between a border (n, 2) of positive y and its mirror image."""
    return Polygon(np.concatenate([border[::-1], border * [1.0, -1.0]]))


def _side(design: SlabDesign, start: float, end: float, *, inset: float) -> np.ndarray:
    """Points (n, 2) [mm] of the outline's side X2 > 0 from ``start`` to ``end`` [m], moved
    inwards by ``inset`` [m]."""
    if design.planform == "ellipse":
        radius, middle = design.side_radius, design.length / 2
        first = math.asin((start - middle) / radius)
        last = math.asin((end - middle) / radius)
        step = 2 * math.acos(1 - min(CHORD_ERROR_MM * 1e-3 / radius, 1.0))
        count = max(2, math.ceil((last - first) / step) + 1)
        x = middle + radius * np.sin(np.linspace(first, last, count))
        x[0], x[-1] = start, end
    else:
        x = np.array([start, end])
    return np.stack([x, design.half_width(x) - inset], axis=-1) * 1e3
