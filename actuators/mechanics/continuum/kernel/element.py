"""One 27-node hexahedron with discontinuous linear pressure (Q2/P1).

Energy: integral of W(F) + q (J - 1) - q^2 / (2 kappa), with q = q0 + q1 xi + q2 eta + q3 zeta.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.laws import (
    MOONEY_RIVLIN_LAW,
    OGDEN_LAW,
    add_i1_law,
    add_mooney_rivlin_law,
    add_ogden_law,
    add_pressure,
    inverse_transpose,
)
from actuators.mechanics.continuum.kernel.shape import (
    CUBE_SLOPES,
    CUBE_VALUES,
    CUBE_WEIGHTS,
    PRESSURE_VALUES,
)


@njit(cache=True)
def material_gradient(x: np.ndarray, g: int, slopes: np.ndarray) -> float:
    """``slopes`` (3, 27) = dN/dX at Gauss point ``g``; returns the volume it stands for [m3]."""
    jacobian = np.zeros((3, 3))
    for i in range(3):
        for d in range(3):
            for n in range(27):
                jacobian[i, d] += x[n, i] * CUBE_SLOPES[g, d, n]
    h = np.empty((3, 3))
    det = inverse_transpose(jacobian, h)
    for i in range(3):
        for n in range(27):
            slopes[i, n] = (
                h[i, 0] * CUBE_SLOPES[g, 0, n]
                + h[i, 1] * CUBE_SLOPES[g, 1, n]
                + h[i, 2] * CUBE_SLOPES[g, 2, n]
            )
    return det * CUBE_WEIGHTS[g]


@njit(cache=True)
def deformation_gradient(u: np.ndarray, slopes: np.ndarray, f: np.ndarray) -> None:
    """f = I + du/dX."""
    for i in range(3):
        for j in range(3):
            total = 1.0 if i == j else 0.0
            for n in range(27):
                total += u[n, i] * slopes[j, n]
            f[i, j] = total


@njit(cache=True)
def _add_stiffness(
    a: np.ndarray, slopes: np.ndarray, weight: float, k: np.ndarray, rows: np.ndarray
) -> None:
    """k[i, m, a, b] += weight dN_a,J A_iJmL dN_b,L for i <= m."""
    for i in range(3):
        for m in range(i, 3):
            for j in range(3):
                c0 = weight * a[3 * i + j, 3 * m]
                c1 = weight * a[3 * i + j, 3 * m + 1]
                c2 = weight * a[3 * i + j, 3 * m + 2]
                for n in range(27):
                    rows[j, n] = c0 * slopes[0, n] + c1 * slopes[1, n] + c2 * slopes[2, n]
            for p in range(27):
                s0, s1, s2 = slopes[0, p], slopes[1, p], slopes[2, p]
                for n in range(27):
                    k[i, m, p, n] += s0 * rows[0, n] + s1 * rows[1, n] + s2 * rows[2, n]


@njit(cache=True)
def integrate_element(
    x: np.ndarray,
    u: np.ndarray,
    q: np.ndarray,
    code: int,
    coefficients: np.ndarray,
    count: int,
    compliance: np.ndarray,
    body_force: np.ndarray,
    want_tangent: bool,
    r: np.ndarray,
    rq: np.ndarray,
    k: np.ndarray,
    b: np.ndarray,
    mass: np.ndarray,
) -> float:
    """Residual and tangent of one element.

    ``x``, ``u`` (27, 3); ``q`` (4,); ``compliance`` (2,): 1/kappa of the equations, and the one of
    the tangent [1/Pa]; ``body_force`` (3,) [N/m3]. Fills ``r`` (27, 3), ``rq`` (4,)
    and, when ``want_tangent``, ``k`` (3, 3, 27, 27; i <= m only), ``b`` = dr/dq (27, 3, 4) and
    ``mass`` = -drq/dq (4, 4). Returns the least J over the Gauss points.
    """
    slopes, rows = np.empty((3, 27)), np.empty((3, 27))
    f, h, p = np.empty((3, 3)), np.empty((3, 3)), np.empty((3, 3))
    a = np.empty((9, 9))
    r[:] = 0.0
    rq[:] = 0.0
    if want_tangent:
        k[:] = 0.0
        b[:] = 0.0
        mass[:] = 0.0
    least = 1e300
    for g in range(27):
        weight = material_gradient(x, g, slopes)
        deformation_gradient(u, slopes, f)
        det = inverse_transpose(f, h)
        if not det > 0.0:
            return -1.0
        least = min(least, det)
        pressure = 0.0
        for n in range(4):
            pressure += PRESSURE_VALUES[g, n] * q[n]
        p[:] = 0.0
        if want_tangent:
            a[:] = 0.0
        if code == OGDEN_LAW:
            add_ogden_law(coefficients, count, f, want_tangent, p, a)
        elif code == MOONEY_RIVLIN_LAW:
            add_mooney_rivlin_law(coefficients, f, det, h, want_tangent, p, a)
        else:
            add_i1_law(coefficients, f, det, h, want_tangent, p, a)
        add_pressure(pressure, det, h, want_tangent, p, a)
        for n in range(27):
            for i in range(3):
                inner = p[i, 0] * slopes[0, n] + p[i, 1] * slopes[1, n] + p[i, 2] * slopes[2, n]
                r[n, i] += weight * (inner - CUBE_VALUES[g, n] * body_force[i])
        for n in range(4):
            rq[n] += weight * PRESSURE_VALUES[g, n] * (det - 1.0 - pressure * compliance[0])
        if want_tangent:
            _add_stiffness(a, slopes, weight, k, rows)
            for n in range(27):
                for i in range(3):
                    s = h[i, 0] * slopes[0, n] + h[i, 1] * slopes[1, n] + h[i, 2] * slopes[2, n]
                    for m in range(4):
                        b[n, i, m] += weight * det * s * PRESSURE_VALUES[g, m]
            for n in range(4):
                for m in range(4):
                    mass[n, m] += (
                        weight * PRESSURE_VALUES[g, n] * PRESSURE_VALUES[g, m] * compliance[1]
                    )
    return least
