"""Static condensation: the node inside an element and its four pressures leave the global system.

Outer unknown 3 n + i of local node n (the centre left out, so that n runs to 25); inner unknowns
are the centre's three displacements, then the four pressures.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.tensor import BLOCK, PLACE

OUTER, INNER, CENTRE = 78, 7, 13


@njit(cache=True)
def invert_inner(a: np.ndarray, out: np.ndarray) -> bool:
    """Inverse of the (7, 7) inner block by Gauss-Jordan; False where it is singular."""
    stiff, coupling = 0.0, 0.0
    for i in range(3):
        for j in range(3):
            stiff = max(stiff, abs(a[i, j]))
        for j in range(3, INNER):
            coupling = max(coupling, abs(a[i, j]))
    # pressures are scaled to displacements, so that pivots can be compared
    scale = stiff / coupling if coupling > 0.0 else 1.0
    work = np.empty((INNER, 2 * INNER))
    for i in range(INNER):
        si = scale if i >= 3 else 1.0
        for j in range(INNER):
            sj = scale if j >= 3 else 1.0
            work[i, j] = a[i, j] * si * sj
            work[i, INNER + j] = 1.0 if i == j else 0.0
    for c in range(INNER):
        best = c
        for i in range(c + 1, INNER):
            if abs(work[i, c]) > abs(work[best, c]):
                best = i
        pivot = work[best, c]
        if not abs(pivot) > 0.0:
            return False
        for j in range(2 * INNER):
            hold = work[best, j]
            work[best, j] = work[c, j]
            work[c, j] = hold / pivot
        for i in range(INNER):
            if i != c:
                factor = work[i, c]
                for j in range(2 * INNER):
                    work[i, j] -= factor * work[c, j]
    for i in range(INNER):
        si = scale if i >= 3 else 1.0
        for j in range(INNER):
            sj = scale if j >= 3 else 1.0
            out[i, j] = work[i, INNER + j] * si * sj
    return True


@njit(cache=True)
def condense_element(
    k: np.ndarray,
    b: np.ndarray,
    mass: np.ndarray,
    stiffness: np.ndarray,
    recover: np.ndarray,
    inner_inverse: np.ndarray,
) -> bool:
    """Fills ``stiffness`` (78, 78; upper half), ``recover`` (7, 78) = Kzz^-1 Kzo and
    ``inner_inverse`` (7, 7) = Kzz^-1. False where the inner block is singular."""
    inner = np.empty((INNER, INNER))
    to_outer = np.empty((INNER, OUTER))
    for i in range(3):
        for j in range(3):
            inner[i, j] = k[PLACE[CENTRE, CENTRE], BLOCK[i, j]]
        for m in range(4):
            inner[i, 3 + m] = b[CENTRE, i, m]
            inner[3 + m, i] = b[CENTRE, i, m]
    for n in range(4):
        for m in range(4):
            inner[3 + n, 3 + m] = -mass[n, m]
    if not invert_inner(inner, inner_inverse):
        return False
    for p in range(26):
        node = p if p < CENTRE else p + 1
        for m in range(3):
            for i in range(3):
                place = PLACE[CENTRE, node] if i <= m else PLACE[node, CENTRE]
                to_outer[i, 3 * p + m] = k[place, BLOCK[i, m]]
            for n in range(4):
                to_outer[3 + n, 3 * p + m] = b[node, m, n]
    for z in range(INNER):
        for c in range(OUTER):
            recover[z, c] = 0.0
        for y in range(INNER):
            factor = inner_inverse[z, y]
            for c in range(OUTER):
                recover[z, c] += factor * to_outer[y, c]
    for p in range(26):
        row = p if p < CENTRE else p + 1
        for i in range(3):
            r = 3 * p + i
            for n in range(p, 26):
                column = n if n < CENTRE else n + 1
                ahead, back = PLACE[row, column], PLACE[column, row]
                for m in range(3):
                    stiffness[r, 3 * n + m] = k[ahead if i <= m else back, BLOCK[i, m]]
            for z in range(INNER):
                factor = to_outer[z, r]
                for c in range(3 * p, OUTER):
                    stiffness[r, c] -= factor * recover[z, c]
    return True


@njit(cache=True)
def condense_residual(
    elements: np.ndarray,
    residual: np.ndarray,
    inner_residual: np.ndarray,
    recover: np.ndarray,
    dof: np.ndarray,
    out: np.ndarray,
) -> None:
    """``out`` (free unknowns) = outer residual - Koz Kzz^-1 inner residual."""
    out[:] = 0.0
    for n in range(len(residual)):
        for i in range(3):
            if dof[n, i] >= 0:
                out[dof[n, i]] += residual[n, i]
    inner = np.empty(INNER)
    for e in range(len(elements)):
        for i in range(3):
            inner[i] = residual[elements[e, CENTRE], i]
        for m in range(4):
            inner[3 + m] = inner_residual[e, m]
        for p in range(26):
            node = elements[e, p if p < CENTRE else p + 1]
            for i in range(3):
                d = dof[node, i]
                if d >= 0:
                    total = 0.0
                    for z in range(INNER):
                        total += recover[e, z, 3 * p + i] * inner[z]
                    out[d] -= total


@njit(cache=True)
def expand_correction(
    elements: np.ndarray,
    residual: np.ndarray,
    inner_residual: np.ndarray,
    recover: np.ndarray,
    inner_inverse: np.ndarray,
    dof: np.ndarray,
    solution: np.ndarray,
    du: np.ndarray,
    dq: np.ndarray,
) -> None:
    """Full correction ``du`` (n, 3), ``dq`` (m, 4) from the ``solution`` of the free unknowns.

    Solves Kzz dz = -rz - Kzo du inside every element; with zero residuals it is the answer to a
    load on the outer unknowns alone.
    """
    for n in range(len(dof)):
        for i in range(3):
            du[n, i] = solution[dof[n, i]] if dof[n, i] >= 0 else 0.0
    inner = np.empty(INNER)
    for e in range(len(elements)):
        for i in range(3):
            inner[i] = residual[elements[e, CENTRE], i]
        for m in range(4):
            inner[3 + m] = inner_residual[e, m]
        for z in range(INNER):
            value = 0.0
            for y in range(INNER):
                value -= inner_inverse[e, z, y] * inner[y]
            for p in range(26):
                node = elements[e, p if p < CENTRE else p + 1]
                for i in range(3):
                    value -= recover[e, z, 3 * p + i] * du[node, i]
            if z < 3:
                du[elements[e, CENTRE], z] = value
            else:
                dq[e, z - 3] = value
