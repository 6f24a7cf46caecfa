"""Equilibrium of a clamped rod with a linear law under pressure and its own weight (compiled).

Pieces i = 0..s-1 carry constant rod strains e = (stretch, torsion, bending about X2, bending about
X3), each an exact piece of helix:

    e_i = e_free,i + C_i S_i,   S = (force along the tangent, moments about X1, X2, X3)

at the piece's middle, from the weight beyond it. The frames depend on torsion and bending k alone,
the force on nothing, so the stretch follows from k and the unknowns are the k_i. Newton's
corrections turn the borders between pieces: differences of neighbouring moment equations contain
only neighbouring turns (the lever arm between two middles times the known weight beyond), so that
one correction is a block-tridiagonal solve, at a cost linear in s. Steps are halved until the
residual falls.
"""

import math
from typing import NamedTuple

import numba as nb
import numpy as np

from actuators.mechanics.rod.small import (
    add_cross,
    add_double_cross,
    inverse,
    product,
    times,
    turn,
    turned_back,
)

_TOLERANCE = 1e-8  # turns of all pieces together [rad]: far below what any plot or test resolves
_ITERATIONS = 60


class Law(NamedTuple):
    """Pieces for the compiled code. ``length``: (s,) [m]; ``compliance``: (s, 4, 4); ``bending``:
    (s, 3, 3), K, inverse of its lower right block; ``lean``: (s, 3) K C_k0, moment per stretch
    held; ``weight``: (s,) [N]; ``height``: (s,) [m]; ``gravity``: (3,) its direction."""

    length: np.ndarray
    compliance: np.ndarray
    bending: np.ndarray
    lean: np.ndarray
    weight: np.ndarray
    height: np.ndarray
    gravity: np.ndarray


@nb.njit(cache=True)
def shape(strain: np.ndarray, length: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Positions (2 s + 1, 3) and frames (2 s + 1, 3, 3) of a rod with strains (s, 4): borders at
    even places, middles of the pieces between them."""
    s = len(length)
    x, r = np.zeros((2 * s + 1, 3)), np.zeros((2 * s + 1, 3, 3))
    rotation, mean = np.zeros((3, 3)), np.zeros((3, 3))
    w = np.zeros(3)
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
            go = r[n, a, 0] * mean[0, 0] + r[n, a, 1] * mean[1, 0] + r[n, a, 2] * mean[2, 0]
            x[n + 1, a] = x[n, a] + go * half * (1 + strain[i, 0])
    return x, r


@nb.njit(cache=True)
def _residual(
    strain: np.ndarray, free: np.ndarray, law: Law, inner: np.ndarray, lack: np.ndarray
) -> tuple[float, np.ndarray, np.ndarray]:
    """Complete the stretch of ``strain`` (s, 4); put the moments that its torsion and bending
    hold into ``inner`` (s, 3) and how far they exceed the load's into ``lack`` (s, 3), in the frame
    of the piece. Returns the turn that the lack amounts to, and the shape."""
    s = len(law.length)
    _, r = shape(strain, law.length)
    beyond = 0.0
    for i in range(s - 1, -1, -1):
        middle = r[2 * i + 1]
        pull = 0.0
        for a in range(3):
            pull += middle[a, 0] * law.gravity[a] * (beyond + law.weight[i] / 2)
        beyond += law.weight[i]
        strain[i, 0] = free[i, 0] + law.compliance[i, 0, 0] * pull
        for a in range(3):
            inner[i, a] = 0.0
            for b in range(3):
                held = strain[i, b + 1] - free[i, b + 1] - law.compliance[i, b + 1, 0] * pull
                inner[i, a] += law.bending[i, a, b] * held
        for a in range(3):
            strain[i, 0] += law.compliance[i, 0, a + 1] * inner[i, a]
    x, r = shape(strain, law.length)
    about, far, moment, local = np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3)
    force, total = np.zeros(3), 0.0
    beyond = 0.0
    for i in range(s - 1, -1, -1):
        xm, rm = x[2 * i + 1], r[2 * i + 1]
        quarter = law.length[i] * (1 + strain[i, 0]) / 4
        for a in range(3):
            far[a] = xm[a] + quarter * rm[a, 0] + law.height[i] * rm[a, 2]
            force[a] = (beyond + law.weight[i] / 2) * law.gravity[a]
            moment[a] = about[a]
        add_cross(far, law.gravity, law.weight[i] / 2, moment)
        add_cross(xm, force, -1.0, moment)
        turned_back(rm, moment, local)
        for a in range(3):
            far[a] -= quarter * rm[a, 0]
        add_cross(far, law.gravity, law.weight[i], about)
        beyond += law.weight[i]
        for a in range(3):
            lack[i, a] = inner[i, a] - local[a]
        for a in range(3):
            wrong = 0.0
            for b in range(3):
                wrong += law.compliance[i, a + 1, b + 1] * lack[i, b]
            total += abs(wrong) * law.length[i]
    return total, x, r


@nb.njit(cache=True)
def _blocks(
    inner: np.ndarray, law: Law, x: np.ndarray, r: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Lower, diagonal and upper blocks (s, 3, 3) of the differenced moment equations in the turns
    of the borders; row i is piece i's equation minus the next piece's."""
    s = len(law.length)
    lower, diagonal, upper = np.zeros((s, 3, 3)), np.zeros((s, 3, 3)), np.zeros((s, 3, 3))
    turned, swing, drop = np.zeros((3, 3)), np.zeros((3, 3)), np.zeros((3, 3))
    held, lean, arm, lever = np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3)
    beyond = 0.0
    for i in range(s - 1, -1, -1):
        rm = r[2 * i + 1]
        product(rm, law.bending[i], turned)
        times(rm, inner[i], held)
        times(rm, law.lean[i], lean)
        arm[:] = 0.0
        add_cross(rm[:, 0], law.gravity, beyond + law.weight[i] / 2, arm)
        swing[0, 1], swing[0, 2], swing[1, 2] = -held[2], held[1], -held[0]
        swing[1, 0], swing[2, 0], swing[2, 1] = held[2], -held[1], held[0]
        drop[:, :] = 0.0
        add_double_cross(law.gravity, rm[:, 2], law.weight[i] * law.height[i] / 4, drop)
        if i + 1 < s:
            for a in range(3):
                lever[a] = x[2 * i + 3, a] - x[2 * i + 1, a]
            add_double_cross(law.gravity, lever, -beyond, diagonal[i])
        for a in range(3):
            for b in range(3):
                stiff = (
                    turned[a, 0] * rm[b, 0] + turned[a, 1] * rm[b, 1] + turned[a, 2] * rm[b, 2]
                ) / law.length[i]
                half = (swing[a, b] + lean[a] * arm[b]) / 2
                pull = arm[a] * lean[b] / 2  # a longer piece is a longer lever
                lower[i, a, b] = -stiff - half - drop[a, b] + pull
                diagonal[i, a, b] += stiff - half - drop[a, b] - pull
                if i > 0:
                    diagonal[i - 1, a, b] -= -stiff - half + drop[a, b] - pull
                    upper[i - 1, a, b] = -(stiff - half + drop[a, b] + pull)
        beyond += law.weight[i]
    return lower, diagonal, upper


@nb.njit(cache=True)
def _correction(
    inner: np.ndarray, lack: np.ndarray, law: Law, x: np.ndarray, r: np.ndarray
) -> np.ndarray:
    """Newton correction (s, 3) of torsion and bending: block Thomas over the borders' turns."""
    s = len(law.length)
    lower, diagonal, upper = _blocks(inner, law, x, r)
    right, turns, change = np.zeros((s, 3)), np.zeros((s + 1, 3)), np.zeros((s, 3))
    inverted, factor, matrix = np.zeros((3, 3)), np.zeros((3, 3)), np.zeros((3, 3))
    v, w = np.zeros(3), np.zeros(3)
    for i in range(s):
        times(r[2 * i + 1], lack[i], v)
        for a in range(3):
            right[i, a] -= v[a]
            if i > 0:
                right[i - 1, a] += v[a]
    for i in range(1, s):
        inverse(diagonal[i - 1], inverted)
        product(lower[i], inverted, factor)
        product(factor, upper[i - 1], matrix)
        times(factor, right[i - 1], v)
        for a in range(3):
            right[i, a] -= v[a]
            for b in range(3):
                diagonal[i, a, b] -= matrix[a, b]
    for i in range(s - 1, -1, -1):
        inverse(diagonal[i], inverted)
        w[:] = right[i]
        if i + 1 < s:
            times(upper[i], turns[i + 2], v)
            for a in range(3):
                w[a] -= v[a]
        times(inverted, w, turns[i + 1])
    for i in range(s):
        for a in range(3):
            v[a] = (turns[i + 1, a] - turns[i, a]) / law.length[i]
        turned_back(r[2 * i + 1], v, change[i])
    return change


@nb.njit(cache=True)
def _balance(strain: np.ndarray, free: np.ndarray, law: Law) -> tuple[int, bool]:
    """Bring ``strain`` (s, 4) into equilibrium. Returns iterations, and whether it was found."""
    s = len(law.length)
    inner, lack, trial = np.zeros((s, 3)), np.zeros((s, 3)), np.zeros((s, 4))
    error, x, r = _residual(strain, free, law, inner, lack)
    for iteration in range(_ITERATIONS):
        if error < _TOLERANCE:
            return iteration, True
        change = _correction(inner, lack, law, x, r)
        step, found = 2.0, math.inf
        while step > 1e-3 and not found < (1 - step / 4) * error:
            step /= 2
            for i in range(s):
                for a in range(3):
                    trial[i, a + 1] = strain[i, a + 1] + step * change[i, a]
            found, x, r = _residual(trial, free, law, inner, lack)
        if not found < error:
            return iteration, False
        strain[:, :] = trial
        error = found
    return _ITERATIONS, False


@nb.njit(cache=True)
def _hang(strain: np.ndarray, law: Law) -> None:
    """Strains (s, 4) of a rod that turns down at the clamp and hangs straight: where to begin when
    the rod is so heavy for its stiffness that the straight one leads nowhere."""
    strain[:, :] = 0.0
    across = math.hypot(law.gravity[1], law.gravity[2])
    if across > 0:
        angle = math.atan2(across, law.gravity[0])
        bend = angle / (across * law.length[0])
        strain[0, 2], strain[0, 3] = -law.gravity[2] * bend, law.gravity[1] * bend


@nb.njit(cache=True)
def follow(
    pressures: np.ndarray, per_pressure: np.ndarray, law: Law
) -> tuple[np.ndarray, np.ndarray, np.ndarray, int, int]:
    """Equilibria over ``pressures`` (k,) of a rod with free strains ``per_pressure`` (s, 4), each
    begun from the last, the first from the weightless rod; where that fails, the weight is put on
    in parts. Returns strains (k, s, 4), positions (k, s + 1, 3), frames (k, s + 1, 3, 3), how many
    of the k were found, and Newton iterations."""
    k, s = len(pressures), len(law.length)
    strains = np.zeros((k, s, 4))
    positions, frames = np.zeros((k, s + 1, 3)), np.zeros((k, s + 1, 3, 3))
    free, sag, before = np.zeros((s, 4)), np.zeros((s, 4)), np.zeros((s, 4))
    total = 0
    for n in range(k):
        for i in range(s):
            for a in range(4):
                free[i, a] = pressures[n] * per_pressure[i, a]
                ahead = 2 * sag[i, a] - before[i, a] if n > 1 else sag[i, a]
                strains[n, i, a] = free[i, a] + ahead
        count, found = _balance(strains[n], free, law)
        total += count
        if not found:
            _hang(strains[n], law)
            count, found = _balance(strains[n], free, law)
            total += count
        parts = 4
        while not found and parts <= 64:
            strains[n] = free
            part, found = 0, True
            while found and part < parts:
                part += 1
                lighter = Law(
                    law.length, law.compliance, law.bending, law.lean, law.weight * (part / parts),
                    law.height, law.gravity,
                )  # fmt: skip
                count, found = _balance(strains[n], free, lighter)
                total += count
            parts *= 4
        if not found:
            return strains, positions, frames, n, total
        x, r = shape(strains[n], law.length)
        for i in range(s):
            for a in range(4):
                before[i, a] = sag[i, a]
                sag[i, a] = strains[n, i, a] - free[i, a]
        for i in range(s + 1):
            positions[n, i] = x[2 * i]
            frames[n, i] = r[2 * i]
    return strains, positions, frames, k, total
