"""What acts beyond every piece of a rod, and how far its resultants are from it (compiled)."""

import numba as nb
import numpy as np

from actuators.mechanics.rod.chain import Chain, Law, Obstacles
from actuators.mechanics.rod.kinematics import resultants
from actuators.mechanics.rod.small import add_cross, turned_back
from actuators.mechanics.rod.touching import add_touch


@nb.njit(cache=True)
def half_load(
    i: int, side: float, stretch: float, r: np.ndarray, chain: Chain, n: np.ndarray, m: np.ndarray
) -> None:
    """Add force and moment about the middle of what acts on half a piece: the half beyond
    (``side`` 1) or before (-1)."""
    arm, force = np.zeros(3), np.zeros(3)
    quarter = side * chain.length[i] * (1 + stretch) / 4
    for a in range(3):
        arm[a] = quarter * r[a, 0] + chain.height[i] * r[a, 2]
        force[a] = chain.weight[i] / 2 * chain.gravity[a]
        n[a] += force[a]
    add_cross(arm, force, 1.0, m)
    if chain.outside != 0.0:
        area = chain.width[i] * chain.length[i] * (1 + stretch) / 2
        for a in range(3):
            arm[a] = quarter * r[a, 0]
            force[a] = chain.outside * area * r[a, 2]
            n[a] += force[a]
        add_cross(arm, force, 1.0, m)


@nb.njit(cache=True)
def lack_of_balance(
    strain: np.ndarray, chain: Chain, law: Law, obstacles: Obstacles, x: np.ndarray, r: np.ndarray,
    lack: np.ndarray, wrench: np.ndarray,
) -> float:  # fmt: skip
    """How far the pieces' resultants exceed the loads', ``lack`` (s, 6), and the turn that this
    amounts to [rad]. ``wrench``: (s, 2, 6) force and moment beyond every piece's end and middle,
    each about that place."""
    s = len(chain.length)
    n, m, local, d = np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3)
    deviation, held = np.zeros(6), np.zeros(6)
    for a in range(3):
        n[a] = chain.tip_force[a]
        d[a] = chain.tip_height * r[2 * s, a, 2]
    add_cross(d, n, 1.0, m)
    add_touch(s, x[2 * s], r[2 * s], obstacles, n, m)
    total = 0.0
    for i in range(s - 1, -1, -1):
        rm = r[2 * i + 1]
        for a in range(3):
            wrench[i, 0, a], wrench[i, 0, a + 3] = n[a], m[a]
            d[a] = x[2 * i + 2, a] - x[2 * i + 1, a]
        add_cross(d, n, 1.0, m)
        half_load(i, 1.0, strain[i, 0], rm, chain, n, m)
        turned_back(rm, m, local)
        for a in range(3):
            wrench[i, 1, a], wrench[i, 1, a + 3] = n[a], m[a]
        resultants(i, law, strain, deviation, held)
        for a in range(3):
            lack[i, a + 1] = held[a + 1] - local[a]
        turned_back(rm, n, local)
        lack[i, 0] = held[0] - local[0]
        lack[i, 4], lack[i, 5] = held[4] - local[1], held[5] - local[2]
        for a in range(6):
            wrong = 0.0
            for b in range(6):
                wrong += law.compliance[i, a, b] * lack[i, b]
            # stretch and shear count as turns of a piece
            total += abs(wrong) * (chain.length[i] if 0 < a < 4 else 1 / s)
        if i > 0:
            half_load(i, -1.0, strain[i, 0], rm, chain, n, m)
            for a in range(3):
                d[a] = x[2 * i + 1, a] - x[2 * i, a]
            add_cross(d, n, 1.0, m)
            add_touch(i, x[2 * i], r[2 * i], obstacles, n, m)
    return total
