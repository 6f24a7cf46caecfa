"""From a state on to a volume of the cavity, its own pressure with each state."""

import math

from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.tracer import Tracer
from actuators.mechanics.continuum.walk import Walk
from actuators.mechanics.response import Outcome

FIRST_VOLUME_STEP = 0.05
"""Fraction of the way to a volume."""
MOST_STEPS = 400
TURNED_BACK = 0.5
"""Part of the way to the farthest volume that a path may go back on before it is left at that: a
chamber that runs away takes less from the others; a path that goes on back is another one."""


def fill(
    tracer: Tracer,
    history: list[Equilibrium],
    begun: Equilibrium,
    volume_to: float,
    stops: list[float] | None,
) -> list[Equilibrium]:
    """States from ``history`` on the way to ``volume_to`` [m3]: at ``stops``, or every one;
    ``begun``: the path's first state."""
    path, first = tracer.path, history[-1]
    way = volume_to - first.volume
    step = FIRST_VOLUME_STEP * abs(way)
    if len(history) > 1:
        step = abs(history[-1].volume - history[-2].volume)
    else:
        step = min(step, tracer.first_volume(first))
    sign = math.copysign(1.0, way)
    walk = Walk(tracer.system, tracer.solve, history, sign * step, leaping=True)
    if len(history) > 1 and sign * (first.volume - history[-2].volume) < 0:
        walk.take_up_turned()
    visited: list[Equilibrium] = []
    farthest = first.volume
    for _ in range(MOST_STEPS):
        last = walk.trail.last
        goal = stops[0] if stops else volume_to
        found = walk.advance(goal, given_up=lambda share: tracer.stopped())
        if found is None:
            if not tracer.stopped():
                path.outcome, path.reason = Outcome.STALLED, walk.reason
            if last is not first and (not visited or visited[-1] is not last):
                visited.append(last)  # how far it came, also where only some volumes are reported
                path.by_arc += walk.past_volume or bool(path.leaps)
            return visited
        if walk.leapt:
            path.leaps.append((last, found))
        if path.limit is None and sign * (found.pressure - last.pressure) < 0:
            top = last if walk.leapt else tracer.summit(walk.trail.nearest, sign)
            # where the path has leapt to another branch, there is no maximum between its states
            path.limit = top if sign * (top.pressure - last.pressure) >= 0 else last
            if stops is None and path.limit is not last:
                _insert(visited, path.limit, last, sign)
        tracer.told(found)
        farthest = sign * max(sign * farthest, sign * found.volume)
        if sign * (farthest - found.volume) > TURNED_BACK * sign * (farthest - begun.volume):
            path.outcome = Outcome.STALLED
            path.reason = "the volume turns back for good: a chamber has run away"
            visited.append(found)
            path.by_arc += 1
            return visited
        reached = walk.arrived
        if stops is None or reached:
            visited.append(found)
            path.by_arc += walk.past_volume or bool(path.leaps)
        if reached and stops:
            stops.pop(0)
        if reached and not stops:
            return visited
    path.outcome = Outcome.STALLED
    path.reason = f"the volume was not reached in {MOST_STEPS} steps"
    return visited


def _insert(visited: list[Equilibrium], limit: Equilibrium, last: Equilibrium, sign: float) -> None:
    """Put the pressure's maximum among the states visited, before or after the last one."""
    if sign * (limit.volume - last.volume) > 0:
        visited.append(limit)
    elif visited:
        visited.insert(len(visited) - 1, limit)
