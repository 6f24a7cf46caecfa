"""Frictionless contact of quadratic faces with rigid obstacles, and what all contact shares.

Energy: the integral over reference area of phi(g), g the signed distance of a point on one face to
the other surface (negative inside), at the 3 x 3 Gauss points. phi' is minus the contact pressure:
none above ``onset``, linear with slope ``stiffness`` below ``-onset``, a parabola in between.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.pattern import place_in_row
from actuators.mechanics.continuum.kernel.shape import SQUARE_SLOPES, SQUARE_VALUES, SQUARE_WEIGHTS

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
    areas = np.empty((len(faces), 9))
    for f in range(len(faces)):
        for q in range(9):
            a, b = np.zeros(3), np.zeros(3)
            for n in range(9):
                for i in range(3):
                    a[i] += SQUARE_SLOPES[q, 0, n] * nodes[faces[f, n], i]
                    b[i] += SQUARE_SLOPES[q, 1, n] * nodes[faces[f, n], i]
            areas[f, q] = SQUARE_WEIGHTS[q] * np.linalg.norm(np.cross(a, b))
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
    """Forces of one obstacle on ``faces`` (f, 9); fills ``gaps`` (f, 9) [m]."""
    x, normal, bend = np.empty(3), np.empty(3), np.empty((3, 3))
    block = np.empty((27, 27))
    complete = True
    for f in range(len(faces)):
        touched = False
        for q in range(9):
            x[:] = 0.0
            for n in range(9):
                for i in range(3):
                    x[i] += SQUARE_VALUES[q, n] * positions[faces[f, n], i]
            gap = rigid_gap(x, kind, shape, normal, bend)
            gaps[f, q] = gap
            pressure, slope = pressure_law(gap, stiffness, onset)
            if pressure == 0.0:
                continue
            w = areas[f, q]
            for n in range(9):
                for i in range(3):
                    residual[faces[f, n], i] -= w * pressure * SQUARE_VALUES[q, n] * normal[i]
            if not want_tangent:
                continue
            if not touched:
                block[:] = 0.0
                touched = True
            for a in range(27):
                i, na = a % 3, w * SQUARE_VALUES[q, a // 3]
                for b in range(27):
                    j = b % 3
                    second = slope * normal[i] * normal[j] - pressure * bend[i, j]
                    block[a, b] += na * SQUARE_VALUES[q, b // 3] * second
        if touched:
            complete &= scatter_block(faces[f], block, dof, indptr, indices, values)
    return complete
