"""Volume of the cavity and its derivatives, by the divergence theorem.

V = -1/3 sum over faces of the integral of x . (x_xi cross x_eta): the faces are right-handed about
the normal out of the rubber. The cavity must be closed, or cut only by a plane through the origin
on which its nodes stay (the middle plane of a half model).
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.shape import (
    SQUARE_SLOPES,
    SQUARE_VALUES,
    SQUARE_WEIGHTS,
)


@njit(cache=True)
def _cross(a: np.ndarray, b: np.ndarray, out: np.ndarray) -> None:
    out[0] = a[1] * b[2] - a[2] * b[1]
    out[1] = a[2] * b[0] - a[0] * b[2]
    out[2] = a[0] * b[1] - a[1] * b[0]


@njit(cache=True)
def _point(x: np.ndarray, g: int, at: np.ndarray, along: np.ndarray, across: np.ndarray) -> None:
    for i in range(3):
        at[i] = 0.0
        along[i] = 0.0
        across[i] = 0.0
        for n in range(9):
            at[i] += SQUARE_VALUES[g, n] * x[n, i]
            along[i] += SQUARE_SLOPES[g, 0, n] * x[n, i]
            across[i] += SQUARE_SLOPES[g, 1, n] * x[n, i]


@njit(cache=True)
def face_volume(x: np.ndarray, gradient: np.ndarray) -> float:
    """V of one face with positions ``x`` (9, 3); adds dV/dx to ``gradient`` (9, 3)."""
    at, along, across = np.empty(3), np.empty(3), np.empty(3)
    normal, left, right = np.empty(3), np.empty(3), np.empty(3)
    volume = 0.0
    for g in range(9):
        _point(x, g, at, along, across)
        _cross(along, across, normal)
        _cross(across, at, left)
        _cross(at, along, right)
        w = -SQUARE_WEIGHTS[g] / 3.0
        for i in range(3):
            volume += w * at[i] * normal[i]
            for n in range(9):
                gradient[n, i] += w * (
                    SQUARE_VALUES[g, n] * normal[i]
                    + SQUARE_SLOPES[g, 0, n] * left[i]
                    + SQUARE_SLOPES[g, 1, n] * right[i]
                )
    return volume


@njit(cache=True)
def add_face_hessian(x: np.ndarray, factor: float, hessian: np.ndarray) -> None:
    """Adds ``factor`` d2V/dx2 of one face to ``hessian`` (9, 3, 9, 3)."""
    at, along, across = np.empty(3), np.empty(3), np.empty(3)
    for g in range(9):
        _point(x, g, at, along, across)
        w = -factor * SQUARE_WEIGHTS[g] / 3.0
        for a in range(9):
            na, nax, nay = SQUARE_VALUES[g, a], SQUARE_SLOPES[g, 0, a], SQUARE_SLOPES[g, 1, a]
            for b in range(9):
                nb = SQUARE_VALUES[g, b]
                nbx, nby = SQUARE_SLOPES[g, 0, b], SQUARE_SLOPES[g, 1, b]
                for m in range(3):
                    value = w * (
                        (na * nbx - nax * nb) * across[m]
                        - (na * nby - nay * nb) * along[m]
                        + (nax * nby - nay * nbx) * at[m]
                    )
                    i, k = (m + 1) % 3, (m + 2) % 3
                    hessian[a, i, b, k] += value
                    hessian[a, k, b, i] -= value


@njit(cache=True)
def cavity_volume(positions: np.ndarray, faces: np.ndarray, gradient: np.ndarray) -> float:
    """V [m3] over ``faces`` (f, 9) at ``positions`` (n, 3); fills ``gradient`` (n, 3) [m2]."""
    gradient[:] = 0.0
    total = 0.0
    x = np.empty((9, 3))
    local = np.empty((9, 3))
    for face in range(len(faces)):
        for n in range(9):
            for i in range(3):
                x[n, i] = positions[faces[face, n], i]
                local[n, i] = 0.0
        total += face_volume(x, local)
        for n in range(9):
            for i in range(3):
                gradient[faces[face, n], i] += local[n, i]
    return total


@njit(cache=True)
def face_traction(positions: np.ndarray, faces: np.ndarray, load: np.ndarray) -> None:
    """Adds the integral of N n dA over ``faces`` (n out of the rubber) to ``load`` (n, 3)."""
    at, along, across, normal = np.empty(3), np.empty(3), np.empty(3), np.empty(3)
    x = np.empty((9, 3))
    for face in range(len(faces)):
        for n in range(9):
            for i in range(3):
                x[n, i] = positions[faces[face, n], i]
        for g in range(9):
            _point(x, g, at, along, across)
            _cross(along, across, normal)
            for n in range(9):
                for i in range(3):
                    load[faces[face, n], i] += SQUARE_WEIGHTS[g] * SQUARE_VALUES[g, n] * normal[i]
