"""Following one pitch from rest to a pressure, or to the pressure's maximum.

Every state found is linearised anew: that gives its rod law, the direction in which the path goes
on, and the tangent with which the next state is sought. States are extrapolated by parabolas.
"""

import math
from dataclasses import dataclass

import numpy as np

from actuators.mechanics.cell.helical.law import PointLaw, bending_about_x3, point_law
from actuators.mechanics.cell.helical.newton import Found, Missed, Solver
from actuators.mechanics.cell.helical.step import Step, difference, step_of
from actuators.mechanics.cell.helical.system import CellState
from actuators.mechanics.cell.helical.tangent import Factor, Tangent, Target
from actuators.mechanics.direct_solver import FactorizationError
from actuators.mechanics.response import Outcome

LARGEST_STEP = 1 / 8
"""Of the pressure range."""
FIRST_MOVE = 0.03
"""Largest displacement of the first step [body sizes], by the linear answer."""
LARGEST_GROWTH = 0.25
"""Of the cavity in one step, by the last slope."""
EMPTY = 0.2
"""Share of the cavity at rest below which steps of its volume shrink no further with it."""
SMALLEST_STEP = 1 / 400
"""Of the range (or of the cavity's volume) below which no more is tried."""
SHARP_SUMMIT = 1e-4
"""Change of the pressure's maximum, as a fraction, that ends the search for it."""
NEAR = 2e-5
"""Distance [body sizes] at which a tangent stands for that of a state: farther off, pressures of
elements that are out of balance make it another."""
CRAWL = 1e-4
"""Step over the range (or the volume) below which steps that go on shrinking lead nowhere."""
FLAT = 0.01
"""Share of the pressure that may be missing to its maximum where a path that ends for want of a
state ends there."""
AHEAD = 1.25
"""Of the pressure asked for: as far as the pressure's maximum is looked for beyond it, ..."""
IN_SIGHT = 0.6
"""... where the last slopes say that no more than this share is left to rise."""
ACROSS_EVERY = 4
MOST_STEPS = 80


@dataclass(frozen=True, eq=False)
class Point:
    """An equilibrium.

    ``volume`` of the half pitch [m3]; ``across``: stiffness against bending about X3 [N m2], of
    every second point only; ``rate`` of the state per pressure; ``growth`` of the half volume per
    pressure [m3/Pa]; ``unstable`` under constant pressure; ``wrinkles``: stable only because
    embedded sheets under compression are taken to stay flat.
    """

    state: CellState
    pressure: float
    volume: float
    law: PointLaw
    across: float | None
    rate: Step
    growth: float
    unstable: bool
    wrinkles: bool = False


@dataclass(eq=False)
class Course:
    """Points in order; how it ended, and ``limit`` [Pa] where the pressure has its maximum, at the
    last point or not far beyond it."""

    points: list[Point]
    outcome: Outcome = Outcome.CONVERGED
    limit: float | None = None
    reason: str = ""


class Follower:
    """One cell on its way to ``pressure_to`` [Pa], negative for suction."""

    def __init__(self, solver: Solver, pressure_to: float) -> None:
        self._solver, self._system = solver, solver.system
        self._goal = pressure_to
        self.course = Course([])

    def run(self) -> Course:
        """The whole path."""
        course = self.course
        point = self._at(self._system.rest(), 0.0, None)
        if point is None:
            course.outcome, course.reason = Outcome.STALLED, "the undeformed cell is singular"
            return course
        course.points.append(point)
        if self._goal != 0.0 and not self._by_pressure():
            self._by_volume()
        if self._goal != 0.0 and course.outcome is Outcome.CONVERGED:
            self._look_ahead()
        return course

    def _look_ahead(self) -> None:
        """Whether the pressure's maximum lies just beyond the goal, where chambers in a row begin
        to differ. Its points are not kept."""
        points = self.course.points
        if _left_to_rise(points[-2], points[-1]) > IN_SIGHT:
            return
        scout = Follower(self._solver, AHEAD * self._goal)
        scout.course.points = [points[0], *points[-2:]]
        if not scout._by_pressure():
            scout._by_volume()
        if scout.course.outcome is Outcome.LIMIT_POINT:
            self.course.limit = scout.course.limit

    def _by_pressure(self) -> bool:
        """Steps of given pressure; False where they lead no further."""
        points, goal = self.course.points, self._goal
        moved = points[0].rate.length
        step = min(LARGEST_STEP * abs(goal), FIRST_MOVE * self._system.size / moved)
        while len(points) < MOST_STEPS:
            last = points[-1]
            step = min(step, LARGEST_STEP * abs(goal), self._longest(last))
            left = abs(goal - last.pressure)
            if step > 0.7 * left:
                step = left if step >= left else left / 2
            wanted = goal if step == left else last.pressure + math.copysign(step, goal)
            guess = self._ahead(wanted - last.pressure, by_volume=False)
            found = self._solver.solve(guess, Target(wanted))
            if isinstance(found, Found):
                point = self._point(found)
                if point is not None and not point.unstable:
                    points.append(point)
                    if wanted == goal:
                        return True
                    step = abs(wanted - last.pressure) * _pace(found)
                    if _pace(found) < 1.0 and step < CRAWL * abs(goal):
                        return False
                    continue
            step = abs(wanted - last.pressure) / 3
            if step < SMALLEST_STEP * abs(goal) * (20 if len(points) > 3 else 1):
                return False
        self.course.outcome, self.course.reason = Outcome.STALLED, "too many steps"
        return True

    def _longest(self, last: Point) -> float:
        """Largest pressure step that the last slope allows."""
        return LARGEST_GROWTH * self._room(last) / abs(last.growth) if last.growth else math.inf

    def _room(self, last: Point) -> float:
        """Volume [m3] that steps are measured by: the cavity's, but suction that empties it would
        make them ever smaller."""
        return max(last.volume, EMPTY * self.course.points[0].volume)

    def _by_volume(self) -> None:
        """Steps of given volume, past the pressure's maximum."""
        course, goal = self.course, self._goal
        points, sign = course.points, math.copysign(1.0, goal)
        trail = [points[-1]]
        before = points[-2] if len(points) > 1 else points[-1]
        step = max(abs(points[-1].volume - before.volume), 0.01 * points[-1].volume) / 2
        while len(points) < MOST_STEPS:
            last = trail[-1]
            step = min(step, 0.15 * self._room(last))
            change = math.copysign(step, goal)
            guess = self._ahead(change, by_volume=True)
            rise = last.pressure + change / last.growth
            target = Target(rise, volume=last.volume + change)
            found = self._solver.solve(guess, target)
            point = self._point(found) if isinstance(found, Found) else None
            if point is None or isinstance(found, Missed):
                step /= 3
                if step < SMALLEST_STEP * self._room(last):
                    self._end("no state of equilibrium nearby was found")
                    return
                continue
            if sign * (point.pressure - goal) >= 0.0 and not point.unstable:
                self._finish(last, point)
                return
            if point.unstable:
                self._summit(last, point)
                return
            points.append(point)
            trail.append(point)
            step *= _pace(found)
            if _pace(found) < 1.0 and step < CRAWL * self._room(last):
                break
        self._end("too many steps, or ever smaller ones")

    def _end(self, reason: str) -> None:
        """Where no step leads on: at the pressure's maximum, if it is as good as there."""
        course, points = self.course, self.course.points
        course.outcome, course.reason = Outcome.STALLED, reason
        if len(points) > 1 and _left_to_rise(points[-2], points[-1]) < FLAT:
            course.outcome, course.limit = Outcome.LIMIT_POINT, points[-1].pressure

    def _finish(self, last: Point, beyond: Point) -> None:
        """The goal's pressure, which lies between two points."""
        share = (self._goal - last.pressure) / (beyond.pressure - last.pressure)
        volume = last.volume + share * (beyond.volume - last.volume)
        found = self._solver.solve(beyond.state, Target(self._goal, volume=volume))
        if isinstance(found, Found):
            found = self._solver.solve(found.state, Target(self._goal))
        point = self._point(found) if isinstance(found, Found) else None
        if point is not None:
            self.course.points.append(point)
        else:
            self.course.outcome, self.course.reason = Outcome.STALLED, "the last step failed"

    def _summit(self, below: Point, above: Point) -> None:
        """The pressure's maximum between a stable and an unstable point: where dp/dV = 0."""
        course, sign = self.course, math.copysign(1.0, self._goal)
        best = below
        for _ in range(8):
            volume = _flat(below, above)
            found = self._solver.solve(above.state, Target(above.pressure, volume=volume))
            if not isinstance(found, Found):
                break
            point = self._point(found)
            if point is None:
                break
            change = abs(point.pressure - best.pressure)
            if point.unstable:
                above = point
            else:
                below = point
            if sign * point.pressure > sign * best.pressure:
                best = point
            if change <= SHARP_SUMMIT * abs(best.pressure):
                break
        if best is not course.points[-1]:
            course.points.append(best)
        course.outcome, course.limit = Outcome.LIMIT_POINT, best.pressure

    def _point(self, found: Found) -> Point | None:
        """Law and direction at an equilibrium, by the last tangent if that was made near enough."""
        if found.distance <= NEAR:
            point = self._at(found.state, found.pressure, found.factor)
            if point is not None and not point.unstable:
                return point
        return self._at(found.state, found.pressure, None)

    def _at(self, state: CellState, pressure: float, factor: Factor | None) -> Point | None:
        factor = factor or self._solver.factor(state, pressure)
        if factor is None:
            return None
        system, number = self._system, len(self.course.points)
        try:
            tangent = Tangent(factor, Target(pressure))
            solution, growth = tangent.rate()
            law = point_law(factor)
            across = bending_about_x3(factor) if number % ACROSS_EVERY == 0 else None
        except (FactorizationError, np.linalg.LinAlgError):
            return None
        rate = step_of(system, state, solution, None, np.zeros(0), 1.0)
        volume, unstable = system.volume(state), tangent.unstable()
        wrinkles = unstable and self._held_by_flat_sheets(state, pressure)
        unstable = unstable and not wrinkles
        return Point(state, pressure, volume, law, across, rate, growth, unstable, wrinkles)

    def _held_by_flat_sheets(self, state: CellState, pressure: float) -> bool:
        """Whether an unstable state is stable once sheets under compression are held flat."""
        if not (state.nodes.sheet < 0.0).any():
            return False
        flat = self._solver.factor(state, pressure, sheets_flat=True)
        return flat is not None and not Tangent(flat, Target(pressure)).unstable()

    def _ahead(self, change: float, *, by_volume: bool) -> CellState:
        """The cubic through the last two points with their directions."""
        points = self.course.points
        last = points[-1]
        scale = 1 / last.growth if by_volume else 1.0
        if len(points) < 2:
            return last.rate.taken(self._system, last.state, change * scale)
        before = points[-2]
        width = last.volume - before.volume if by_volume else last.pressure - before.pressure
        back = 1 / before.growth if by_volume else 1.0
        s = 1 + change / width
        step = difference(before.state, last.state).times(-((s - 1) ** 2) * (2 * s + 1))
        slopes = [s * (s - 1) ** 2 * width * back, s * s * (s - 1) * width * scale]
        return step.combined(slopes, [before.rate, last.rate]).taken(self._system, last.state, 1.0)


def _flat(below: Point, above: Point) -> float:
    """Volume where the cubic p(V) through two points with their slopes is flat."""
    width = above.volume - below.volume
    rise = above.pressure - below.pressure
    first, second = width / below.growth, width / above.growth
    c = [first + second - 2 * rise, 3 * rise - 2 * first - second, first]
    roots = np.roots([3 * c[0], 2 * c[1], c[2]])
    inside = [r.real for r in roots if abs(r.imag) < 1e-9 and 0.02 < r.real < 0.98]
    share = inside[0] if inside else 0.5
    return below.volume + share * width


def _left_to_rise(before: Point, last: Point) -> float:
    """By what share the pressure still rises to where its slope over the volume, which falls along
    a straight line through those at two points, is 0; infinite where it does not fall."""
    slope, earlier = 1 / last.growth, 1 / before.growth
    falls = earlier - slope
    if slope <= 0.0 or falls <= 0.0 or last.pressure == 0.0:
        return math.inf
    further = (last.volume - before.volume) * slope / falls
    return abs(further * slope / 2 / last.pressure)


def _pace(found: Found) -> float:
    """Next step over this one."""
    if found.tangents == 1:
        return 2.0 if found.distance <= 3e-3 else 1.3
    return 1.0 if found.tangents == 2 else 0.6
