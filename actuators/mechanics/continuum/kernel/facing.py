"""Frictionless contact of quadratic faces with each other.

Points of one face are projected on the other; the law and the energy are those of
:mod:`actuators.mechanics.continuum.kernel.contact`.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.closest import (
    apart,
    bounding_box,
    dot,
    project,
    signed,
    within,
)
from actuators.mechanics.continuum.kernel.contact import pressure_law, scatter_block


@njit(cache=True)
def find_opposite(
    positions: np.ndarray,
    faces: np.ndarray,
    places: np.ndarray,
    start: np.ndarray,
    candidates: np.ndarray,
    reach: float,
    depth: float,
    partner: np.ndarray,
    gaps: np.ndarray,
) -> None:
    """Nearest opposite face of each point of faces (f, 9) that has the shape functions ``places``
    (q, 9): its place in ``candidates`` in ``partner`` (f, q), -1 where there is none within
    ``reach`` before or ``depth`` behind it; the distance in ``gaps``. Nearest is the face itself,
    not what it would be beyond its edge: where two faces meet at an angle, the distance would jump
    from one to the other.

    The candidates of face f are ``candidates[start[f] : start[f + 1]]``.
    """
    value, at, where = np.empty((6, 9)), np.empty((6, 3)), np.empty(2)
    points, normal, nodes = np.empty((len(places), 3)), np.empty(3), np.empty((9, 3))
    axes, low, high = np.empty((3, 3)), np.empty(3), np.empty(3)
    nearest = np.empty(len(places))
    partner[:] = -1
    gaps[:] = reach
    for f in range(len(faces)):
        if start[f] == start[f + 1]:
            continue
        for q in range(len(places)):
            for i in range(3):
                points[q, i] = 0.0
                for n in range(9):
                    points[q, i] += places[q, n] * positions[faces[f, n], i]
        nearest[:] = np.inf
        for c in range(start[f], start[f + 1]):
            for n in range(9):
                for i in range(3):
                    nodes[n, i] = positions[faces[candidates[c], n], i]
            bounding_box(nodes, axes, low, high)
            for q in range(len(places)):
                if not within(points[q], nodes[4], axes, low, high, reach, depth):
                    continue
                if not project(points[q], nodes, value, at, where):
                    continue
                gap = signed(points[q], at, normal)
                away = apart(gap, at, where)
                if -depth < gap < reach and away < nearest[q]:
                    nearest[q] = away
                    partner[f, q] = c
                    gaps[f, q] = gap


@njit(cache=True)
def add_facing(
    positions: np.ndarray,
    faces: np.ndarray,
    places: np.ndarray,
    areas: np.ndarray,
    start: np.ndarray,
    candidates: np.ndarray,
    partner: np.ndarray,
    stiffness: float,
    onset: float,
    most_turning: float,
    residual: np.ndarray,
    want_tangent: bool,
    dof: np.ndarray,
    indptr: np.ndarray,
    indices: np.ndarray,
    values: np.ndarray,
) -> bool:
    """Forces between opposite faces found by :func:`find_opposite`. The tangent knows that pressed
    surfaces turn up to a contact pressure ``most_turning`` [Pa]."""
    value, at, where = np.empty((6, 9)), np.empty((6, 3)), np.empty(2)
    x, normal, nodes = np.empty(3), np.empty(3), np.empty((9, 3))
    both = np.empty(18, dtype=np.int64)
    gradient, block = np.empty(54), np.empty((54, 54))
    along, turn = np.empty((2, 54)), np.empty((2, 54))
    complete = True
    for f in range(len(faces)):
        for c in range(start[f], start[f + 1]):
            touched = False
            for q in range(len(places)):
                if partner[f, q] != c:
                    continue
                for n in range(9):
                    both[n] = faces[f, n]
                    both[9 + n] = faces[candidates[c], n]
                    for i in range(3):
                        nodes[n, i] = positions[both[9 + n], i]
                for i in range(3):
                    x[i] = 0.0
                    for n in range(9):
                        x[i] += places[q, n] * positions[faces[f, n], i]
                project(x, nodes, value, at, where)
                gap = signed(x, at, normal)
                pressure, slope = pressure_law(gap, stiffness, onset)
                if pressure == 0.0:
                    continue
                w = areas[f, q]
                for n in range(9):
                    for i in range(3):
                        gradient[3 * n + i] = places[q, n] * normal[i]
                        gradient[27 + 3 * n + i] = -value[0, n] * normal[i]
                        for d in range(2):
                            along[d, 3 * n + i] = places[q, n] * at[1 + d, i]
                            along[d, 27 + 3 * n + i] = -value[0, n] * at[1 + d, i]
                            turn[d, 3 * n + i] = 0.0
                            turn[d, 27 + 3 * n + i] = value[1 + d, n] * normal[i]
                for a in range(54):
                    residual[both[a // 3], a % 3] -= w * pressure * gradient[a]
                if not want_tangent:
                    continue
                if not touched:
                    block[:] = 0.0
                    touched = True
                turning = w * min(pressure, most_turning)
                _add_second(block, gap, turning, w * slope, gradient, along, turn, at, normal)
            if touched:
                complete &= scatter_block(both, block, dof, indptr, indices, values)
    return complete


@njit(cache=True)
def _add_second(
    block: np.ndarray,
    gap: float,
    force: float,
    slope: float,
    gradient: np.ndarray,
    along: np.ndarray,
    turn: np.ndarray,
    at: np.ndarray,
    normal: np.ndarray,
) -> None:
    """slope grad g grad g^T - force grad grad g, of the distance to the closest point.

    With tangents a, metric m, curvature k, H = m - g k, A the motion along the tangents and T the
    turning of the normal: grad grad g = -(A m^-1 k H^-1 A^T + A H^-1 T^T + T H^-1 A^T + g T H^-1
    T^T), from the second derivative of the least distance with its local coordinates eliminated.
    """
    m, k = np.empty((2, 2)), np.empty((2, 2))
    m[0, 0], m[1, 1], m[0, 1] = dot(at[1], at[1]), dot(at[2], at[2]), dot(at[1], at[2])
    k[0, 0], k[1, 1], k[0, 1] = dot(normal, at[3]), dot(normal, at[4]), dot(normal, at[5])
    m[1, 0], k[1, 0] = m[0, 1], k[0, 1]
    h = _inverse(m - gap * k)
    bend = _product(_product(_inverse(m), k), h)
    for a in range(54):
        # rows of the three matrices that multiply A^T and T^T
        p0 = along[0, a] * bend[0, 0] + along[1, a] * bend[1, 0]
        p1 = along[0, a] * bend[0, 1] + along[1, a] * bend[1, 1]
        t0 = turn[0, a] * h[0, 0] + turn[1, a] * h[1, 0]
        t1 = turn[0, a] * h[0, 1] + turn[1, a] * h[1, 1]
        s0 = along[0, a] * h[0, 0] + along[1, a] * h[1, 0] + gap * t0
        s1 = along[0, a] * h[0, 1] + along[1, a] * h[1, 1] + gap * t1
        for b in range(54):
            block[a, b] += slope * gradient[a] * gradient[b] + force * (
                (p0 + t0) * along[0, b]
                + (p1 + t1) * along[1, b]
                + s0 * turn[0, b]
                + s1 * turn[1, b]
            )


@njit(cache=True)
def _inverse(m: np.ndarray) -> np.ndarray:
    det = m[0, 0] * m[1, 1] - m[0, 1] * m[1, 0]
    out = np.empty((2, 2))
    out[0, 0], out[1, 1] = m[1, 1] / det, m[0, 0] / det
    out[0, 1], out[1, 0] = -m[0, 1] / det, -m[1, 0] / det
    return out


@njit(cache=True)
def _product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    out = np.zeros((2, 2))
    for i in range(2):
        for j in range(2):
            for k in range(2):
                out[i, j] += a[i, k] * b[k, j]
    return out
