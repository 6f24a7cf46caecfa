"""First Piola-Kirchhoff stress and its derivative for the isochoric laws.

F is (3, 3); P is (3, 3) [Pa]; the tangent dP_iJ/dF_kL is (9, 9) at [3 i + J, 3 k + L], wanted for
i <= k only: it is symmetric. Both are added to what the caller holds.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.eigen import symmetric_eigen

I1_LAW, OGDEN_LAW, MOONEY_RIVLIN_LAW = 0, 1, 2


@njit(cache=True, error_model="numpy")
def inverse_transpose(f: np.ndarray, h: np.ndarray) -> float:
    """h = F^-T; returns J = det F."""
    h[0, 0] = f[1, 1] * f[2, 2] - f[1, 2] * f[2, 1]
    h[0, 1] = f[1, 2] * f[2, 0] - f[1, 0] * f[2, 2]
    h[0, 2] = f[1, 0] * f[2, 1] - f[1, 1] * f[2, 0]
    h[1, 0] = f[0, 2] * f[2, 1] - f[0, 1] * f[2, 2]
    h[1, 1] = f[0, 0] * f[2, 2] - f[0, 2] * f[2, 0]
    h[1, 2] = f[0, 1] * f[2, 0] - f[0, 0] * f[2, 1]
    h[2, 0] = f[0, 1] * f[1, 2] - f[0, 2] * f[1, 1]
    h[2, 1] = f[0, 2] * f[1, 0] - f[0, 0] * f[1, 2]
    h[2, 2] = f[0, 0] * f[1, 1] - f[0, 1] * f[1, 0]
    det = f[0, 0] * h[0, 0] + f[0, 1] * h[0, 1] + f[0, 2] * h[0, 2]
    if det != 0.0:
        for i in range(3):
            for j in range(3):
                h[i, j] /= det
    return det


@njit(cache=True, error_model="numpy")
def add_pressure(
    q: float, det: float, h: np.ndarray, want_tangent: bool, p: np.ndarray, a: np.ndarray
) -> None:
    """q (J - 1): P += q J H, with H = F^-T. In any coordinates, see :func:`add_i1_law`."""
    s = q * det
    for i in range(3):
        for j in range(3):
            p[i, j] += s * h[i, j]
    if want_tangent:
        for i in range(3):
            for k in range(i, 3):
                for j in range(3):
                    for m in range(3):
                        a[3 * i + j, 3 * k + m] += s * (h[i, j] * h[k, m] - h[i, m] * h[k, j])


@njit(cache=True, error_model="numpy")
def add_i1_law(
    c: np.ndarray,
    first: float,
    det: float,
    f: np.ndarray,
    h: np.ndarray,
    metric: np.ndarray,
    want_tangent: bool,
    p: np.ndarray,
    a: np.ndarray,
) -> None:
    """W = C10 x + C20 x^2 + C30 x^3, x = J^(-2/3) I1 - 3 (Yeoh; neo-Hooke with C20 = C30 = 0).

    In any coordinates xi: with D_dJ = dxi_d/dX_J, ``f`` = F D^T, ``h`` = F^-T D^T, ``metric`` =
    D D^T; ``p`` and ``a`` come out as P D^T and its derivative likewise. ``first``: I1.
    """
    g = det ** (-2.0 / 3.0)
    x = g * first - 3.0
    slope = c[0] + x * (2.0 * c[1] + x * 3.0 * c[2])
    s = 2.0 * slope * g
    third = first / 3.0
    for i in range(3):
        for j in range(3):
            p[i, j] += s * (f[i, j] - third * h[i, j])
    if not want_tangent:
        return
    b = 4.0 * (2.0 * c[1] + 6.0 * c[2] * x) * g * g
    turn = 2.0 / 3.0 * s
    for i in range(3):
        for j in range(3):
            d = f[i, j] - third * h[i, j]
            for k in range(i, 3):
                for m in range(3):
                    a[3 * i + j, 3 * k + m] += (
                        (b * d - turn * h[i, j]) * f[k, m]
                        - (b * third + turn) * d * h[k, m]
                        + s * third * (h[i, m] * h[k, j])
                    )
        for j in range(3):
            for m in range(3):
                a[3 * i + j, 3 * i + m] += s * metric[j, m]


@njit(cache=True, error_model="numpy")
def add_mooney_rivlin_law(
    c: np.ndarray,
    f: np.ndarray,
    det: float,
    h: np.ndarray,
    want_tangent: bool,
    p: np.ndarray,
    a: np.ndarray,
) -> None:
    """W = C10 x + C01 y + C20 x^2 + C11 x y + C02 y^2, x = J^(-2/3) I1 - 3, y = J^(-4/3) I2 - 3."""
    right, left = np.zeros((3, 3)), np.zeros((3, 3))  # F^T F and F F^T
    for i in range(3):
        for j in range(3):
            for k in range(3):
                right[i, j] += f[k, i] * f[k, j]
                left[i, j] += f[i, k] * f[j, k]
    first = right[0, 0] + right[1, 1] + right[2, 2]
    second = 0.0
    for i in range(3):
        j = (i + 1) % 3
        second += right[i, i] * right[j, j] - right[i, j] * right[i, j]
    g = det ** (-2.0 / 3.0)
    x, y = g * first - 3.0, g * g * second - 3.0
    w1 = c[0] + 2.0 * c[2] * x + c[3] * y
    w2 = c[1] + c[3] * x + 2.0 * c[4] * y
    # x' = 2 g d, y' = 2 g^2 e; m = dI2/dF / 2
    d, e, m = np.empty((3, 3)), np.empty((3, 3)), np.empty((3, 3))
    s1, s2 = 2.0 * w1 * g, 2.0 * w2 * g * g
    for i in range(3):
        for j in range(3):
            m[i, j] = first * f[i, j]
            for k in range(3):
                m[i, j] -= f[i, k] * right[k, j]
            d[i, j] = f[i, j] - first / 3.0 * h[i, j]
            e[i, j] = m[i, j] - 2.0 / 3.0 * second * h[i, j]
            p[i, j] += s1 * d[i, j] + s2 * e[i, j]
    if not want_tangent:
        return
    b11, b12, b22 = 8.0 * c[2] * g * g, 4.0 * c[3] * g**3, 8.0 * c[4] * g**4
    both = s1 * first / 3.0 + s2 * 2.0 / 3.0 * second
    for i in range(3):
        for j in range(3):
            ahead = b11 * d[i, j] + b12 * e[i, j]
            behind = b12 * d[i, j] + b22 * e[i, j]
            turn = -2.0 / 3.0 * s1 * d[i, j] - 4.0 / 3.0 * s2 * e[i, j]
            for k in range(i, 3):
                for n in range(3):
                    value = ahead * d[k, n] + behind * e[k, n] + both * h[i, n] * h[k, j]
                    value += turn * h[k, n]
                    value -= h[i, j] * (2.0 / 3.0 * s1 * f[k, n] + 4.0 / 3.0 * s2 * m[k, n])
                    value += s2 * (2.0 * f[i, j] * f[k, n] - f[i, n] * f[k, j])
                    if i == k:
                        value -= s2 * right[j, n]
                        if j == n:
                            value += s1 + s2 * first
                    if j == n:
                        value -= s2 * left[i, k]
                    a[3 * i + j, 3 * k + n] += value


@njit(cache=True, error_model="numpy")
def add_ogden_law(
    c: np.ndarray, count: int, f: np.ndarray, want_tangent: bool, p: np.ndarray, a: np.ndarray
) -> None:
    """W = sum m/alpha (l1^alpha + l2^alpha + l3^alpha - 3) of isochoric stretches.

    ``c`` holds m1, alpha1, m2, ...; ``count`` numbers. Worked in principal axes; differences
    are taken through expm1 of logarithmic stretches: exact where stretches coincide and for tiny
    alpha.
    """
    cauchy_green = np.zeros((3, 3))
    for i in range(3):
        for j in range(3):
            for k in range(3):
                cauchy_green[i, j] += f[k, i] * f[k, j]
    axes = np.empty((3, 3))
    square = np.empty(3)
    symmetric_eigen(cauchy_green, square, axes)
    log = np.empty(3)
    for i in range(3):
        log[i] = 0.5 * np.log(square[i])
    mean = (log[0] + log[1] + log[2]) / 3.0
    # beta_i = dW/dlog(l_i); db = its derivative; over = (beta_i - beta_j)/(l_i^2 - l_j^2)
    beta, e = np.zeros(3), np.empty(3)
    db, over = np.zeros((3, 3)), np.zeros((3, 3))
    for t in range(0, count, 2):
        m, alpha = c[t], c[t + 1]
        for i in range(3):
            e[i] = np.expm1(alpha * (log[i] - mean))
        total = e[0] + e[1] + e[2]
        for i in range(3):
            beta[i] += m * (e[i] - total / 3.0)
        if not want_tangent:
            continue
        for i in range(3):
            for j in range(3):
                own = 1.0 + e[i] if i == j else 0.0
                db[i, j] += m * alpha * (own - (2.0 + e[i] + e[j]) / 3.0 + (3.0 + total) / 9.0)
            for j in range(i):
                gap = log[i] - log[j]
                ratio = alpha / 2.0
                if abs(gap) > 1e-12:
                    ratio = np.expm1(alpha * gap) / np.expm1(2.0 * gap)
                over[i, j] += m * (1.0 + e[j]) / square[j] * ratio
                over[j, i] = over[i, j]
    n = np.empty((3, 3))  # n[:, i] = F N_i
    for i in range(3):
        for r in range(3):
            n[r, i] = f[r, 0] * axes[0, i] + f[r, 1] * axes[1, i] + f[r, 2] * axes[2, i]
    for i in range(3):
        s = beta[i] / square[i]
        for r in range(3):
            for k in range(3):
                p[r, k] += s * n[r, i] * axes[k, i]
    if want_tangent:
        _add_spectral_tangent(beta, db, over, square, n, axes, a)


@njit(cache=True, error_model="numpy")
def _add_spectral_tangent(
    beta: np.ndarray,
    db: np.ndarray,
    over: np.ndarray,
    square: np.ndarray,
    n: np.ndarray,
    axes: np.ndarray,
    a: np.ndarray,
) -> None:
    """Tangent from principal values: S_i = beta_i / l_i^2 along N_i, n_i = F N_i.

    Sum of nine products of (3, 3) tensors n_i N_j, plus the stress between equal components.
    """
    mixed, right = np.empty((9, 9)), np.zeros((9, 9))
    for i in range(3):
        for j in range(3):
            for r in range(3):
                for p in range(3):
                    mixed[3 * i + j, 3 * r + p] = n[r, i] * axes[p, j]
    for i in range(3):
        for j in range(3):
            at = 3 * i + j
            scale = square[i] * square[j]
            normal, shear = db[i, j] / scale, 0.0
            if i == j:
                normal -= 2.0 * beta[i] / scale
            else:
                shear = over[i, j] / square[i] - beta[j] / scale
            for q in range(9):
                right[at, q] += shear * (mixed[at, q] + mixed[3 * j + i, q])
                right[4 * i, q] += normal * mixed[4 * j, q]
    for row in range(9):
        for at in range(9):
            factor = mixed[at, row]
            for column in range(9):
                a[row, column] += factor * right[at, column]
    for i in range(3):
        s = beta[i] / square[i]
        for j in range(3):
            for m in range(3):
                both = s * axes[j, i] * axes[m, i]
                for r in range(3):
                    a[3 * r + j, 3 * r + m] += both
