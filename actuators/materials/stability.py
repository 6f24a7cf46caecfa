"""Drucker's stability: how far a law may be stretched before it softens into instability.

Stable means that every small volume-preserving change of the principal stretches raises the stress
along itself: d2W / dlog(l_i) dlog(l_j) is positive on the plane sum dlog(l) = 0. Three tension
paths are walked. Compression adds none: uniaxial compression to l is equibiaxial tension to
l^(-1/2), planar compression is planar tension.
"""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from actuators.materials.law import HyperelasticLaw

LARGEST_STRETCH = 12.0
"""Largest stretch that is looked at."""
# log-stretches of the three paths, per log of the largest stretch
_PATHS = {
    "uniaxial": (1.0, -0.5, -0.5),
    "equibiaxial": (1.0, 1.0, -2.0),
    "planar": (1.0, 0.0, -1.0),
}
# an orthonormal basis of the plane sum dlog l = 0
_PLANE = np.array([[1, -1, 0], [1, 1, -2]]) / np.sqrt([[2.0], [6.0]])


@dataclass(frozen=True)
class StableRange:
    """Stretch at which each tension path becomes unstable; infinite where none does up to
    :data:`LARGEST_STRETCH`."""

    uniaxial: float
    equibiaxial: float
    planar: float

    @property
    def smallest(self) -> tuple[str, float]:
        """Path that becomes unstable first, and the stretch."""
        paths = {name: float(getattr(self, name)) for name in _PATHS}
        first = min(paths, key=lambda name: paths[name])
        return first, paths[first]


@lru_cache(maxsize=256)
def stable_range(law: HyperelasticLaw) -> StableRange:
    """Where ``law`` stops being stable in tension."""
    return StableRange(**{name: _limit(law, np.array(path)) for name, path in _PATHS.items()})


def least_stiffness(law: HyperelasticLaw, stretches: np.ndarray) -> np.ndarray:
    """Smallest eigenvalue [Pa] of the tangent on volume-preserving changes, (..., 3) -> (...)."""
    tangent = _PLANE @ law.logarithmic_hessian(stretches) @ _PLANE.T
    return np.linalg.eigvalsh(tangent)[..., 0]


def _limit(law: HyperelasticLaw, path: np.ndarray) -> float:
    log = np.linspace(0.0, math.log(LARGEST_STRETCH), 2001)
    unstable = np.flatnonzero(least_stiffness(law, np.exp(log[:, None] * path)) <= 0)
    if len(unstable) == 0:
        return math.inf
    if unstable[0] == 0:
        return 1.0
    low, high = log[unstable[0] - 1], log[unstable[0]]
    for _ in range(40):
        middle = (low + high) / 2
        stable = least_stiffness(law, np.exp(middle * path)) > 0
        low, high = (middle, high) if stable else (low, middle)
    return math.exp(low)
