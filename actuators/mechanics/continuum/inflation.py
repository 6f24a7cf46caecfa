"""From a state on to a pressure of the cavity, or to the pressure's maximum.

Pressure is changed with adaptive steps from a linear prediction. Where a step fails or lands on an
unstable state, a walk with the pressure unknown takes over: it passes the pressure's maximum, which
is then the answer.
"""

import math

from actuators.mechanics.continuum.newton import Equilibrium, Failure, Target
from actuators.mechanics.continuum.prediction import (
    growth,
    is_near_summit,
    predict,
    predict_by_volume,
    pressure_step,
)
from actuators.mechanics.continuum.tracer import Path, Tracer
from actuators.mechanics.continuum.walk import Walk
from actuators.mechanics.response import Outcome
from actuators.quantities import kilopascals

FIRST_STEP, LARGEST_STEP = 0.05, 0.1
"""Fractions of the pressure range."""
SMALLEST_FIRST_STEP = 1 / 500
"""Fraction of the range below which volume takes over."""
MOST_STEPS = 400
"""Of a walk with the pressure unknown."""
SMALL_VOLUME_STEP = 0.02
"""Failing below this, with the pressure's maximum in sight, ends the path there."""
MOST_SMALL_STEPS = 6


def inflate(
    tracer: Tracer, history: list[Equilibrium], pressure_to: float, stops: list[float] | None
) -> list[Equilibrium]:
    """States from ``history`` on the way to ``pressure_to`` [Pa]: at ``stops``, or every one."""
    sign = math.copysign(1.0, pressure_to - history[-1].pressure)
    visited: list[Equilibrium] = []
    size = abs(pressure_to)
    step = FIRST_STEP * size
    if len(history) > 1:
        step = abs(history[-1].pressure - history[-2].pressure)
    else:
        step = min(step, tracer.first_pressure(history[0]))
    while True:
        last = history[-1]
        goal = stops[0] if stops else pressure_to
        step = min(step, LARGEST_STEP * size, pressure_step(history))
        wanted = last.pressure + sign * step
        if sign * (wanted - goal) > -0.2 * step:
            wanted = goal
        result = tracer.solve(predict(tracer.system, history, wanted), Target(wanted))
        if isinstance(result, Equilibrium) and not result.negative_eigenvalues:
            history = [*history[-2:], result]
            step = abs(wanted - last.pressure) * growth(result.iterations)
            tracer.told(result)
        elif tracer.stopped():
            _how_far(last, visited)
            return visited
        else:
            step = abs(wanted - last.pressure) / 2
            if len(history) == 1 and step >= SMALLEST_FIRST_STEP * size:
                continue
            found = _by_volume(tracer, history, goal, visited, stops is None)
            if found is None:
                return visited
            history = found
        if stops is None or sign * (history[-1].pressure - goal) >= 0:
            visited.append(history[-1])
            if stops:
                stops.pop(0)
        if sign * (history[-1].pressure - pressure_to) >= 0:
            return visited


def _by_volume(
    tracer: Tracer,
    history: list[Equilibrium],
    goal: float,
    visited: list[Equilibrium],
    keep: bool,
) -> list[Equilibrium] | None:
    """Walk until the pressure passes ``goal`` (then the two last states, the last one at
    ``goal``) or a maximum (then None, with the limit state as last visited). None too where the
    pressure is passed by states that are unstable: a body buckles out of them."""
    path = tracer.path
    sign = math.copysign(1.0, goal - history[-1].pressure)
    step = 0.5 * abs(history[-1].volume - history[-2].volume) if len(history) > 1 else 0.0
    step = sign * max(step, 0.02 * history[-1].volume)
    walk = Walk(tracer.system, tracer.solve, history, step)
    unstable_from: float | None = None

    def given_up(share: float) -> bool:
        near = share < SMALL_VOLUME_STEP and is_near_summit(walk.trail.nearest, sign)
        return near or tracer.stopped()

    for _ in range(MOST_STEPS):
        last = walk.trail.last
        result = walk.advance(given_up=given_up)
        if result is None:
            if is_near_summit(walk.trail.nearest, sign) and not tracer.stopped():
                _close_in(tracer, walk.trail.nearest, sign, visited)
                return None
            if not tracer.stopped():
                path.outcome, path.reason = Outcome.STALLED, walk.reason
            _how_far(walk.trail.last, visited)
            return None
        if walk.leapt:
            path.leaps.append((last, result))
        if sign * (result.pressure - last.pressure) <= 0:
            _end_at_limit(tracer, walk.trail.nearest, sign, visited)
            return None
        if not result.negative_eigenvalues:
            unstable_from = None
        elif unstable_from is None:
            unstable_from = result.pressure
        if sign * (result.pressure - goal) >= 0:
            share = (goal - last.pressure) / (result.pressure - last.pressure)
            start = tracer.system.onward(last.state, result.state, share - 1)
            there = tracer.solve(start, Target(goal))
            if isinstance(there, Failure):
                there = tracer.solve(result.state, Target(goal))
            if isinstance(there, Equilibrium) and not there.negative_eigenvalues:
                return [last, there]
            if not tracer.stopped():
                _end_unstable(path, there, unstable_from, visited)
            return None
        tracer.told(result)
        if keep:
            visited.append(result)
    path.outcome = Outcome.STALLED
    path.reason = "the volume changes without the pressure coming to a maximum"
    return None


def _how_far(last: Equilibrium, visited: list[Equilibrium]) -> None:
    """Keep the last state of a path that does not come to its end, also where only some pressures
    are reported, unless a body would not stay in it."""
    known = visited and visited[-1] is last
    if not known and not last.negative_eigenvalues and last.pressure != 0.0:
        visited.append(last)


def _end_unstable(
    path: Path, at_goal: Equilibrium | Failure, since: float | None, visited: list[Equilibrium]
) -> None:
    """End before the states that a body would not stay in."""
    path.outcome = Outcome.STALLED
    if isinstance(at_goal, Failure):
        path.reason = at_goal.reason
        return
    begun = at_goal.pressure if since is None else since
    path.reason = (
        f"from about {kilopascals(begun, 3)} kPa on the shape found is unstable: the body would "
        "buckle out of it, into one that was not computed"
    )
    while visited and visited[-1].negative_eigenvalues:
        visited.pop()


def _close_in(
    tracer: Tracer, trail: list[Equilibrium], sign: float, visited: list[Equilibrium]
) -> None:
    """End at the maximum in sight, although the next step failed: small ones mostly lead across.
    Where they do not, the last state found is as good as the maximum."""
    path, share = tracer.path, SMALL_VOLUME_STEP / 2
    for _ in range(MOST_SMALL_STEPS):
        volume = (1 + sign * share) * trail[-1].volume
        guess = predict_by_volume(tracer.system, trail, volume)
        found = tracer.solve(guess[0], Target(guess[1], volume=volume))
        if tracer.stopped():
            return
        if isinstance(found, Failure):
            share /= 2
        elif sign * (found.pressure - trail[-1].pressure) <= 0:
            _end_at_limit(tracer, [*trail, found], sign, visited)
            return
        else:
            trail = [*trail[-2:], found]
    path.outcome, path.limit = Outcome.LIMIT_POINT, trail[-1]
    if not visited or visited[-1] is not trail[-1]:
        visited.append(trail[-1])  # also where only some pressures are reported


def _end_at_limit(
    tracer: Tracer, around: list[Equilibrium], sign: float, visited: list[Equilibrium]
) -> None:
    path = tracer.path
    path.outcome, path.beyond = Outcome.LIMIT_POINT, around[-1]
    path.limit = top = tracer.summit(around, sign)
    while visited and sign * (visited[-1].volume - top.volume) > 0:
        visited.pop()
    if not visited or top is not visited[-1]:
        visited.append(top)
