"""Integrals over the cube, one direction after the other (sum factorisation).

Shape functions and Gauss points are products of three on a line, so that a sum over 27 points is
three sums over 3: a sixth of the work of the stiffness, in loops that a processor runs in parallel.
Nodes n1 + 3 n2 + 9 n3, points likewise.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.shape import line_shape

_POINTS = np.polynomial.legendre.leggauss(3)[0]
LINE_VALUES, LINE_SLOPES = line_shape(_POINTS)  # (point, node)
PAIRS: np.ndarray = np.stack(
    [
        np.einsum("gn,gp->gnp", first, second).reshape(3, 9)
        for first in (LINE_VALUES, LINE_SLOPES)
        for second in (LINE_VALUES, LINE_SLOPES)
    ]
)
"""[2 s + t, point, 3 n + p]: product of node n's value (s = 0) or slope (1) and node p's (t)."""
BLOCKS = 6
"""Pairs of components (i, m), i <= m: 00 01 02 11 12 22."""


def _places() -> np.ndarray:
    node = np.arange(27)
    digits = np.stack([node % 3, node // 3 % 3, node // 9])
    one, two, three = 3 * digits[:, :, None] + digits[:, None, :]
    return (three * 9 + two) * 9 + one


PLACE: np.ndarray = _places()
"""(27, 27) row of the pair of nodes (n, p) in a stiffness (729, 6)."""
BLOCK: np.ndarray = np.array([[0, 1, 2], [1, 3, 4], [2, 4, 5]])
"""Column of components (i, m) in a stiffness (729, 6); for i > m the nodes change places."""


@njit(cache=True, error_model="numpy")
def nodal_gradients(field: np.ndarray, out: np.ndarray) -> None:
    """``out`` (3, 27, c) = local derivatives at the Gauss points of ``field`` (27, c) at nodes."""
    count = field.shape[1]
    value, slope = np.empty((27, count)), np.empty((27, count))
    for row in range(9):
        for g in range(3):
            for c in range(count):
                a, b, d = field[3 * row, c], field[3 * row + 1, c], field[3 * row + 2, c]
                value[3 * row + g, c] = (
                    LINE_VALUES[g, 0] * a + LINE_VALUES[g, 1] * b + LINE_VALUES[g, 2] * d
                )
                slope[3 * row + g, c] = (
                    LINE_SLOPES[g, 0] * a + LINE_SLOPES[g, 1] * b + LINE_SLOPES[g, 2] * d
                )
    # [0] slope along 1, [1] along 2, [2] neither yet
    plane = np.empty((3, 3, 9, count))
    for layer in range(3):
        for g in range(3):
            v0, v1, v2 = LINE_VALUES[g, 0], LINE_VALUES[g, 1], LINE_VALUES[g, 2]
            s0, s1, s2 = LINE_SLOPES[g, 0], LINE_SLOPES[g, 1], LINE_SLOPES[g, 2]
            for p in range(3):
                at = 9 * layer + p
                for c in range(count):
                    plane[0, layer, 3 * g + p, c] = (
                        v0 * slope[at, c] + v1 * slope[at + 3, c] + v2 * slope[at + 6, c]
                    )
                    plane[1, layer, 3 * g + p, c] = (
                        s0 * value[at, c] + s1 * value[at + 3, c] + s2 * value[at + 6, c]
                    )
                    plane[2, layer, 3 * g + p, c] = (
                        v0 * value[at, c] + v1 * value[at + 3, c] + v2 * value[at + 6, c]
                    )
    for d in range(3):
        for g in range(3):
            if d < 2:
                w0, w1, w2 = LINE_VALUES[g, 0], LINE_VALUES[g, 1], LINE_VALUES[g, 2]
            else:
                w0, w1, w2 = LINE_SLOPES[g, 0], LINE_SLOPES[g, 1], LINE_SLOPES[g, 2]
            for p in range(9):
                for c in range(count):
                    out[d, 9 * g + p, c] = (
                        w0 * plane[d, 0, p, c] + w1 * plane[d, 1, p, c] + w2 * plane[d, 2, p, c]
                    )


@njit(cache=True, error_model="numpy")
def nodal_forces(flux: np.ndarray, out: np.ndarray) -> None:
    """``out`` (27, c) = sum over points and directions of ``flux`` (3, 27, c) times the local
    derivatives of every node's function: the transpose of :func:`nodal_gradients`."""
    count = flux.shape[2]
    plane = np.empty((3, 3, 9, count))
    for d in range(3):
        for n in range(3):
            if d < 2:
                w0, w1, w2 = LINE_VALUES[0, n], LINE_VALUES[1, n], LINE_VALUES[2, n]
            else:
                w0, w1, w2 = LINE_SLOPES[0, n], LINE_SLOPES[1, n], LINE_SLOPES[2, n]
            for p in range(9):
                for c in range(count):
                    plane[d, n, p, c] = (
                        w0 * flux[d, p, c] + w1 * flux[d, 9 + p, c] + w2 * flux[d, 18 + p, c]
                    )
    value, slope = np.empty((3, count)), np.empty((3, count))
    for layer in range(3):
        for n in range(3):
            v0, v1, v2 = LINE_VALUES[0, n], LINE_VALUES[1, n], LINE_VALUES[2, n]
            s0, s1, s2 = LINE_SLOPES[0, n], LINE_SLOPES[1, n], LINE_SLOPES[2, n]
            for p in range(3):
                for c in range(count):
                    slope[p, c] = (
                        v0 * plane[0, layer, p, c]
                        + v1 * plane[0, layer, 3 + p, c]
                        + v2 * plane[0, layer, 6 + p, c]
                    )
                    value[p, c] = (
                        s0 * plane[1, layer, p, c]
                        + s1 * plane[1, layer, 3 + p, c]
                        + s2 * plane[1, layer, 6 + p, c]
                        + v0 * plane[2, layer, p, c]
                        + v1 * plane[2, layer, 3 + p, c]
                        + v2 * plane[2, layer, 6 + p, c]
                    )
            for m in range(3):
                for c in range(count):
                    out[9 * layer + 3 * n + m, c] = (
                        LINE_SLOPES[0, m] * slope[0, c]
                        + LINE_SLOPES[1, m] * slope[1, c]
                        + LINE_SLOPES[2, m] * slope[2, c]
                        + LINE_VALUES[0, m] * value[0, c]
                        + LINE_VALUES[1, m] * value[1, c]
                        + LINE_VALUES[2, m] * value[2, c]
                    )


@njit(cache=True, error_model="numpy")
def nodal_stiffness(tangent: np.ndarray, k: np.ndarray) -> None:
    """``k`` (4374,): 729 pairs of nodes (:data:`PLACE`) times 6 pairs of components, from
    ``tangent`` (9, 9, 3, 6): [3 d + e, g2 + 3 g3, g1, block], local directions d of the first node
    and e of the second."""
    one = np.empty((9, 9, 54))
    for de in range(9):
        t = (2 if de < 3 else 0) + (1 if de % 3 == 0 else 0)
        for g in range(9):
            for a in range(9):
                c0, c1, c2 = PAIRS[t, 0, a], PAIRS[t, 1, a], PAIRS[t, 2, a]
                for v in range(BLOCKS):
                    one[de, g, BLOCKS * a + v] = (
                        c0 * tangent[de, g, 0, v]
                        + c1 * tangent[de, g, 1, v]
                        + c2 * tangent[de, g, 2, v]
                    )
    two = np.zeros((4, 3, 486))
    for de in range(9):
        d, e = de // 3, de % 3
        t = (2 if d == 1 else 0) + (1 if e == 1 else 0)
        into = (2 if d == 2 else 0) + (1 if e == 2 else 0)
        for g in range(3):
            for b in range(9):
                c0, c1, c2 = PAIRS[t, 0, b], PAIRS[t, 1, b], PAIRS[t, 2, b]
                for x in range(54):
                    two[into, g, 54 * b + x] += (
                        c0 * one[de, 3 * g, x]
                        + c1 * one[de, 3 * g + 1, x]
                        + c2 * one[de, 3 * g + 2, x]
                    )
    for c in range(9):
        c0, c1, c2 = PAIRS[0, 0, c], PAIRS[0, 1, c], PAIRS[0, 2, c]
        c3, c4, c5 = PAIRS[1, 0, c], PAIRS[1, 1, c], PAIRS[1, 2, c]
        c6, c7, c8 = PAIRS[2, 0, c], PAIRS[2, 1, c], PAIRS[2, 2, c]
        c9, ca, cb = PAIRS[3, 0, c], PAIRS[3, 1, c], PAIRS[3, 2, c]
        for x in range(486):
            k[486 * c + x] = (
                c0 * two[0, 0, x] + c1 * two[0, 1, x] + c2 * two[0, 2, x]
                + c3 * two[1, 0, x] + c4 * two[1, 1, x] + c5 * two[1, 2, x]
                + c6 * two[2, 0, x] + c7 * two[2, 1, x] + c8 * two[2, 2, x]
                + c9 * two[3, 0, x] + ca * two[3, 1, x] + cb * two[3, 2, x]
            )  # fmt: skip
