"""Frictionless contact of quadratic faces with each other.

Points of one face are projected on the other; the law and the energy are those of
:mod:`actuators.mechanics.continuum.kernel.contact`.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.contact import pressure_law, scatter_block
from actuators.mechanics.continuum.kernel.shape import SQUARE_VALUES

MOST_TURNING = 2.0
"""Contact pressure, over that at a penetration of ``onset``, up to which the tangent knows that
pressed surfaces turn. Beyond, only a state on the way to equilibrium lies; there it misleads."""
BEYOND_EDGE = 0.02
"""How far past its edge, in local coordinates, a face still stops points: no cracks between the
faces of a bent surface."""
_STEPS = 12


@njit(cache=True)
def _patch(nodes: np.ndarray, xi: float, eta: float, value: np.ndarray, at: np.ndarray) -> None:
    """Shape functions and their derivatives (6, 9) [1, xi, eta, xi xi, eta eta, xi eta], and the
    same of the position (6, 3), at one point of a face."""
    for n in range(9):
        u = _line(xi, n % 3)
        v = _line(eta, n // 3)
        value[0, n] = u[0] * v[0]
        value[1, n] = u[1] * v[0]
        value[2, n] = u[0] * v[1]
        value[3, n] = u[2] * v[0]
        value[4, n] = u[0] * v[2]
        value[5, n] = u[1] * v[1]
    for d in range(6):
        for i in range(3):
            at[d, i] = 0.0
            for n in range(9):
                at[d, i] += value[d, n] * nodes[n, i]


@njit(cache=True)
def _line(x: float, n: int) -> tuple[float, float, float]:
    if n == 0:
        return x * (x - 1) / 2, x - 0.5, 1.0
    if n == 1:
        return 1 - x * x, -2 * x, -2.0
    return x * (x + 1) / 2, x + 0.5, 1.0


@njit(cache=True)
def _dot(a: np.ndarray, b: np.ndarray) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@njit(cache=True)
def project(
    x: np.ndarray, nodes: np.ndarray, value: np.ndarray, at: np.ndarray, where: np.ndarray
) -> bool:
    """Closest point to ``x`` (3,) on the face with ``nodes`` (9, 3), by Newton's method: its local
    coordinates in ``where`` (2,), shape functions and position as :func:`_patch` has them."""
    where[0] = 0.0
    where[1] = 0.0
    r = np.empty(3)
    for _ in range(_STEPS):
        _patch(nodes, where[0], where[1], value, at)
        for i in range(3):
            r[i] = x[i] - at[0, i]
        f0, f1 = _dot(at[1], r), _dot(at[2], r)
        m00, m11, m01 = _dot(at[1], at[1]), _dot(at[2], at[2]), _dot(at[1], at[2])
        h00, h11, h01 = m00 - _dot(r, at[3]), m11 - _dot(r, at[4]), m01 - _dot(r, at[5])
        det = h00 * h11 - h01 * h01
        if det <= 0.1 * (m00 * m11 - m01 * m01) or h00 <= 0.0:  # too curved: without curvature
            h00, h11, h01 = m00, m11, m01
            det = h00 * h11 - h01 * h01
        d0, d1 = (h11 * f0 - h01 * f1) / det, (h00 * f1 - h01 * f0) / det
        if abs(d0) < 1e-12 and abs(d1) < 1e-12:
            break
        new0 = min(1.5, max(-1.5, where[0] + d0))
        new1 = min(1.5, max(-1.5, where[1] + d1))
        if new0 == where[0] and new1 == where[1]:  # held at the limit
            return False
        where[0], where[1] = new0, new1
    return max(abs(where[0]), abs(where[1])) <= 1 + BEYOND_EDGE


@njit(cache=True)
def _signed(x: np.ndarray, at: np.ndarray, normal: np.ndarray) -> float:
    """Unit normal of the patch at its closest point, and the distance of ``x`` along it."""
    normal[:] = np.cross(at[1], at[2])
    normal /= np.sqrt(_dot(normal, normal))
    return (
        (x[0] - at[0, 0]) * normal[0]
        + (x[1] - at[0, 1]) * normal[1]
        + (x[2] - at[0, 2]) * normal[2]
    )


@njit(cache=True)
def find_opposite(
    positions: np.ndarray,
    faces: np.ndarray,
    start: np.ndarray,
    candidates: np.ndarray,
    reach: float,
    depth: float,
    partner: np.ndarray,
    gaps: np.ndarray,
) -> None:
    """Nearest opposite face of each Gauss point: its place in ``candidates`` in ``partner`` (f, 9),
    -1 where there is none within ``reach`` before or ``depth`` behind it; the distance in ``gaps``.

    The candidates of face f are ``candidates[start[f] : start[f + 1]]``.
    """
    value, at, where = np.empty((6, 9)), np.empty((6, 3)), np.empty(2)
    x, normal, nodes = np.empty(3), np.empty(3), np.empty((9, 3))
    partner[:] = -1
    gaps[:] = reach
    for f in range(len(faces)):
        for c in range(start[f], start[f + 1]):
            radius = 0.0
            for n in range(9):
                for i in range(3):
                    nodes[n, i] = positions[faces[candidates[c], n], i]
            for n in range(9):
                square = 0.0
                for i in range(3):
                    square += (nodes[n, i] - nodes[4, i]) ** 2
                radius = max(radius, np.sqrt(square))
            far = 1.1 * radius + max(reach, depth)
            for q in range(9):
                square = 0.0
                for i in range(3):
                    x[i] = 0.0
                    for n in range(9):
                        x[i] += SQUARE_VALUES[q, n] * positions[faces[f, n], i]
                    square += (x[i] - nodes[4, i]) ** 2
                if square > far * far or not project(x, nodes, value, at, where):
                    continue
                gap = _signed(x, at, normal)
                if -depth < gap < reach and (partner[f, q] < 0 or abs(gap) < abs(gaps[f, q])):
                    partner[f, q] = c
                    gaps[f, q] = gap


@njit(cache=True)
def add_facing(
    positions: np.ndarray,
    faces: np.ndarray,
    areas: np.ndarray,
    start: np.ndarray,
    candidates: np.ndarray,
    partner: np.ndarray,
    stiffness: float,
    onset: float,
    residual: np.ndarray,
    want_tangent: bool,
    dof: np.ndarray,
    indptr: np.ndarray,
    indices: np.ndarray,
    values: np.ndarray,
) -> bool:
    """Forces between opposite faces found by :func:`find_opposite`."""
    value, at, where = np.empty((6, 9)), np.empty((6, 3)), np.empty(2)
    x, normal, nodes = np.empty(3), np.empty(3), np.empty((9, 3))
    both = np.empty(18, dtype=np.int64)
    gradient, block = np.empty(54), np.empty((54, 54))
    along, turn = np.empty((2, 54)), np.empty((2, 54))
    complete = True
    for f in range(len(faces)):
        for c in range(start[f], start[f + 1]):
            touched = False
            for q in range(9):
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
                        x[i] += SQUARE_VALUES[q, n] * positions[faces[f, n], i]
                project(x, nodes, value, at, where)
                gap = _signed(x, at, normal)
                pressure, slope = pressure_law(gap, stiffness, onset)
                if pressure == 0.0:
                    continue
                w = areas[f, q]
                for n in range(9):
                    for i in range(3):
                        gradient[3 * n + i] = SQUARE_VALUES[q, n] * normal[i]
                        gradient[27 + 3 * n + i] = -value[0, n] * normal[i]
                        for d in range(2):
                            along[d, 3 * n + i] = SQUARE_VALUES[q, n] * at[1 + d, i]
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
                turning = w * min(pressure, MOST_TURNING * stiffness * onset)
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
    m[0, 0], m[1, 1], m[0, 1] = _dot(at[1], at[1]), _dot(at[2], at[2]), _dot(at[1], at[2])
    k[0, 0], k[1, 1], k[0, 1] = _dot(normal, at[3]), _dot(normal, at[4]), _dot(normal, at[5])
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
