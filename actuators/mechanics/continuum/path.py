"""Following equilibrium from rest through its loads, then through inflation to a goal.

Towards a pressure, pressure is changed with adaptive steps from a linear prediction. Where a step
fails or lands on an unstable state, a walk with the pressure unknown takes over: it passes the
pressure's maximum, which is then the answer, located by a parabola through the three states around
it. Towards a volume, all of the path is such a walk, and a maximum on the way is noted.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.newton import (
    Equilibrium,
    Failure,
    Target,
    solve_equilibrium,
)
from actuators.mechanics.continuum.prediction import (
    PREDICTOR_STATES,
    combine,
    difference,
    growth,
    is_near_summit,
    lagrange_weights,
    predict,
    predict_by_volume,
    pressure_step,
    summit_volume,
)
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.mechanics.continuum.walk import Walk
from actuators.mechanics.direct_solver import SymmetricSolver
from actuators.mechanics.response import Outcome

FIRST_STEP, LARGEST_STEP = 0.05, 0.1
"""Fractions of the pressure range."""
LARGEST_FIRST_MOVE = 0.1
SMALLEST_SHARE_OF_LOADS = 1 / 256
SMALLEST_FIRST_STEP = 1 / 500
"""Fraction of the range below which volume takes over."""
FIRST_VOLUME_STEP = 0.05
"""Fraction of the way to a volume."""
MOST_STEPS = 400
"""Of a walk with the pressure unknown."""
SMALL_VOLUME_STEP = 0.02
"""Failing below this, with the pressure's maximum in sight, ends the path there."""
MOST_SUMMIT_STEPS, SHARP_SUMMIT = 8, 1e-4
"""Until the pressure's maximum changes by less than this fraction."""

Watch = Callable[[float, float], None]
"""Told the part of the way that is done, 0 to 1, and the pressure [Pa]."""


@dataclass(eq=False)
class Path:
    """Equilibria found, in order. ``beyond``: a state past the limit point, where one was solved:
    the proof that the pressure falls there. ``limit``: the first maximum of the pressure (of
    suction, a minimum) met on the way. ``by_volume``: whether a volume was the goal. ``by_arc``:
    how many of the last points need arc length, where volume control no longer leads on."""

    points: list[Equilibrium] = field(default_factory=list)
    outcome: Outcome = Outcome.CONVERGED
    reason: str = ""
    beyond: Equilibrium | None = None
    limit: Equilibrium | None = None
    by_volume: bool = False
    by_arc: int = 0
    iterations: int = 0


class PathFollower:
    """One mesh's path. ``cancelled`` may return a reason to stop (an outcome), else None."""

    def __init__(
        self,
        system: ContinuumSystem,
        solver: SymmetricSolver,
        *,
        tolerance: float = 1e-5,
        stop: Callable[[], Outcome | None] = lambda: None,
        watch: Watch = lambda share, pressure: None,
    ) -> None:
        self._system, self._solver, self._tolerance = system, solver, tolerance
        self._stop, self._watch = stop, watch
        self._path = Path()
        self._told: Callable[[Equilibrium], None] = lambda found: None

    def follow(self, pressure_to: float, report: Sequence[float] | None) -> Path:
        """Path from zero to ``pressure_to`` [Pa]. ``report``: pressures to stop at in order, the
        last one ``pressure_to``; None keeps every step."""
        return self.reach(Goal.pressure(pressure_to, report))

    def reach(self, goal: Goal) -> Path:
        """Path from rest to a goal."""
        start = self._apply_loads()
        if start is not None:
            self._path.points = [start, *self._continue([start], start, goal)]
        return self._path

    def resume(self, history: Sequence[Equilibrium], first: Equilibrium, goal: Goal) -> Path:
        """The rest of a path that began with ``first`` and whose last states are ``history``; only
        new points are returned."""
        self._path.points = self._continue(list(history), first, goal)
        return self._path

    def _continue(
        self, history: list[Equilibrium], first: Equilibrium, goal: Goal
    ) -> list[Equilibrium]:
        last = history[-1]
        if goal.sign(first) * (goal.value - goal.measure(last)) <= 0.0:
            return []
        self._told = lambda found: self._watch(goal.share(first, found), found.pressure)
        stops = goal.left(first, last)
        self._path.by_volume = goal.by_volume
        if goal.by_volume:
            return self._fill(history, goal.value, stops)
        return self._inflate(history, goal.value, stops)

    def _solve(self, start: State, target: Target) -> Equilibrium | Failure:
        result = solve_equilibrium(
            self._system, self._solver, start, target, tolerance=self._tolerance,
            cancelled=lambda: self._stop() is not None,
        )  # fmt: skip
        self._path.iterations += result.iterations
        return result

    def _stopped(self) -> bool:
        why = self._stop()
        if why is not None:
            self._path.outcome = why
        return why is not None

    def _apply_loads(self) -> Equilibrium | None:
        """State under its loads at zero pressure, in shares small enough to turn by."""
        rest = self._system.rest()
        states: list[tuple[float, State]] = [(0.0, rest)]
        step = self._first_share_of_loads()
        while True:
            done = states[-1][0]
            share = done + step if done + 1.2 * step < 1.0 else 1.0
            recent = states[-PREDICTOR_STATES:]
            weights = lagrange_weights([known for known, _ in recent], share)
            start = combine([state for _, state in recent], weights)
            result = self._solve(start, Target(0.0, loads=share))
            if isinstance(result, Equilibrium):
                if share == 1.0:
                    return result
                states.append((share, result.state))
                step = (share - done) * growth(result.iterations)
            elif self._stopped():
                return None
            else:
                step = (share - done) / 2
                if step < SMALLEST_SHARE_OF_LOADS:
                    self._path.outcome = Outcome.STALLED
                    self._path.reason = f"weight and outer loads beyond {done:.0%}: {result.reason}"
                    return None

    def _first_share_of_loads(self) -> float:
        """Share whose linear answer moves the body by :data:`LARGEST_FIRST_MOVE` of its size."""
        system = self._system
        balance = system.linearise(system.rest(), 0.0)
        system.factorize(self._solver)
        self._path.iterations += 1
        return min(1.0, self._share_of_first_move(self._solver.solve(-system.reduce(balance))))

    def _first_pressure(self, start: Equilibrium) -> float:
        """Pressure [Pa] whose linear answer, by the tangent last factorised, moves the body by
        :data:`LARGEST_FIRST_MOVE` of its size."""
        _, gradient = self._system.volume(start.state)
        return self._share_of_first_move(self._solver.solve(gradient))

    def _share_of_first_move(self, solution: np.ndarray) -> float:
        largest = float(np.abs(solution).max())
        size = float(np.ptp(self._system.mesh.nodes, axis=0).max())
        return LARGEST_FIRST_MOVE * size / largest if largest > 0 else math.inf

    def _inflate(
        self, history: list[Equilibrium], pressure_to: float, stops: list[float] | None
    ) -> list[Equilibrium]:
        sign = math.copysign(1.0, pressure_to - history[-1].pressure)
        visited: list[Equilibrium] = []
        size = abs(pressure_to)
        step = FIRST_STEP * size
        if len(history) > 1:
            step = abs(history[-1].pressure - history[-2].pressure)
        else:
            step = min(step, self._first_pressure(history[0]))
        while True:
            last = history[-1]
            goal = stops[0] if stops else pressure_to
            step = min(step, LARGEST_STEP * size, pressure_step(history))
            wanted = last.pressure + sign * step
            if sign * (wanted - goal) > -0.2 * step:
                wanted = goal
            result = self._solve(predict(history, wanted), Target(wanted))
            if isinstance(result, Equilibrium) and not result.negative_eigenvalues:
                history = [*history[-2:], result]
                step = abs(wanted - last.pressure) * growth(result.iterations)
                self._told(result)
            elif self._stopped():
                return visited
            else:
                step = abs(wanted - last.pressure) / 2
                if len(history) == 1 and step >= SMALLEST_FIRST_STEP * size:
                    continue
                found = self._inflate_by_volume(history, goal, visited, stops is None)
                if found is None:
                    return visited
                history = found
            if stops is None or sign * (history[-1].pressure - goal) >= 0:
                visited.append(history[-1])
                if stops:
                    stops.pop(0)
            if sign * (history[-1].pressure - pressure_to) >= 0:
                return visited

    def _inflate_by_volume(
        self, history: list[Equilibrium], goal: float, visited: list[Equilibrium], keep: bool
    ) -> list[Equilibrium] | None:
        """Walk until the pressure passes ``goal`` (then the two last states, the last one at
        ``goal``) or a maximum (then None, with the limit state as last visited)."""
        path = self._path
        sign = math.copysign(1.0, goal - history[-1].pressure)
        step = 0.5 * abs(history[-1].volume - history[-2].volume) if len(history) > 1 else 0.0
        step = sign * max(step, 0.02 * history[-1].volume)
        walk = Walk(self._system, self._solve, history, step)

        def given_up(share: float) -> bool:
            if self._stopped():
                return True
            near = share < SMALL_VOLUME_STEP and is_near_summit(walk.trail, sign)
            if near:
                path.outcome, path.limit = Outcome.LIMIT_POINT, walk.trail[-1]
            return near

        for _ in range(MOST_STEPS):
            last = walk.trail[-1]
            result = walk.advance(given_up=given_up)
            if result is None:
                if path.limit is None and not self._stopped():
                    path.outcome, path.reason = Outcome.STALLED, walk.reason
                return None
            if sign * (result.pressure - last.pressure) <= 0:
                self._end_at_limit(walk.trail, sign, visited)
                return None
            if sign * (result.pressure - goal) >= 0:
                share = (goal - last.pressure) / (result.pressure - last.pressure)
                start = last.state.moved(share, difference(result.state, last.state))
                there = self._solve(start, Target(goal))
                if isinstance(there, Equilibrium) and not there.negative_eigenvalues:
                    return [last, there]
                goal = sign * np.inf  # an unstable stretch: leave it to the volume
            self._told(result)
            if keep:
                visited.append(result)
        path.outcome = Outcome.STALLED
        path.reason = "the volume changes without the pressure coming to a maximum"
        return None

    def _end_at_limit(
        self, around: list[Equilibrium], sign: float, visited: list[Equilibrium]
    ) -> None:
        path = self._path
        path.outcome, path.beyond = Outcome.LIMIT_POINT, around[-1]
        path.limit = top = self._summit(around, sign)
        while visited and sign * (visited[-1].volume - top.volume) > 0:
            visited.pop()
        if not visited or top is not visited[-1]:
            visited.append(top)

    def _summit(self, around: list[Equilibrium], sign: float) -> Equilibrium:
        """Equilibrium of the highest pressure between the last three states, the middle one being
        higher than the others: where parabolas through the three nearest have their maximum."""
        if len(around) < 3:
            return around[-2]
        below, top, above = around[-3:]
        for _ in range(MOST_SUMMIT_STEPS):
            if not sign * below.volume < sign * top.volume < sign * above.volume:
                break
            volume = summit_volume([below, top, above], sign)
            near = below if sign * (volume - top.volume) < 0 else above
            guess = predict_by_volume([near, top], volume)
            found = self._solve(guess[0], Target(guess[1], volume=volume))
            if isinstance(found, Failure):
                break
            gain = sign * (found.pressure - top.pressure)
            if gain > 0:
                below, above = (top, above) if near is above else (below, top)
                top = found
            elif near is above:
                above = found
            else:
                below = found
            if abs(gain) < SHARP_SUMMIT * abs(top.pressure):
                break
        return top

    def _fill(
        self, history: list[Equilibrium], volume_to: float, stops: list[float] | None
    ) -> list[Equilibrium]:
        """States on the way to ``volume_to``, its own pressure with each."""
        path, first = self._path, history[-1]
        way = volume_to - first.volume
        step = FIRST_VOLUME_STEP * abs(way)
        if len(history) > 1:
            step = abs(history[-1].volume - history[-2].volume)
        else:
            step = min(step, self._first_volume(first))
        sign = math.copysign(1.0, way)
        walk = Walk(self._system, self._solve, history, sign * step)
        visited: list[Equilibrium] = []
        for _ in range(MOST_STEPS):
            last = walk.trail[-1]
            goal = stops[0] if stops else volume_to
            found = walk.advance(goal, given_up=lambda share: self._stopped())
            if found is None:
                if not self._stopped():
                    path.outcome, path.reason = Outcome.STALLED, walk.reason
                return visited
            if path.limit is None and sign * (found.pressure - last.pressure) < 0:
                path.limit = self._summit(walk.trail, sign)
                between = sign * (found.volume - path.limit.volume) > 0
                if stops is None and between and path.limit is not last:
                    visited.append(path.limit)
                    path.by_arc += walk.by_arc
            self._told(found)
            reached = walk.arrived
            if stops is None or reached:
                visited.append(found)
                path.by_arc += walk.by_arc
            if reached and stops:
                stops.pop(0)
            if reached and not stops:
                return visited
        path.outcome = Outcome.STALLED
        path.reason = f"the volume was not reached in {MOST_STEPS} steps"
        return visited

    def _first_volume(self, start: Equilibrium) -> float:
        """Change of volume [m3] that goes with :meth:`_first_pressure`."""
        _, gradient = self._system.volume(start.state)
        solution = self._solver.solve(gradient)
        return abs(float(gradient @ solution)) * self._share_of_first_move(solution)
