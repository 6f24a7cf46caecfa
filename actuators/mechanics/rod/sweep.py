"""Equilibrium of a clamped rod whose loads depend on where it is (compiled).

Unknowns are the rod strains e of the pieces, each an exact piece of helix. At every piece's middle

    S(e) = (R^T n, R^T m)

with n and m the force and moment of all that acts beyond it. Newton's method in one sweep from the
free end: what a change q of place and turn at a border does to the wrench beyond it is P q + c; a
piece answers it by the change of its strains that keeps its six equations (a 6 x 6 solve), so that
the border before has its own P and c. The way back gives the corrections. Any load that depends on
the place and the frame near it fits in, whether it has a potential or not, at a cost linear in the
number of pieces.
"""

import numba as nb
import numpy as np

from actuators.mechanics.rod.balance import half_load
from actuators.mechanics.rod.chain import Chain, Law, Obstacles
from actuators.mechanics.rod.kinematics import resultants, tangent
from actuators.mechanics.rod.small import add_cross, mean_and_slope
from actuators.mechanics.rod.touching import add_touch_slope

_ONE = 12  # column of what does not depend on the border's change q (0..5) or the strains' (6..11)


@nb.njit(cache=True)
def _advance(
    r: np.ndarray, mean: np.ndarray, slope: np.ndarray, half: float, over: np.ndarray
) -> None:
    """Change of (place, turn) over half a piece per change of its strains, (6, 6), beyond what the
    beginning's own change does. ``mean``: as :func:`mean_and_slope`; ``r``: frame there."""
    for a in range(3):
        for b, column in ((0, 0), (1, 4), (2, 5)):
            moved = 0.0
            for c in range(3):
                moved += r[a, c] * mean[c, b]
            over[a, column] = half * moved
            over[3 + a, column] = 0.0
        for b in range(3):
            moved, turned = 0.0, 0.0
            for c in range(3):
                moved += r[a, c] * slope[c, b]
                turned += r[a, c] * mean[c, b]
            over[a, b + 1] = half * half * moved
            over[3 + a, b + 1] = half * turned


@nb.njit(cache=True)
def _add_half_load_slope(
    i: int, side: float, stretch: float, r: np.ndarray, chain: Chain, qm: np.ndarray, w: np.ndarray
) -> None:
    """Add the derivative of :func:`.balance.half_load` to the columns of ``w`` (6, 13); ``qm``:
    (6, 13) change of the middle."""
    quarter = side * chain.length[i] * (1 + stretch) / 4
    arm, force, turned, pushed = np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3)
    for part in range(2 if chain.outside != 0.0 else 1):
        height = chain.height[i] if part == 0 else 0.0
        area = chain.width[i] * chain.length[i] * (1 + stretch) / 2
        for a in range(3):
            arm[a] = quarter * r[a, 0] + height * r[a, 2]
            if part == 0:
                force[a] = chain.weight[i] / 2 * chain.gravity[a]
            else:
                force[a] = chain.outside * area * r[a, 2]
        for b in range(12):
            theta = qm[3:, b]
            turned[:] = 0.0
            add_cross(theta, arm, 1.0, turned)
            pushed[:] = 0.0
            if part == 1:
                add_cross(theta, force, 1.0, pushed)
            if b == 6:
                for a in range(3):
                    turned[a] += quarter / (1 + stretch) * r[a, 0]
                    if part == 1:
                        pushed[a] += force[a] / (1 + stretch)
            add_cross(turned, force, 1.0, w[3:, b])
            if part == 1:
                for a in range(3):
                    w[a, b] += pushed[a]
                add_cross(arm, pushed, 1.0, w[3:, b])


@nb.njit(cache=True)
def _solve(m: np.ndarray, right: np.ndarray) -> bool:
    """Gauss on m (6, 6) with pivots; ``right`` (6, k) becomes the answer. False: singular."""
    k = right.shape[1]
    for p in range(6):
        best = p
        for i in range(p + 1, 6):
            if abs(m[i, p]) > abs(m[best, p]):
                best = i
        if m[best, p] == 0.0:
            return False
        if best != p:
            for j in range(6):
                m[p, j], m[best, j] = m[best, j], m[p, j]
            for j in range(k):
                right[p, j], right[best, j] = right[best, j], right[p, j]
        for i in range(p + 1, 6):
            f = m[i, p] / m[p, p]
            for j in range(p, 6):
                m[i, j] -= f * m[p, j]
            for j in range(k):
                right[i, j] -= f * right[p, j]
    for p in range(5, -1, -1):
        for j in range(k):
            for i in range(p + 1, 6):
                right[p, j] -= m[p, i] * right[i, j]
            right[p, j] /= m[p, p]
    return True


@nb.njit(cache=True)
def correction(
    strain: np.ndarray, chain: Chain, law: Law, obstacles: Obstacles, x: np.ndarray, r: np.ndarray,
    lack: np.ndarray, wrench: np.ndarray, change: np.ndarray,
) -> bool:  # fmt: skip
    """Newton's correction of the strains into ``change`` (s, 6); False where it has none."""
    s = len(chain.length)
    gain = np.zeros((s, 6, 7))
    p, c = np.zeros((6, 6)), np.zeros(6)
    mean, slope, turn_by = np.zeros((3, 3)), np.zeros((3, 3)), np.zeros(3)
    first, second = np.zeros((6, 6)), np.zeros((6, 6))
    qm, qe, w = np.zeros((6, 13)), np.zeros((6, 13)), np.zeros((6, 13))
    matrix, right, tangents = np.zeros((6, 6)), np.zeros((6, 7)), np.zeros((6, 6))
    tip_arm, d, dd, v = np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3)
    deviation, held = np.zeros(6), np.zeros(6)
    for a in range(3):
        tip_arm[a] = chain.tip_height * r[2 * s, a, 2]
        v[a] = chain.tip_force[a]
    dot = tip_arm[0] * v[0] + tip_arm[1] * v[1] + tip_arm[2] * v[2]
    for a in range(3):
        for b in range(3):
            p[3 + a, 3 + b] += tip_arm[a] * v[b]
        p[3 + a, 3 + a] -= dot
    add_touch_slope(s, x[2 * s], r[2 * s], obstacles, p)
    for i in range(s - 1, -1, -1):
        rb, rm = r[2 * i], r[2 * i + 1]
        half = chain.length[i] / 2
        _half_piece(i, strain, half, turn_by, v, mean, slope)
        _advance(rb, mean, slope, half, first)
        _advance(rm, mean, slope, half, second)
        qm[:, :] = 0.0
        for a in range(3):
            d[a] = x[2 * i + 1, a] - x[2 * i, a]
            dd[a] = x[2 * i + 2, a] - x[2 * i + 1, a]
            qm[a, a], qm[3 + a, 3 + a] = 1.0, 1.0
        qm[0, 4], qm[0, 5], qm[1, 5] = d[2], -d[1], d[0]
        qm[1, 3], qm[2, 3], qm[2, 4] = -d[2], d[1], -d[0]
        for a in range(6):
            for b in range(6):
                qm[a, 6 + b] = first[a, b]
        for b in range(12):
            t0, t1, t2 = qm[3, b], qm[4, b], qm[5, b]
            qe[0, b] = qm[0, b] + t1 * dd[2] - t2 * dd[1]
            qe[1, b] = qm[1, b] + t2 * dd[0] - t0 * dd[2]
            qe[2, b] = qm[2, b] + t0 * dd[1] - t1 * dd[0]
            for a in range(3):
                qe[3 + a, b] = qm[3 + a, b]
        for a in range(6):
            for b in range(6):
                qe[a, 6 + b] += second[a, b]
        for a in range(6):
            for b in range(12):
                total = 0.0
                for k in range(6):
                    total += p[a, k] * qe[k, b]
                w[a, b] = total
            w[a, _ONE] = c[a]
        _carry(w, dd, wrench[i, 0], qe, qm)
        _add_half_load_slope(i, 1.0, strain[i, 0], rm, chain, qm, w)
        resultants(i, law, strain, deviation, held)
        tangent(i, law, deviation, held, tangents)
        _equations(i, tangents, rm, wrench[i, 1], qm, w, lack, matrix, right)
        if not _solve(matrix, right):
            return False
        gain[i] = right
        if i == 0:
            break
        _add_half_load_slope(i, -1.0, strain[i, 0], rm, chain, qm, w)
        v[:] = 0.0
        n = wrench[i, 1].copy()
        half_load(i, -1.0, strain[i, 0], rm, chain, n[:3], v)
        qe[:, :] = 0.0
        for a in range(6):
            qe[a, a] = 1.0
        _carry(w, d, n, qm, qe)
        for a in range(6):
            for b in range(6):
                total = w[a, b]
                for k in range(6):
                    total += w[a, 6 + k] * right[k, b]
                p[a, b] = total
            total = w[a, _ONE]
            for k in range(6):
                total += w[a, 6 + k] * right[k, 6]
            c[a] = total
        add_touch_slope(i, x[2 * i], r[2 * i], obstacles, p)
    _walk_back(strain, chain, x, r, gain, change)
    return True


@nb.njit(cache=True)
def _carry(
    w: np.ndarray, d: np.ndarray, wrench: np.ndarray, far: np.ndarray, near: np.ndarray
) -> None:
    """Bring the change ``w`` of a wrench from one place to another, ``d`` before it; ``far`` and
    ``near`` are the changes of the two places."""
    for b in range(13):
        s0, s1, s2 = far[0, b] - near[0, b], far[1, b] - near[1, b], far[2, b] - near[2, b]
        w[3, b] += s1 * wrench[2] - s2 * wrench[1] + d[1] * w[2, b] - d[2] * w[1, b]
        w[4, b] += s2 * wrench[0] - s0 * wrench[2] + d[2] * w[0, b] - d[0] * w[2, b]
        w[5, b] += s0 * wrench[1] - s1 * wrench[0] + d[0] * w[1, b] - d[1] * w[0, b]


@nb.njit(cache=True)
def _equations(
    i: int, tangents: np.ndarray, r: np.ndarray, wrench: np.ndarray, qm: np.ndarray, w: np.ndarray,
    lack: np.ndarray, matrix: np.ndarray, right: np.ndarray,
) -> None:  # fmt: skip
    """The piece's six equations: ``matrix`` (6, 6) times the strains' change = ``right`` (6, 7)
    times (q, 1)."""
    load = np.zeros(6)
    for b in range(13):
        t0, t1, t2 = qm[3, b], qm[4, b], qm[5, b]
        # R^T (dm - theta x m), and R^T (dn - theta x n)
        n0 = w[0, b] - (t1 * wrench[2] - t2 * wrench[1])
        n1 = w[1, b] - (t2 * wrench[0] - t0 * wrench[2])
        n2 = w[2, b] - (t0 * wrench[1] - t1 * wrench[0])
        m0 = w[3, b] - (t1 * wrench[5] - t2 * wrench[4])
        m1 = w[4, b] - (t2 * wrench[3] - t0 * wrench[5])
        m2 = w[5, b] - (t0 * wrench[4] - t1 * wrench[3])
        for a in range(3):
            load[a + 1] = r[0, a] * m0 + r[1, a] * m1 + r[2, a] * m2
            load[a + 3 if a > 0 else 0] = r[0, a] * n0 + r[1, a] * n1 + r[2, a] * n2
        for a in range(6):
            if b < 6:
                right[a, b] = load[a]
            elif b < _ONE:
                matrix[a, b - 6] = tangents[a, b - 6] - load[a]
            else:
                right[a, 6] = load[a] - lack[i, a]


@nb.njit(cache=True)
def _walk_back(
    strain: np.ndarray, chain: Chain, x: np.ndarray, r: np.ndarray, gain: np.ndarray,
    change: np.ndarray,
) -> None:  # fmt: skip
    """Strains' changes from the clamp on, whose own place does not change."""
    q, mean, slope, turn_by = np.zeros(6), np.zeros((3, 3)), np.zeros((3, 3)), np.zeros(3)
    over, d, v = np.zeros((6, 6)), np.zeros(3), np.zeros(3)
    for i in range(len(chain.length)):
        for a in range(6):
            change[i, a] = gain[i, a, 6]
            for b in range(6):
                change[i, a] += gain[i, a, b] * q[b]
        half = chain.length[i] / 2
        _half_piece(i, strain, half, turn_by, v, mean, slope)
        for n in range(2):
            _advance(r[2 * i + n], mean, slope, half, over)
            for a in range(3):
                d[a] = x[2 * i + n + 1, a] - x[2 * i + n, a]
            add_cross(q[3:], d, 1.0, q[:3])
            for a in range(6):
                for b in range(6):
                    q[a] += over[a, b] * change[i, b]


@nb.njit(cache=True)
def _half_piece(
    i: int, strain: np.ndarray, half: float, turn_by: np.ndarray, v: np.ndarray, mean: np.ndarray,
    slope: np.ndarray,
) -> None:  # fmt: skip
    """Mean rotation over half a piece, and the slope of its advance."""
    for a in range(3):
        turn_by[a] = strain[i, a + 1] * half
    v[0], v[1], v[2] = 1 + strain[i, 0], strain[i, 4], strain[i, 5]
    mean_and_slope(turn_by, v, mean, slope)
