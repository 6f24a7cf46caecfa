"""How large a mesh would be, without making it."""

import numpy as np

from actuators.geometry.body import Body
from actuators.meshing.levels import Layers
from actuators.meshing.subdivision import subdivide


def condensed_unknowns(body: Body, layers: Layers) -> int:
    """Unknowns of the mesh that :func:`mesh_body` makes with ``layers``, those held included and
    element centres condensed: three per node that is no centre."""
    rubber = body.fill >= 0
    for axis in range(3):
        lines = subdivide(
            body.lines[axis], layers=layers[axis],
            graded_first=axis == 0 and body.period is None, graded_last=False,
        )  # fmt: skip
        middles = (lines[:-1] + lines[1:]) / 2
        rubber = np.take(rubber, np.searchsorted(body.lines[axis], middles) - 1, axis=axis)
    elements = int(rubber.sum())
    node = rubber
    for axis in range(3):
        node = _with_ends(np.moveaxis(node, axis, 0))
        node = np.moveaxis(node, 0, axis)
    return 3 * (int(node.sum()) - elements)


def _with_ends(box: np.ndarray) -> np.ndarray:
    """Along the first axis, n boxes as 2 n + 1 places: each box's middle and both its ends, an end
    being there where either neighbour is."""
    places = np.zeros((2 * len(box) + 1, *box.shape[1:]), dtype=bool)
    places[1::2] = box
    places[:-1:2] |= box
    places[2::2] |= box
    return places
