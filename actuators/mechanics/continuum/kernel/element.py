"""One 27-node hexahedron with discontinuous linear pressure (Q2/P1).

Energy: integral of W(F) + q (J - 1) - q^2 / (2 kappa), with q = q0 + q1 xi + q2 eta + q3 zeta.
Everything is worked in the element's own coordinates xi, so that sums over its 27 points can be
taken direction by direction.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.laws import (
    I1_LAW,
    OGDEN_LAW,
    add_i1_law,
    add_mooney_rivlin_law,
    add_ogden_law,
    add_pressure,
    inverse_transpose,
)
from actuators.mechanics.continuum.kernel.shape import (
    CUBE_VALUES,
    CUBE_WEIGHTS,
    PRESSURE_VALUES,
)
from actuators.mechanics.continuum.kernel.tensor import (
    BLOCK,
    nodal_forces,
    nodal_gradients,
    nodal_stiffness,
)


@njit(cache=True, error_model="numpy")
def _times_transposed(a: np.ndarray, b: np.ndarray, out: np.ndarray) -> None:
    """out = a b^T, (3, 3) each."""
    for i in range(3):
        for d in range(3):
            out[i, d] = a[i, 0] * b[d, 0] + a[i, 1] * b[d, 1] + a[i, 2] * b[d, 2]


@njit(cache=True, error_model="numpy")
def _carry_over(xi: np.ndarray, p: np.ndarray, a: np.ndarray, want_tangent: bool) -> None:
    """Stress and tangent (i <= k) from coordinates X to the element's, ``xi`` (3, 3) = dxi/dX."""
    hold, half = np.empty((3, 3)), np.empty((3, 3))
    hold[:] = p
    _times_transposed(hold, xi, p)
    if not want_tangent:
        return
    for i in range(3):
        for k in range(i, 3):
            for j in range(3):
                for m in range(3):
                    hold[j, m] = a[3 * i + j, 3 * k + m]
            _times_transposed(hold, xi, half)
            for d in range(3):
                for e in range(3):
                    a[3 * i + d, 3 * k + e] = (
                        xi[d, 0] * half[0, e] + xi[d, 1] * half[1, e] + xi[d, 2] * half[2, e]
                    )


@njit(cache=True, error_model="numpy")
def _deformation(
    gradients: np.ndarray, g: int, xi: np.ndarray, f: np.ndarray, jacobian: np.ndarray
) -> float:
    """``xi`` (3, 3) = dxi_d/dX_J and ``f`` = I + du/dX at Gauss point ``g``; returns the volume
    it stands for [m3]. ``jacobian``: room."""
    for i in range(3):
        for d in range(3):
            jacobian[d, i] = gradients[d, g, i]
    det = inverse_transpose(jacobian, xi)
    for i in range(3):
        for j in range(3):
            f[i, j] = (
                gradients[0, g, 3 + i] * xi[0, j]
                + gradients[1, g, 3 + i] * xi[1, j]
                + gradients[2, g, 3 + i] * xi[2, j]
            )
        f[i, i] += 1.0
    return det * CUBE_WEIGHTS[g]


@njit(cache=True, error_model="numpy")
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
    the tangent [1/Pa]; ``body_force`` (3,) [N/m3]. Fills ``r`` (27, 3), ``rq`` (4,) and, when
    ``want_tangent``, ``k`` (729, 6; see ``kernel.tensor``), ``b`` = dr/dq (27, 3, 4) and ``mass`` =
    -drq/dq (4, 4). Returns the least J over the Gauss points.
    """
    xi, f, h = np.empty((3, 3)), np.empty((3, 3)), np.empty((3, 3))
    f_xi, h_xi, metric = np.empty((3, 3)), np.empty((3, 3)), np.empty((3, 3))
    p, a = np.empty((3, 3)), np.empty((9, 9))
    fields, gradients = np.empty((27, 6)), np.empty((3, 27, 6))
    components = 15 if want_tangent else 3
    flux, force = np.empty((3, 27, components)), np.empty((27, components))
    tangent = np.empty((9, 9, 3, 6))
    for n in range(27):
        for i in range(3):
            fields[n, i] = x[n, i]
            fields[n, 3 + i] = u[n, i]
    nodal_gradients(fields, gradients)
    r[:] = 0.0
    rq[:] = 0.0
    mass[:] = 0.0
    least = 1e300
    for g in range(27):
        weight = _deformation(gradients, g, xi, f, p)
        det = inverse_transpose(f, h)
        if not det > 0.0:
            return -1.0
        least = min(least, det)
        pressure = 0.0
        for n in range(4):
            pressure += PRESSURE_VALUES[g, n] * q[n]
        _times_transposed(h, xi, h_xi)
        p[:] = 0.0
        if want_tangent:
            a[:] = 0.0
        if code != I1_LAW:
            if code == OGDEN_LAW:
                add_ogden_law(coefficients, count, f, want_tangent, p, a)
            else:
                add_mooney_rivlin_law(coefficients, f, det, h, want_tangent, p, a)
            _carry_over(xi, p, a, want_tangent)
        else:
            first = 0.0
            for i in range(3):
                first += f[i, 0] * f[i, 0] + f[i, 1] * f[i, 1] + f[i, 2] * f[i, 2]
            _times_transposed(f, xi, f_xi)
            _times_transposed(xi, xi, metric)
            add_i1_law(coefficients, first, det, f_xi, h_xi, metric, want_tangent, p, a)
        add_pressure(pressure, det, h_xi, want_tangent, p, a)
        for d in range(3):
            for i in range(3):
                flux[d, g, i] = weight * p[i, d]
        for n in range(27):
            share = weight * CUBE_VALUES[g, n]
            for i in range(3):
                r[n, i] -= share * body_force[i]
        gap = weight * (det - 1.0 - pressure * compliance[0])
        for n in range(4):
            rq[n] += gap * PRESSURE_VALUES[g, n]
        if want_tangent:
            for d in range(3):
                for i in range(3):
                    s = weight * det * h_xi[i, d]
                    for m in range(4):
                        flux[d, g, 3 + 4 * i + m] = s * PRESSURE_VALUES[g, m]
            for i in range(3):
                for m in range(i, 3):
                    for d in range(3):
                        for e in range(3):
                            tangent[3 * d + e, g // 3, g % 3, BLOCK[i, m]] = (
                                weight * a[3 * i + d, 3 * m + e]
                            )
            for n in range(4):
                s = weight * compliance[1] * PRESSURE_VALUES[g, n]
                for m in range(4):
                    mass[n, m] += s * PRESSURE_VALUES[g, m]
    nodal_forces(flux, force)
    for n in range(27):
        for i in range(3):
            r[n, i] += force[n, i]
    if want_tangent:
        for n in range(27):
            for i in range(3):
                for m in range(4):
                    b[n, i, m] = force[n, 3 + 4 * i + m]
        nodal_stiffness(tangent, k.reshape(-1))
    return least
