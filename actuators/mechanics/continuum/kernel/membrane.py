"""Embedded sheet: resists stretch along X1, bends freely, has no stiffness across.

Energy per undeformed area K/2 (lambda - 1)^2, lambda = |dx/dX1| along the sheet, with the force
N = K (lambda - 1) as an unknown of its own (see ``continuum.sheets``). Two Gauss points
along X1: there the slope of a quadratic is as exact as that of a cubic, so that an inextensible
sheet costs one condition for every unknown along it, not more (no membrane locking). Three across.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.shape import square_shape
from actuators.mechanics.continuum.kernel.tensor import BLOCK, PLACE


def _points(first: int, second: int) -> tuple[np.ndarray, np.ndarray]:
    """Gauss points (first * second, 2) of the square and their weights."""
    x, wx = np.polynomial.legendre.leggauss(first)
    y, wy = np.polynomial.legendre.leggauss(second)
    grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    return grid, np.outer(wx, wy).ravel()


_ALONG, _ACROSS = _points(2, 3), _points(3, 2)
# [0]: the square's first direction runs along X1; [1]: its second
SHEET_SLOPES: np.ndarray = np.ascontiguousarray(
    np.stack([square_shape(_ALONG[0])[1], square_shape(_ACROSS[0])[1]])
)
SHEET_WEIGHTS: np.ndarray = np.stack([_ALONG[1], _ACROSS[1]])
SHEET_POINTS = 6
_CENTRE_SLOPES: np.ndarray = square_shape(np.zeros((1, 2)))[1][0]


@njit(cache=True)
def _across_x1(x: np.ndarray, nodes: np.ndarray) -> int:
    """0 where the face's first direction is the one nearer to X1, else 1."""
    share = np.zeros(2)
    for d in range(2):
        along, length = 0.0, 0.0
        for i in range(3):
            tangent = 0.0
            for n in range(9):
                tangent += _CENTRE_SLOPES[d, n] * x[nodes[n], i]
            length += tangent * tangent
            if i == 0:
                along = tangent * tangent
        share[d] = along / length
    return 0 if share[0] >= share[1] else 1


@njit(cache=True)
def fibre_slopes(x: np.ndarray, nodes: np.ndarray, which: int, g: int, slope: np.ndarray) -> float:
    """``slope`` (9,) = dN/dX1 along the undeformed sheet; returns the area it stands for [m2].

    X1 is laid into the sheet's plane where the sheet is not parallel to it.
    """
    a, b = np.zeros(3), np.zeros(3)
    for n in range(9):
        for i in range(3):
            a[i] += SHEET_SLOPES[which, g, 0, n] * x[nodes[n], i]
            b[i] += SHEET_SLOPES[which, g, 1, n] * x[nodes[n], i]
    aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2]
    ab = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    bb = b[0] * b[0] + b[1] * b[1] + b[2] * b[2]
    det = aa * bb - ab * ab
    first = (bb * a[0] - ab * b[0]) / det
    second = (aa * b[0] - ab * a[0]) / det
    length = 0.0
    for i in range(3):
        length += (first * a[i] + second * b[i]) ** 2
    length = np.sqrt(length)
    for n in range(9):
        slope[n] = (
            first * SHEET_SLOPES[which, g, 0, n] + second * SHEET_SLOPES[which, g, 1, n]
        ) / length
    return np.sqrt(det) * SHEET_WEIGHTS[which, g]


@njit(cache=True)
def add_membrane(
    x: np.ndarray,
    u: np.ndarray,
    stiffness: float,
    force: np.ndarray,
    nodes: np.ndarray,
    want_tangent: bool,
    held_flat: bool,
    r: np.ndarray,
    k: np.ndarray,
    gap: np.ndarray,
    areas: np.ndarray,
    gradient: np.ndarray,
) -> None:
    """Adds a sheet of ``stiffness`` K [N/m] on one face to ``r`` (27, 3) and ``k`` (729, 6),
    with ``force`` N (6,) [N/m] eliminated from the latter.

    Energy N (lambda - 1) - N^2 / (2 K). ``nodes``: (9,) local nodes of the face. ``held_flat``:
    what compression takes from the tangent's stiffness against turning, and so against wrinkles, is
    left out. Fills ``gap`` (6,) = lambda - 1 - N/K and, with the tangent, ``areas`` (6,),
    ``gradient`` (6, 9, 3) = dlambda/du.
    """
    which = _across_x1(x, nodes)
    slope, fibre = np.empty(9), np.empty(3)
    for g in range(SHEET_POINTS):
        area = fibre_slopes(x, nodes, which, g, slope)
        square = 0.0
        for i in range(3):
            fibre[i] = 0.0
            for n in range(9):
                fibre[i] += slope[n] * (x[nodes[n], i] + u[nodes[n], i])
            square += fibre[i] * fibre[i]
        stretch = np.sqrt(square)
        for i in range(3):
            fibre[i] /= stretch
        gap[g] = stretch - 1.0 - force[g] / stiffness
        for n in range(9):
            for i in range(3):
                r[nodes[n], i] += area * force[g] * fibre[i] * slope[n]
        if want_tangent:
            areas[g] = area
            for n in range(9):
                for i in range(3):
                    gradient[g, n, i] = fibre[i] * slope[n]
            turning = area * force[g] / stretch
            if held_flat and turning < 0.0:
                turning = 0.0
            stretching = stiffness * area - turning
            for i in range(3):
                for m in range(i, 3):
                    value = stretching * fibre[i] * fibre[m]
                    if i == m:
                        value += turning
                    for n in range(9):
                        for p in range(9):
                            k[PLACE[nodes[n], nodes[p]], BLOCK[i, m]] += value * slope[n] * slope[p]
