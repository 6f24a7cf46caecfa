"""Where on a face the distance to the other surface is looked at, and how much area each place
stands for.

A rigid obstacle is looked for at 5 x 5 points: nodes, and the middles between them. Gauss points
leave the edges to themselves, which entered a plate by 20 times the contact's tolerance. Nodes
alone leave a face that is pressed in part room to sag between them (by an eighth of what its next
node is lifted), and twice as many points along each direction a quarter of that. A thin cylinder
is looked for at as many more as it could slip between.

Walls that meet each other are often meshed alike: their nodes stand just opposite to the joints of
faces, and go to and fro between the normals on either side. They are looked at in Gauss points.
"""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.continuum.kernel.contact import point_areas
from actuators.mechanics.continuum.kernel.shape import square_shape


@dataclass(frozen=True, eq=False)
class FacePoints:
    """``local`` (q, 2) coordinates on a face, -1 to 1; ``weights`` (q,), 4 in all; the shape
    functions' ``values`` (q, 9) and ``slopes`` (q, 2, 9) there."""

    local: np.ndarray
    weights: np.ndarray
    values: np.ndarray
    slopes: np.ndarray


def product_points(line: np.ndarray, weights: np.ndarray) -> FacePoints:
    """Points ``line`` (q,) with ``weights`` (q,) along both directions of a face."""
    local = np.stack(np.meshgrid(line, line), axis=-1).reshape(-1, 2)
    values, slopes = square_shape(local)
    return FacePoints(local, np.outer(weights, weights).ravel(), values, slopes)


def even_points(parts: int) -> FacePoints:
    """``parts`` (even) intervals along both directions, by Simpson's rule: uniform pressure makes
    the nodal forces that it should where their number is a multiple of 4."""
    weights = np.where(np.arange(parts + 1) % 2 == 1, 4.0, 2.0)
    weights[[0, -1]] = 1.0
    return product_points(np.linspace(-1, 1, parts + 1), weights * (2 / weights.sum()))


OBSTACLE_POINTS = even_points(4)
WALL_POINTS = product_points(*np.polynomial.legendre.leggauss(4))
GAUSS_POINTS = product_points(*np.polynomial.legendre.leggauss(3))
GRID_VALUES: np.ndarray = product_points(np.linspace(-1, 1, 17), np.full(17, 2 / 17)).values
"""Shape functions on a fine grid over a face, (289, 9)."""


def contact_areas(nodes: np.ndarray, faces: np.ndarray, points: FacePoints) -> np.ndarray:
    """(f, q) area [m2] that each of the ``points`` of ``faces`` (f, 9) stands for."""
    return point_areas(nodes, faces, points.slopes, points.weights)
