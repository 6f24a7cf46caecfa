"""Equilibrium of a clamped rod with a linear law under pressure and its own weight (compiled).

Pieces i = 0..s-1 carry constant rod strains e = (stretch, torsion, bending about X2, bending about
X3), each an exact piece of helix:

    e_i = e_free,i + C_i S_i,   S = (force along the tangent, moments about X1, X2, X3)

at the piece's middle, from the weight beyond it. Newton's corrections turn the borders between
pieces: differences of neighbouring moment equations contain only neighbouring turns (the lever arm
between two middles times the known weight beyond), so that one correction is a block-tridiagonal
solve, at a cost linear in s. Full steps are halved until the residual falls.
"""

import math

import numba as nb
import numpy as np

_TOLERANCE = 1e-8  # on turns of the free end [rad]: far below what any plot or test resolves
_ITERATIONS = 60


@nb.njit(cache=True)
def _turn(w: np.ndarray, rotation: np.ndarray, mean: np.ndarray) -> None:
    """Rotation by ``w`` and its mean over the way there, series where the angle vanishes."""
    square = w[0] ** 2 + w[1] ** 2 + w[2] ** 2
    if square < 1e-4:
        s = 1 - square / 6 + square**2 / 120
        c = 0.5 - square / 24 + square**2 / 720
        v = 1 / 6 - square / 120 + square**2 / 5040
    else:
        a = math.sqrt(square)
        s = math.sin(a) / a
        c = 2 * math.sin(a / 2) ** 2 / square
        v = (a - math.sin(a)) / (a * square)
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
def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    c = np.empty(3)
    c[0] = a[1] * b[2] - a[2] * b[1]
    c[1] = a[2] * b[0] - a[0] * b[2]
    c[2] = a[0] * b[1] - a[1] * b[0]
    return c


@nb.njit(cache=True)
def _skew(a: np.ndarray) -> np.ndarray:
    m = np.zeros((3, 3))
    m[0, 1], m[0, 2], m[1, 2] = -a[2], a[1], -a[0]
    m[1, 0], m[2, 0], m[2, 1] = a[2], -a[1], a[0]
    return m


@nb.njit(cache=True)
def _double_cross(n: np.ndarray, d: np.ndarray) -> np.ndarray:
    """Matrix of theta -> (theta x d) x n, which is (theta . n) -> d ... = d n^T - (n . d)."""
    m = np.empty((3, 3))
    dot = n[0] * d[0] + n[1] * d[1] + n[2] * d[2]
    for i in range(3):
        for j in range(3):
            m[i, j] = d[i] * n[j]
        m[i, i] -= dot
    return m


@nb.njit(cache=True)
def _times(m: np.ndarray, a: np.ndarray) -> np.ndarray:
    b = np.empty(3)
    for i in range(3):
        b[i] = m[i, 0] * a[0] + m[i, 1] * a[1] + m[i, 2] * a[2]
    return b


@nb.njit(cache=True)
def _product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    c = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            c[i, j] = a[i, 0] * b[0, j] + a[i, 1] * b[1, j] + a[i, 2] * b[2, j]
    return c


@nb.njit(cache=True)
def _inverse(m: np.ndarray) -> np.ndarray:
    c = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            p, q, u, v = (j + 1) % 3, (j + 2) % 3, (i + 1) % 3, (i + 2) % 3
            c[i, j] = m[p, u] * m[q, v] - m[p, v] * m[q, u]
    return c / (m[0, 0] * c[0, 0] + m[0, 1] * c[1, 0] + m[0, 2] * c[2, 0])


@nb.njit(cache=True)
def shape(
    strain: np.ndarray, length: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Positions (s + 1, 3) and frames (s + 1, 3, 3) of the borders, then those of the middles
    (s, 3), (s, 3, 3), of a rod with strains (s, 4)."""
    s = len(length)
    x, r = np.zeros((s + 1, 3)), np.zeros((s + 1, 3, 3))
    xm, rm = np.zeros((s, 3)), np.zeros((s, 3, 3))
    r[0] = np.eye(3)
    rotation, mean = np.zeros((3, 3)), np.zeros((3, 3))
    for i in range(s):
        stretched = (1 + strain[i, 0]) * length[i]
        _turn(strain[i, 1:] * (length[i] / 2), rotation, mean)
        rm[i] = _product(r[i], rotation)
        xm[i] = x[i] + _times(r[i], mean[:, 0]) * (stretched / 2)
        _turn(strain[i, 1:] * length[i], rotation, mean)
        r[i + 1] = _product(r[i], rotation)
        x[i + 1] = x[i] + _times(r[i], mean[:, 0]) * stretched
    return x, r, xm, rm


@nb.njit(cache=True)
def _loads(
    strain: np.ndarray,
    length: np.ndarray,
    weight: np.ndarray,
    height: np.ndarray,
    gravity: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Force beyond each border (s + 1, 3), force and moment at each middle (s, 3), then middles
    and their frames. ``gravity`` is a direction, ``weight`` (s,) in newtons."""
    s = len(length)
    _, _, xm, rm = shape(strain, length)
    beyond = np.zeros((s + 1, 3))
    force, moment = np.zeros((s, 3)), np.zeros((s, 3))
    about = np.zeros(3)  # moment about the origin of the weight beyond
    for i in range(s - 1, -1, -1):
        own = weight[i] * gravity
        up = height[i] * rm[i, :, 2]
        quarter = rm[i, :, 0] * (length[i] * (1 + strain[i, 0]) / 4)
        far = xm[i] + quarter + up
        force[i] = beyond[i + 1] + own / 2
        moment[i] = about + _cross(far, own / 2) - _cross(xm[i], force[i])
        beyond[i] = beyond[i + 1] + own
        about = about + _cross(xm[i] + up, own)
    return beyond, force, moment, xm, rm


@nb.njit(cache=True)
def _residual(
    strain: np.ndarray,
    free: np.ndarray,
    compliance: np.ndarray,
    force: np.ndarray,
    moment: np.ndarray,
    rm: np.ndarray,
    length: np.ndarray,
    error: np.ndarray,
) -> float:
    """Strains short of equilibrium (s, 4) into ``error``; returns the turn they amount to."""
    total = 0.0
    resultant = np.zeros(4)
    for i in range(len(length)):
        resultant[:] = 0.0
        for b in range(3):
            resultant[0] += rm[i, b, 0] * force[i, b]
            for c in range(3):
                resultant[c + 1] += rm[i, b, c] * moment[i, b]
        for a in range(4):
            error[i, a] = strain[i, a] - free[i, a]
            for b in range(4):
                error[i, a] -= compliance[i, a, b] * resultant[b]
        for c in range(1, 4):
            total += abs(error[i, c]) * length[i]
    return total


@nb.njit(cache=True)
def _tangent(
    strain: np.ndarray,
    free: np.ndarray,
    compliance: np.ndarray,
    bending: np.ndarray,
    force: np.ndarray,
    rm: np.ndarray,
    length: np.ndarray,
    near: np.ndarray,
    far: np.ndarray,
) -> None:
    """Change of each piece's inner moment with the turns of its near and far border (s, 3, 3)."""
    local, lean = np.zeros(3), np.zeros(3)
    turned, stiff = np.zeros((3, 3)), np.zeros((3, 3))
    for i in range(len(length)):
        r, k = rm[i], bending[i]
        axial = r[0, 0] * force[i, 0] + r[1, 0] * force[i, 1] + r[2, 0] * force[i, 2]
        for a in range(3):
            local[a] = 0.0
            lean[a] = 0.0
            for b in range(3):
                offset = compliance[i, b + 1, 0]
                local[a] += k[a, b] * (strain[i, b + 1] - free[i, b + 1] - offset * axial)
                lean[a] += k[a, b] * offset
                turned[a, b] = r[a, 0] * k[0, b] + r[a, 1] * k[1, b] + r[a, 2] * k[2, b]
        swing = _skew(_times(r, local))
        lean_global = _times(r, lean)
        arm = _cross(r[:, 0], force[i])
        for a in range(3):
            for b in range(3):
                stiff[a, b] = (
                    turned[a, 0] * r[b, 0] + turned[a, 1] * r[b, 1] + turned[a, 2] * r[b, 2]
                ) / length[i]
                half = (swing[a, b] + lean_global[a] * arm[b]) / 2
                far[i, a, b] = stiff[a, b] - half
                near[i, a, b] = -stiff[a, b] - half


@nb.njit(cache=True)
def _correction(
    error: np.ndarray,
    bending: np.ndarray,
    near: np.ndarray,
    far: np.ndarray,
    beyond: np.ndarray,
    weight: np.ndarray,
    height: np.ndarray,
    gravity: np.ndarray,
    xm: np.ndarray,
    rm: np.ndarray,
    length: np.ndarray,
) -> np.ndarray:
    """Newton correction (s, 3) of torsion and bendings; ``bending`` (s, 3, 3) is the stiffness
    against them at constant axial force."""
    s = len(length)
    lack = np.zeros((s, 3))
    drop = np.zeros((s, 3, 3))  # moment of a piece's weight at its height, per turn, halved twice
    for i in range(s):
        lack[i] = _times(rm[i], _times(bending[i], error[i, 1:]))
        drop[i] = _double_cross(gravity, rm[i, :, 2]) * (weight[i] * height[i] / 4)
    # block Thomas over the turns of the borders 1..s
    inverse, upper, right = np.zeros((s, 3, 3)), np.zeros((s, 3, 3)), np.zeros((s, 3))
    for i in range(s):
        block, load = far[i] - drop[i], -lack[i]
        if i + 1 < s:
            lever = xm[i + 1] - xm[i]
            block -= near[i + 1] + drop[i + 1] + _double_cross(beyond[i + 1], lever)
            load = load + lack[i + 1]
            upper[i] = -far[i + 1] - drop[i + 1]
        if i > 0:
            eliminate = _product(near[i] - drop[i], inverse[i - 1])
            block -= _product(eliminate, upper[i - 1])
            load = load - _times(eliminate, right[i - 1])
        inverse[i], right[i] = _inverse(block), load
    turns = np.zeros((s + 1, 3))
    for i in range(s - 1, -1, -1):
        load = right[i].copy()
        if i + 1 < s:
            load -= _times(upper[i], turns[i + 2])
        turns[i + 1] = _times(inverse[i], load)
    change = np.zeros((s, 3))
    for i in range(s):
        for a in range(3):
            for b in range(3):
                change[i, a] += rm[i, b, a] * (turns[i + 1, b] - turns[i, b]) / length[i]
    return change


@nb.njit(cache=True)
def balance(
    start: np.ndarray,
    free: np.ndarray,
    compliance: np.ndarray,
    bending: np.ndarray,
    length: np.ndarray,
    weight: np.ndarray,
    height: np.ndarray,
    gravity: np.ndarray,
) -> tuple[np.ndarray, int, bool]:
    """Strains (s, 4) in equilibrium near ``start``, iterations, and whether they were found."""
    strain = start.copy()
    error, trial_error = np.zeros_like(strain), np.zeros_like(strain)
    near, far = np.zeros((len(length), 3, 3)), np.zeros((len(length), 3, 3))
    beyond, force, moment, xm, rm = _loads(strain, length, weight, height, gravity)
    lack = _residual(strain, free, compliance, force, moment, rm, length, error)
    for iteration in range(_ITERATIONS):
        if lack < _TOLERANCE:
            return strain, iteration, True
        _tangent(strain, free, compliance, bending, force, rm, length, near, far)
        change = _correction(
            error, bending, near, far, beyond, weight, height, gravity, xm, rm, length
        )
        step, found = 1.0, math.inf
        trial = strain
        while step > 1e-3 and not found < (1 - step / 4) * lack:
            trial = strain.copy()
            trial[:, 1:] += step * change
            trial[:, 0] -= step * error[:, 0]
            beyond, force, moment, xm, rm = _loads(trial, length, weight, height, gravity)
            found = _residual(trial, free, compliance, force, moment, rm, length, trial_error)
            step /= 2
        if not found < lack:
            return strain, iteration, lack < 1e3 * _TOLERANCE
        strain, lack = trial, found
        error[:] = trial_error
    return strain, _ITERATIONS, False


@nb.njit(cache=True)
def follow(
    pressures: np.ndarray,
    per_pressure: np.ndarray,
    compliance: np.ndarray,
    bending: np.ndarray,
    length: np.ndarray,
    weight: np.ndarray,
    height: np.ndarray,
    gravity: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, int, int]:
    """Equilibria over ``pressures`` (k,), each begun from the last; the first from the weightless
    rod, weight put on in up to 64 parts. Returns strains (k, s, 4), positions (k, s + 1, 3), frames
    (k, s + 1, 3, 3), how many of the k were found, and Newton iterations."""
    k, s = len(pressures), len(length)
    strains = np.zeros((k, s, 4))
    positions, frames = np.zeros((k, s + 1, 3)), np.zeros((k, s + 1, 3, 3))
    sag, before = np.zeros((s, 4)), np.zeros((s, 4))
    total = 0
    for n in range(k):
        free = pressures[n] * per_pressure
        strain, count, found = balance(
            free + (2 * sag - before if n > 1 else sag),
            free,
            compliance,
            bending,
            length,
            weight,
            height,
            gravity,
        )
        total += count
        parts = 4
        while not found and parts <= 64:
            strain, found = free.copy(), True
            for part in range(1, parts + 1):
                strain, count, found = balance(
                    strain,
                    free,
                    compliance,
                    bending,
                    length,
                    weight * (part / parts),
                    height,
                    gravity,
                )
                total += count
                if not found:
                    break
            parts *= 4
        if not found:
            return strains, positions, frames, n, total
        before = sag
        sag = strain - free
        strains[n] = strain
        x, r, _, _ = shape(strain, length)
        positions[n], frames[n] = x, r
    return strains, positions, frames, k, total
