"""Eigenvalues of a symmetric 3 x 3 matrix by Jacobi rotations: accurate for equal values too."""

import numpy as np
from numba import njit


@njit(cache=True)
def symmetric_eigen(matrix: np.ndarray, values: np.ndarray, axes: np.ndarray) -> None:
    """Fills ``values`` (3,), unordered, and ``axes`` (3, 3), whose columns are the directions."""
    w = matrix.copy()
    for i in range(3):
        for j in range(3):
            axes[i, j] = 1.0 if i == j else 0.0
    scale = w[0, 0] + w[1, 1] + w[2, 2]
    for _ in range(30):
        if abs(w[0, 1]) + abs(w[0, 2]) + abs(w[1, 2]) <= 1e-17 * abs(scale):
            break
        for p in range(2):
            for q in range(p + 1, 3):
                if w[p, q] == 0.0:
                    continue
                tau = (w[q, q] - w[p, p]) / (2.0 * w[p, q])
                t = 1.0 / (abs(tau) + np.sqrt(1.0 + tau * tau))
                if tau < 0.0:
                    t = -t
                c = 1.0 / np.sqrt(1.0 + t * t)
                s = t * c
                for k in range(3):
                    x, y = w[k, p], w[k, q]
                    w[k, p], w[k, q] = c * x - s * y, s * x + c * y
                for k in range(3):
                    x, y = w[p, k], w[q, k]
                    w[p, k], w[q, k] = c * x - s * y, s * x + c * y
                for k in range(3):
                    x, y = axes[k, p], axes[k, q]
                    axes[k, p], axes[k, q] = c * x - s * y, s * x + c * y
    for i in range(3):
        values[i] = w[i, i]
