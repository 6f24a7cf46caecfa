"""The screw motion of a piece of helix, with its first and second derivatives.

A rod with constant strains e = (eps, tau, beta, gamma) has x' = (1 + eps) R e1, R' = R [w]x with
w = (tau, beta, gamma), so that over a length s

    [R x; 0 1] = exp(s Xi),   Xi = [[w]x, (1 + eps) e1; 0 0]

and Xi is linear in e: the exponential's series gives value and derivatives alike.
"""

from dataclasses import dataclass

import numpy as np
from numba import njit

STRAINS = 4
_TERMS = 40  # enough for three radians and more


@dataclass(frozen=True, eq=False)
class Motion:
    """x -> rotation x + shift, a function of the four rod strains.

    ``rotation``: (3, 3), ``shift``: (3,) [m]; ``turn_rate``: (4, 3, 3), ``shift_rate``: (4, 3) per
    strain; ``turn_second``: (4, 4, 3, 3), ``shift_second``: (4, 4, 3).
    """

    rotation: np.ndarray
    shift: np.ndarray
    turn_rate: np.ndarray
    shift_rate: np.ndarray
    turn_second: np.ndarray
    shift_second: np.ndarray

    def before(self, turn: np.ndarray) -> "Motion":
        """This motion after a constant ``turn`` (3, 3)."""
        return Motion(
            self.rotation @ turn, self.shift, self.turn_rate @ turn, self.shift_rate,
            self.turn_second @ turn, self.shift_second,
        )  # fmt: skip


def screw(strain: np.ndarray, length: float) -> Motion:
    """Motion along ``length`` [m] of a rod with ``strain`` (4,); negative lengths go back."""
    value, first, second = _exponential(np.asarray(strain, dtype=float), float(length))
    return Motion(
        value[:3, :3], value[:3, 3], first[:, :3, :3], first[:, :3, 3],
        second[:, :, :3, :3], second[:, :, :3, 3],
    )  # fmt: skip


@njit(cache=True)
def _exponential(strain: np.ndarray, length: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    rate = np.zeros((STRAINS, 4, 4))
    rate[0, 0, 3] = length
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        rate[k + 1, j, i] = length
        rate[k + 1, i, j] = -length
    generator = np.zeros((4, 4))
    generator[0, 3] = length
    for k in range(STRAINS):
        generator += strain[k] * rate[k]
    power, next_ = np.eye(4), np.empty((4, 4))
    power_1 = np.zeros((STRAINS, 4, 4))
    power_2 = np.zeros((STRAINS, STRAINS, 4, 4))
    value, first, second = power.copy(), power_1.copy(), power_2.copy()
    for n in range(1, _TERMS):
        for k in range(STRAINS):
            for m in range(k, STRAINS):
                next_[:] = 0.0
                _add_product(power_2[k, m], generator, 1.0 / n, next_)
                _add_product(power_1[k], rate[m], 1.0 / n, next_)
                _add_product(power_1[m], rate[k], 1.0 / n, next_)
                power_2[k, m] = next_
                power_2[m, k] = next_
        for k in range(STRAINS):
            next_[:] = 0.0
            _add_product(power_1[k], generator, 1.0 / n, next_)
            _add_product(power, rate[k], 1.0 / n, next_)
            power_1[k] = next_
        next_[:] = 0.0
        _add_product(power, generator, 1.0 / n, next_)
        power[:] = next_
        value += power
        first += power_1
        second += power_2
        if n > 3 and np.abs(power_2).max() <= 1e-17 * np.abs(second).max():
            break
    return value, first, second


@njit(cache=True)
def _add_product(a: np.ndarray, b: np.ndarray, factor: float, out: np.ndarray) -> None:
    """out += factor a b, (4, 4) each."""
    for i in range(4):
        for k in range(4):
            if a[i, k] != 0.0:
                for j in range(4):
                    out[i, j] += factor * a[i, k] * b[k, j]
