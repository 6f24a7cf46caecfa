"""Shape of a rod with shear, and the resultants of its law (compiled)."""

import numba as nb
import numpy as np

from actuators.mechanics.rod.chain import Law
from actuators.mechanics.rod.small import product, turn

BEND = 2
SHEAR = 4
_ROUNDS, _CLOSE = 40, 1e-14  # of Newton's method for one bending


@nb.njit(cache=True)
def sheared_shape(strain: np.ndarray, length: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """As :func:`.equilibrium.shape`, of strains (s, 6): x' = R (1 + stretch, shears)."""
    s = len(length)
    x, r = np.zeros((2 * s + 1, 3)), np.zeros((2 * s + 1, 3, 3))
    rotation, mean = np.zeros((3, 3)), np.zeros((3, 3))
    w, v = np.zeros(3), np.zeros(3)
    for a in range(3):
        r[0, a, a] = 1.0
    for n in range(2 * s):
        i = n // 2
        half = length[i] / 2
        for a in range(3):
            w[a] = strain[i, a + 1] * half
        turn(w, rotation, mean)
        product(r[n], rotation, r[n + 1])
        for a in range(3):
            v[a] = (
                mean[a, 0] * (1 + strain[i, 0])
                + mean[a, 1] * strain[i, SHEAR]
                + mean[a, 2] * strain[i, SHEAR + 1]
            ) * half
        for a in range(3):
            x[n + 1, a] = x[n, a] + r[n, a, 0] * v[0] + r[n, a, 1] * v[1] + r[n, a, 2] * v[2]
    return x, r


@nb.njit(cache=True)
def softening(bent: np.ndarray, k: float) -> tuple[float, float]:
    """q of a piece bent by k, and its slope; ``bent``: (4,), see :mod:`.chain`."""
    at = min(max(k, bent[2]), bent[3])
    slope = (bent[0] + 3 * bent[1] * at) * at
    return (bent[0] / 2 + bent[1] * at) * at * at + slope * (k - at), slope


@nb.njit(cache=True)
def _bending(bent: np.ndarray, much: float, linear: float) -> float:
    """k of k + much q(k) = linear, which grows with k everywhere."""
    k = linear
    for _ in range(_ROUNDS):
        value, slope = softening(bent, k)
        step = (linear - k - much * value) / (1 + much * slope)
        k += step
        if abs(step) <= _CLOSE * abs(k):
            break
    return k


@nb.njit(cache=True)
def resultants(i: int, law: Law, strain: np.ndarray, d: np.ndarray, out: np.ndarray) -> None:
    """S of piece ``i`` into ``out`` (6,), its d into ``d`` (6,)."""
    for a in range(6):
        d[a] = strain[i, a] - law.free[i, a]
    soft = law.compliance[i, BEND, BEND]
    _press(law.stiffness[i], law.bent[i], soft, d, out)
    if _are_parted(i, law, out):
        for a in range(6):
            d[a] += law.parted[i, a]
        _press(law.apart[i], law.bent[i], soft, d, out)


@nb.njit(cache=True)
def _are_parted(i: int, law: Law, held: np.ndarray) -> bool:
    beyond = 0.0
    for a in range(6):
        beyond += law.release[i, a] * held[a]
    return beyond > 1.0


@nb.njit(cache=True)
def _press(
    stiffness: np.ndarray, bent: np.ndarray, soft: float, d: np.ndarray, out: np.ndarray
) -> None:
    """``soft``: C_22 of the law with its walls, by which both of its sides bend alike."""
    for a in range(6):
        out[a] = 0.0
        for b in range(6):
            out[a] += stiffness[a, b] * d[b]
    if bent[0] != 0.0 or bent[1] != 0.0:
        k = _bending(bent, soft * stiffness[BEND, BEND] - 1, soft * out[BEND])
        less, _ = softening(bent, k)
        for a in range(6):
            out[a] -= less * stiffness[a, BEND]


@nb.njit(cache=True)
def tangent(i: int, law: Law, d: np.ndarray, held: np.ndarray, out: np.ndarray) -> None:
    """dS/de of piece ``i`` into ``out`` (6, 6); ``d`` and ``held`` as :func:`resultants` leaves
    them."""
    # beyond the plane as on this side of it, S leaves no doubt on which it lies
    stiffness = law.apart[i] if _are_parted(i, law, held) else law.stiffness[i]
    linear = 0.0
    for a in range(6):
        linear += stiffness[BEND, a] * d[a]
        for b in range(6):
            out[a, b] = stiffness[a, b]
    bent, soft = law.bent[i], law.compliance[i, BEND, BEND]
    if bent[0] != 0.0 or bent[1] != 0.0:
        much = soft * stiffness[BEND, BEND] - 1
        _, slope = softening(bent, _bending(bent, much, soft * linear))
        less = slope * soft / (1 + much * slope)
        for a in range(6):
            for b in range(6):
                out[a, b] -= less * stiffness[a, BEND] * stiffness[BEND, b]
