"""Three-vectors and 3 x 3 matrices in compiled code, written out: calling BLAS costs more."""

import math

import numba as nb
import numpy as np


@nb.njit(cache=True)
def turn(w: np.ndarray, rotation: np.ndarray, mean: np.ndarray) -> None:
    """Rotation by ``w`` [rad] and its mean over the way there, by series where the angle
    vanishes."""
    square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2]
    if square < 1e-2:
        s = 1 - square / 6 * (1 - square / 20 * (1 - square / 42 * (1 - square / 72)))
        c = 0.5 - square / 24 * (1 - square / 30 * (1 - square / 56 * (1 - square / 90)))
        v = 1 / 6 - square / 120 * (1 - square / 42 * (1 - square / 72 * (1 - square / 110)))
    else:
        a = math.sqrt(square)
        s = math.sin(a) / a
        c = 2 * math.sin(a / 2) ** 2 / square
        v = (1 - s) / square
    for i in range(3):
        for j in range(3):
            same = 1.0 if i == j else 0.0
            cross = 0.0
            if i != j:
                k = 3 - i - j
                cross = -w[k] if (j - i) % 3 == 1 else w[k]
            twice = w[i] * w[j] - square * same
            rotation[i, j] = same + s * cross + c * twice
            mean[i, j] = same + c * cross + v * twice


@nb.njit(cache=True)
def times(m: np.ndarray, a: np.ndarray, out: np.ndarray) -> None:
    """out = m a."""
    for i in range(3):
        out[i] = m[i, 0] * a[0] + m[i, 1] * a[1] + m[i, 2] * a[2]


@nb.njit(cache=True)
def turned_back(m: np.ndarray, a: np.ndarray, out: np.ndarray) -> None:
    """out = m^T a."""
    for i in range(3):
        out[i] = m[0, i] * a[0] + m[1, i] * a[1] + m[2, i] * a[2]


@nb.njit(cache=True)
def product(a: np.ndarray, b: np.ndarray, out: np.ndarray) -> None:
    """out = a b."""
    for i in range(3):
        for j in range(3):
            out[i, j] = a[i, 0] * b[0, j] + a[i, 1] * b[1, j] + a[i, 2] * b[2, j]


@nb.njit(cache=True)
def inverse(m: np.ndarray, out: np.ndarray) -> None:
    """out = m^-1 by cofactors."""
    for i in range(3):
        for j in range(3):
            p, q, u, v = (j + 1) % 3, (j + 2) % 3, (i + 1) % 3, (i + 2) % 3
            out[i, j] = m[p, u] * m[q, v] - m[p, v] * m[q, u]
    det = m[0, 0] * out[0, 0] + m[0, 1] * out[1, 0] + m[0, 2] * out[2, 0]
    for i in range(3):
        for j in range(3):
            out[i, j] /= det


@nb.njit(cache=True)
def add_cross(a: np.ndarray, b: np.ndarray, factor: float, out: np.ndarray) -> None:
    """out += factor a x b."""
    out[0] += factor * (a[1] * b[2] - a[2] * b[1])
    out[1] += factor * (a[2] * b[0] - a[0] * b[2])
    out[2] += factor * (a[0] * b[1] - a[1] * b[0])


@nb.njit(cache=True)
def add_double_cross(n: np.ndarray, d: np.ndarray, factor: float, out: np.ndarray) -> None:
    """out += factor times the matrix of theta -> (theta x d) x n, which is d n^T - (n . d) I."""
    dot = n[0] * d[0] + n[1] * d[1] + n[2] * d[2]
    for i in range(3):
        for j in range(3):
            out[i, j] += factor * d[i] * n[j]
        out[i, i] -= factor * dot


@nb.njit(cache=True)
def mean_and_slope(w: np.ndarray, v: np.ndarray, mean: np.ndarray, slope: np.ndarray) -> None:
    """Mean of the rotation by ``w`` [rad] over the way there, which is also its left Jacobian, and
    ``slope``: (3, 3) derivative of mean v to ``w``. By series where the angle vanishes."""
    x = w[0] * w[0] + w[1] * w[1] + w[2] * w[2]
    if x < 0.25:
        c = 0.5 - x / 24 * (1 - x / 30 * (1 - x / 56 * (1 - x / 90 * (1 - x / 132))))
        d = 1 / 6 - x / 120 * (1 - x / 42 * (1 - x / 72 * (1 - x / 110 * (1 - x / 156))))
        dc = -1 / 12 + x / 180 * (1 - x * 3 / 112 * (1 - x * 2 / 135 * (1 - x * 5 / 528)))
        dd = -1 / 60 + x / 1260 * (1 - x / 48 * (1 - x * 2 / 165 * (1 - x * 5 / 624)))
    else:
        a = math.sqrt(x)
        s = math.sin(a) / a
        c = 2 * math.sin(a / 2) ** 2 / x
        d = (1 - s) / x
        dc = (s - 2 * c) / x
        dd = (c - 3 * d) / x
    dot = w[0] * v[0] + w[1] * v[1] + w[2] * v[2]
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        across = w[j] * v[k] - w[k] * v[j]
        twice = w[i] * dot - x * v[i]
        # mean v = v + c w x v + d (w (w.v) - w.w v)
        for b in range(3):
            slope[i, b] = w[b] * (dc * across + dd * twice) + d * (w[i] * v[b] - 2 * w[b] * v[i])
        slope[i, i] += d * dot
        slope[i, j] += c * v[k]
        slope[i, k] -= c * v[j]
        mean[i, i] = 1 + d * (w[i] * w[i] - x)
        mean[i, j] = -c * w[k] + d * w[i] * w[j]
        mean[i, k] = c * w[j] + d * w[i] * w[k]
