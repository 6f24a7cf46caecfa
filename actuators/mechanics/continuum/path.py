"""Following equilibrium from rest through its loads, then through inflation to a goal."""

from collections.abc import Callable, Sequence

from actuators.mechanics.continuum.filling import fill
from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.inflation import inflate
from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.ramp import apply_loads
from actuators.mechanics.continuum.system import ContinuumSystem
from actuators.mechanics.continuum.tracer import Path, Tracer
from actuators.mechanics.direct_solver import SymmetricSolver
from actuators.mechanics.response import Outcome

__all__ = ["Path", "PathFollower"]

Watch = Callable[[float, float], None]
"""Told the part of the way that is done, 0 to 1, and the pressure [Pa]."""
Seen = Callable[[Equilibrium], None]
"""Told every state found, in order, also those that are not reported."""


class PathFollower:
    """One mesh's path. ``stop`` may return a reason to stop (an outcome), else None; it is asked
    after every state that ``seen`` was told of."""

    def __init__(
        self,
        system: ContinuumSystem,
        solver: SymmetricSolver,
        *,
        tolerance: float = 1e-5,
        stop: Callable[[], Outcome | None] = lambda: None,
        watch: Watch = lambda share, pressure: None,
        seen: Seen = lambda found: None,
    ) -> None:
        self._tracer = Tracer(system, solver, tolerance, stop)
        self._watch, self._seen = watch, seen

    def follow(self, pressure_to: float, report: Sequence[float] | None) -> Path:
        """Path from zero to ``pressure_to`` [Pa]. ``report``: pressures to stop at in order, the
        last one ``pressure_to``; None keeps every step."""
        return self.reach(Goal.pressure(pressure_to, report))

    def reach(self, goal: Goal) -> Path:
        """Path from rest to a goal. One that ends under its loads has one point, that far."""
        start, path = apply_loads(self._tracer), self._tracer.path
        path.points = [start]
        if path.loads == 1.0:
            self._seen(start)
        if path.loads == 1.0 and not self._tracer.ends_at(start):
            path.points += self._continue([start], start, goal)
        return path

    def resume(
        self,
        history: Sequence[Equilibrium],
        first: Equilibrium,
        goal: Goal,
        *,
        limit: Equilibrium | None = None,
    ) -> Path:
        """The rest of a path that began with ``first``, whose last states are ``history``, and that
        has passed the pressure's first maximum ``limit`` if it has; only new points are
        returned."""
        self._tracer.path.limit = limit
        self._tracer.path.points = self._continue(list(history), first, goal)
        return self._tracer.path

    def _continue(
        self, history: list[Equilibrium], first: Equilibrium, goal: Goal
    ) -> list[Equilibrium]:
        last = history[-1]
        if goal.sign(first) * (goal.value - goal.measure(last)) <= 0.0:
            return []

        def told(found: Equilibrium) -> None:
            self._watch(goal.share(first, found), found.pressure)
            self._seen(found)

        self._tracer.told = told
        stops = goal.left(first, last)
        self._tracer.path.by_volume = goal.by_volume
        if goal.by_volume:
            return fill(self._tracer, history, first, goal.value, stops)
        return inflate(self._tracer, history, goal.value, stops)
