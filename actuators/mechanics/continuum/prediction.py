"""Extrapolating a path: the next state, the next step, the pressure's maximum."""

import math
from collections.abc import Sequence

import numpy as np

from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.system import State

LARGEST_VOLUME_STEP = 0.15
"""Fraction of the cavity's volume."""
NEAR_SUMMIT = 0.01
"""Distance below the pressure's extrapolated maximum, as a fraction of it, that counts as being
there: chambers begin to balloon one by one, and each further step costs more than it tells."""
PREDICTOR_STATES = 2
"""States that the prediction extrapolates: linear. A parabola through three was tried and cost more
iterations wherever the step had grown."""


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


def difference(a: State, b: State) -> State:
    return a.moved(-1.0, b)


def lagrange_weights(known: Sequence[float], at: float) -> list[float]:
    """Lagrange weights of the polynomial through values at ``known`` for its value at ``at``."""
    return [
        math.prod((at - other) / (own - other) for k, other in enumerate(known) if k != n)
        for n, own in enumerate(known)
    ]


def combine(states: Sequence[State], weights: Sequence[float]) -> State:
    total = states[0].moved(weights[0] - 1.0, states[0])
    for weight, state in zip(weights[1:], states[1:], strict=True):
        total = total.moved(weight, state)
    return total


def predict(history: list[Equilibrium], pressure: float) -> State:
    """Extrapolation of the last states (up to two) to ``pressure``."""
    recent = history[-PREDICTOR_STATES:]
    weights = lagrange_weights([e.pressure for e in recent], pressure)
    return combine([e.state for e in recent], weights)


def predict_by_volume(trail: list[Equilibrium], volume: float) -> tuple[State, float]:
    """Extrapolation of the last states, and of the pressure, to ``volume``."""
    recent = trail[-PREDICTOR_STATES:]
    weights = lagrange_weights([e.volume for e in recent], volume)
    pressure = sum(w * e.pressure for w, e in zip(weights, recent, strict=True))
    return combine([e.state for e in recent], weights), pressure


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
