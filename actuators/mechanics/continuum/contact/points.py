"""Where on a face the distance to the other surface is looked at, and how much area each place
stands for.

A rigid obstacle is looked for at 5 x 5 points: nodes, and the middles between them. Gauss points
leave the edges to themselves, which entered a plate by 20 times the contact's tolerance; nodes
alone leave a face that is pressed in part room to sag between them (by an eighth of what its next
node is lifted), and twice as many points along each direction a quarter of that.
"""

from dataclasses import dataclass

import numpy as np

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


OBSTACLE_POINTS = product_points(np.linspace(-1, 1, 5), np.array([1, 4, 2, 4, 1]) / 6)
"""Simpson's rule on either half: uniform pressure makes the nodal forces that it should."""
GRID_VALUES: np.ndarray = product_points(np.linspace(-1, 1, 17), np.full(17, 2 / 17)).values
"""Shape functions on a fine grid over a face, (289, 9)."""
