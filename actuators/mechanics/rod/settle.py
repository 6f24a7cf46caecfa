"""Newton's method for a loaded rod at one law (compiled)."""

import math

import numba as nb
import numpy as np

from actuators.mechanics.rod.balance import lack_of_balance
from actuators.mechanics.rod.chain import Chain, Law, Obstacles
from actuators.mechanics.rod.kinematics import sheared_shape
from actuators.mechanics.rod.sweep import correction

_TOLERANCE = 1e-8  # turns of all pieces together [rad]: far below what any plot or test resolves
_ITERATIONS = 60


@nb.njit(cache=True)
def settle(strain: np.ndarray, chain: Chain, law: Law, obstacles: Obstacles) -> tuple[int, bool]:
    """Bring ``strain`` (s, 6) into equilibrium. Returns iterations, and whether it was found."""
    s = len(chain.length)
    lack, change, trial = np.zeros((s, 6)), np.zeros((s, 6)), np.zeros((s, 6))
    wrench = np.zeros((s, 2, 6))
    x, r = sheared_shape(strain, chain.length)
    error = lack_of_balance(strain, chain, law, obstacles, x, r, lack, wrench)
    for iteration in range(_ITERATIONS):
        if error < _TOLERANCE:
            return iteration, True
        if not correction(strain, chain, law, obstacles, x, r, lack, wrench, change):
            return iteration, False
        step, found = 2.0, math.inf
        while step > 1e-3 and not found < (1 - step / 4) * error:
            step /= 2
            least = 0.0
            for i in range(s):
                for a in range(6):
                    trial[i, a] = strain[i, a] + step * change[i, a]
                least = min(least, trial[i, 0])
            if least <= -0.9:  # a piece pressed to nothing
                continue
            x, r = sheared_shape(trial, chain.length)
            found = lack_of_balance(trial, chain, law, obstacles, x, r, lack, wrench)
        if not found < error:
            return iteration, False
        strain[:, :] = trial
        error = found
    return _ITERATIONS, False
