"""Frictionless contact of quadratic faces with rigid obstacles, and what all contact shares.

Energy: the integral over reference area of phi(g), g the signed distance of a point on one face to
the other surface (negative inside), as a sum over points of the face. phi' is minus the contact
pressure: none above ``onset``, linear with slope ``stiffness`` below ``-onset``, a parabola in
between.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.pattern import place_in_row
from actuators.mechanics.continuum.kernel.shape import SQUARE_SLOPES, SQUARE_WEIGHTS

PLANE, CYLINDER = 0, 1


@njit(cache=True)
def pressure_law(gap: float, stiffness: float, onset: float) -> tuple[float, float]:
    """Contact pressure [Pa] at ``gap`` [m], and minus its derivative [Pa/m]."""
    if gap >= onset:
        return 0.0, 0.0
    if gap <= -onset:
        return -stiffness * gap, stiffness
    return stiffness * (onset - gap) ** 2 / (4 * onset), stiffness * (onset - gap) / (2 * onset)


@njit(cache=True)
def face_areas(nodes: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(f, 9) area [m2] of each Gauss point at ``nodes`` (n, 3)."""
    return point_areas(nodes, faces, SQUARE_SLOPES, SQUARE_WEIGHTS)


@njit(cache=True)
def point_areas(
    nodes: np.ndarray, faces: np.ndarray, slopes: np.ndarray, weights: np.ndarray
) -> np.ndarray:
    """(f, q) area [m2] that each point of faces (f, 9) stands for at ``nodes`` (n, 3): the shape
    functions have ``slopes`` (q, 2, 9) there, and the points these weights (q,)."""
    areas = np.empty((len(faces), len(weights)))
    a, b = np.empty(3), np.empty(3)
    for f in range(len(faces)):
        for q in range(len(weights)):
            a[:] = 0.0
            b[:] = 0.0
            for n in range(9):
                for i in range(3):
                    a[i] += slopes[q, 0, n] * nodes[faces[f, n], i]
                    b[i] += slopes[q, 1, n] * nodes[faces[f, n], i]
            areas[f, q] = weights[q] * np.linalg.norm(np.cross(a, b))
    return areas


@njit(cache=True)
def scatter_block(
    nodes: np.ndarray,
    block: np.ndarray,
    dof: np.ndarray,
    indptr: np.ndarray,
    indices: np.ndarray,
    values: np.ndarray,
) -> bool:
    """Add a symmetric ``block`` (3 m, 3 m) of these nodes to the upper triangle; False where the
    pattern has no place for it."""
    for i in range(3 * len(nodes)):
        row = dof[nodes[i // 3], i % 3]
        if row < 0:
            continue
        for j in range(3 * len(nodes)):
            column = dof[nodes[j // 3], j % 3]
            if column < row:
                continue
            place = place_in_row(indptr, indices, row, column)
            if place == indptr[row + 1] or indices[place] != column:
                return False
            values[place] += block[i, j]
    return True


@njit(cache=True)
def rigid_gap(
    x: np.ndarray, kind: int, shape: np.ndarray, normal: np.ndarray, bend: np.ndarray
) -> float:
    """Distance of a point from the obstacle; its gradient and second derivatives.

    ``shape``: a plane's normal and offset (0:3, 3); a cylinder's axis (0:3), centre (3:6), radius.
    """
    bend[:] = 0.0
    if kind == PLANE:
        normal[:] = shape[:3]
        return normal[0] * x[0] + normal[1] * x[1] + normal[2] * x[2] - shape[3]
    along = 0.0
    for i in range(3):
        along += shape[i] * (x[i] - shape[3 + i])
    square = 0.0
    for i in range(3):
        normal[i] = x[i] - shape[3 + i] - along * shape[i]
        square += normal[i] ** 2
    distance = max(np.sqrt(square), 1e-12)
    for i in range(3):
        normal[i] /= distance
    for i in range(3):
        for j in range(3):
            bend[i, j] = -(shape[i] * shape[j] + normal[i] * normal[j]) / distance
        bend[i, i] += 1.0 / distance
    return distance - shape[6]


@njit(cache=True)
def add_rigid(
    positions: np.ndarray,
    faces: np.ndarray,
    places: np.ndarray,
    areas: np.ndarray,
    kind: int,
    shape: np.ndarray,
    stiffness: float,
    onset: float,
    residual: np.ndarray,
    want_tangent: bool,
    dof: np.ndarray,
    indptr: np.ndarray,
    indices: np.ndarray,
    values: np.ndarray,
    gaps: np.ndarray,
) -> bool:
    """Forces of one obstacle on ``faces`` (f, 9) at points that have the shape functions ``places``
    (q, 9) and stand for ``areas`` (f, q); fills ``gaps`` (f, q) [m]."""
    x, normal, bend = np.empty(3), np.empty(3), np.empty((3, 3))
    block, second = np.empty((27, 27)), np.empty((3, 3))
    complete = True
    for f in range(len(faces)):
        touched = False
        for q in range(len(places)):
            x[:] = 0.0
            for n in range(9):
                for i in range(3):
                    x[i] += places[q, n] * positions[faces[f, n], i]
            gap = rigid_gap(x, kind, shape, normal, bend)
            gaps[f, q] = gap
            pressure, slope = pressure_law(gap, stiffness, onset)
            if pressure == 0.0:
                continue
            w = areas[f, q]
            for n in range(9):
                for i in range(3):
                    residual[faces[f, n], i] -= w * pressure * places[q, n] * normal[i]
            if not want_tangent:
                continue
            if not touched:
                block[:] = 0.0
                touched = True
            for i in range(3):
                for j in range(3):
                    second[i, j] = slope * normal[i] * normal[j] - pressure * bend[i, j]
            for a in range(9):
                for b in range(9):
                    both = w * places[q, a] * places[q, b]
                    if both != 0.0:
                        for i in range(3):
                            for j in range(3):
                                block[3 * a + i, 3 * b + j] += both * second[i, j]
        if touched:
            complete &= scatter_block(faces[f], block, dof, indptr, indices, values)
    return complete
