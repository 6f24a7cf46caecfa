"""The closest point of a quadratic face."""

import numpy as np
from numba import njit

BULGE = 0.3
"""How far a face reaches beyond the box around its nodes, over that box: a quadratic face does by
at most 0.27 of it."""
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
def dot(a: np.ndarray, b: np.ndarray) -> float:
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
        f0, f1 = dot(at[1], r), dot(at[2], r)
        m00, m11, m01 = dot(at[1], at[1]), dot(at[2], at[2]), dot(at[1], at[2])
        h00, h11, h01 = m00 - dot(r, at[3]), m11 - dot(r, at[4]), m01 - dot(r, at[5])
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
def signed(x: np.ndarray, at: np.ndarray, normal: np.ndarray) -> float:
    """Unit normal of the patch at its closest point, and the distance of ``x`` along it."""
    normal[:] = np.cross(at[1], at[2])
    normal /= np.sqrt(dot(normal, normal))
    return (
        (x[0] - at[0, 0]) * normal[0]
        + (x[1] - at[0, 1]) * normal[1]
        + (x[2] - at[0, 2]) * normal[2]
    )


@njit(cache=True)
def apart(gap: float, at: np.ndarray, where: np.ndarray) -> float:
    """Distance from the face whose closest point :func:`project` found ``gap`` away; what that lies
    beyond the edge counts twice, so that of two faces with a common edge the one is nearer whose
    side of it the point is on."""
    square = gap * gap
    for d in range(2):
        over = max(0.0, abs(where[d]) - 1.0)
        square += 4.0 * over * over * dot(at[1 + d], at[1 + d])
    return np.sqrt(square)


@njit(cache=True)
def bounding_box(nodes: np.ndarray, axes: np.ndarray, low: np.ndarray, high: np.ndarray) -> None:
    """Box about a face: ``axes`` (3, 3), its mean normal last, and its reach from the middle node
    along them."""
    for i in range(3):
        axes[0, i] = nodes[5, i] - nodes[3, i]
        axes[1, i] = nodes[7, i] - nodes[1, i]
    axes[2] = np.cross(axes[0], axes[1])
    axes[2] /= np.sqrt(dot(axes[2], axes[2]))
    axes[0] /= np.sqrt(dot(axes[0], axes[0]))
    axes[1] = np.cross(axes[2], axes[0])
    low[:] = 0.0
    high[:] = 0.0
    for n in range(9):
        for a in range(3):
            along = 0.0
            for i in range(3):
                along += axes[a, i] * (nodes[n, i] - nodes[4, i])
            low[a], high[a] = min(low[a], along), max(high[a], along)
    for a in range(3):
        more = BULGE * (high[a] - low[a])
        low[a] -= more
        high[a] += more


@njit(cache=True)
def within(
    x: np.ndarray, middle: np.ndarray, axes: np.ndarray, low: np.ndarray, high: np.ndarray,
    reach: float, depth: float,
) -> bool:  # fmt: skip
    """Whether ``x`` may have its closest point on the face, ``reach`` before it or ``depth`` behind
    it: a face bent by an angle looks sideways by as much."""
    for a in range(3):
        along = 0.0
        for i in range(3):
            along += axes[a, i] * (x[i] - middle[i])
        front, behind = reach, depth
        if a < 2:
            bent = min(1.0, 4 * (high[2] - low[2]) / (high[a] - low[a]))
            front = behind = bent * max(reach, depth)
        if along < low[a] - behind or along > high[a] + front:
            return False
    return True
