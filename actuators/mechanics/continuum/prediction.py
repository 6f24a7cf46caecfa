"""Extrapolating a path: the next state, the next step, the pressure's maximum.

States are extrapolated from two, linearly; a parabola through three was tried and cost more
iterations wherever the step had grown.
"""

import math
from collections.abc import Sequence

import numpy as np

from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.system import ContinuumSystem, State

LARGEST_VOLUME_STEP = 0.15
"""Fraction of the cavity's volume."""
NEAR_SUMMIT = 0.01
"""Distance below the pressure's extrapolated maximum, as a fraction of it, that counts as being
there: chambers begin to balloon one by one, and each further step costs more than it tells."""


def growth(iterations: int) -> float:
    """Next step over this one: easy steps may grow."""
    return {1: 2.0, 2: 1.5, 3: 1.2}.get(iterations, 0.8 if iterations > 5 else 1.0)


def pressure_step(history: Sequence[Equilibrium]) -> float:
    """Step in pressure for the largest step in volume, by the last slope."""
    if len(history) < 2:
        return math.inf
    last, before = history[-1], history[-2]
    change = last.pressure - before.pressure
    slope = (last.volume - before.volume) / change if change else 0.0
    return LARGEST_VOLUME_STEP * last.volume / slope if slope > 0 else math.inf


def predict(system: ContinuumSystem, history: Sequence[Equilibrium], pressure: float) -> State:
    """Extrapolation of the last two states (or the last one) to ``pressure``."""
    last = history[-1]
    if len(history) < 2:
        return last.state
    before = history[-2]
    if last.pressure == before.pressure:  # told by volume: nothing says how they go on
        return last.state
    ratio = (pressure - last.pressure) / (last.pressure - before.pressure)
    return system.onward(before.state, last.state, ratio)


def predict_by_volume(
    system: ContinuumSystem, trail: Sequence[Equilibrium], volume: float
) -> tuple[State, float]:
    """Extrapolation of the last two states (or the last one), and of the pressure, to
    ``volume``."""
    last = trail[-1]
    if len(trail) < 2:
        return last.state, last.pressure
    before = trail[-2]
    if last.volume == before.volume:
        return last.state, last.pressure
    ratio = (volume - last.volume) / (last.volume - before.volume)
    pressure = last.pressure + ratio * (last.pressure - before.pressure)
    return system.onward(before.state, last.state, ratio), pressure


def is_near_summit(trail: Sequence[Equilibrium], sign: float = 1.0) -> bool:
    """Whether the parabola p(V) through the last three states has its maximum less than
    :data:`NEAR_SUMMIT` above the last one; ``sign`` is -1 where both fall (suction)."""
    if len(trail) < 3:
        return False
    v = sign * np.array([e.volume - trail[-1].volume for e in trail[-3:]])
    p = sign * np.array([e.pressure for e in trail[-3:]])
    a, b, c = np.polyfit(v, p, 2)
    return bool(a < 0 and b > 0 and b * b / (-4 * a) < NEAR_SUMMIT * c)


def summit_volume(three: list[Equilibrium], sign: float = 1.0) -> float:
    """Volume at the maximum of the parabola p(V) through three states; ``sign`` is -1 where p is
    suction, and has a minimum."""
    v = np.array([e.volume for e in three])
    p = sign * np.array([e.pressure for e in three])
    a, b, _ = np.polyfit(v - v[1], p, 2)
    return float(v[1] - b / (2 * a)) if a < 0 else float(v[1])
