"""What every stretch of a path needs: one mesh's equations and solver, the path found so far."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from actuators.mechanics.continuum.contact.build import holds_cavity
from actuators.mechanics.continuum.newton import (
    Equilibrium,
    Failure,
    Target,
    solve_equilibrium,
)
from actuators.mechanics.continuum.prediction import predict_by_volume, summit_volume
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.mechanics.continuum.unmodelled import Unmodelled
from actuators.mechanics.direct_solver import SymmetricSolver
from actuators.mechanics.response import Outcome

LARGEST_FIRST_MOVE = 0.1
"""Of the body's size, by a linear answer."""
MOST_BARRED = 4
"""States with something in their way that are refused, each after half the step before it."""
MOST_SUMMIT_STEPS, SHARP_SUMMIT = 8, 1e-4
"""Until the pressure's maximum changes by less than this fraction."""


@dataclass(eq=False)
class Path:
    """Equilibria found, in order. ``beyond``: a state past the limit point, where one was solved:
    the proof that the pressure falls there. ``limit``: the first maximum of the pressure (of
    suction, a minimum) met on the way. ``by_volume``: whether a volume was the goal. ``by_arc``:
    how many of the last points need arc length, where volume control no longer leads on.
    ``leaps``: states between which the path goes over to another branch, each before and after.
    ``loads``: share of weight and outer loads that could be put on; below 1 the path ends there,
    in its only point."""

    points: list[Equilibrium] = field(default_factory=list)
    outcome: Outcome = Outcome.CONVERGED
    reason: str = ""
    beyond: Equilibrium | None = None
    limit: Equilibrium | None = None
    by_volume: bool = False
    by_arc: int = 0
    leaps: list[tuple[Equilibrium, Equilibrium]] = field(default_factory=list)
    loads: float = 1.0
    iterations: int = 0


class Tracer:
    """One mesh, and the :class:`Path` that grows on it. ``stop`` may return a reason to stop (an
    outcome), else None; ``told`` hears of every state found."""

    def __init__(
        self,
        system: ContinuumSystem,
        solver: SymmetricSolver,
        tolerance: float,
        stop: Callable[[], Outcome | None],
    ) -> None:
        self.system, self.solver = system, solver
        self._tolerance, self._stop = tolerance, stop
        self.path = Path()
        self.told: Callable[[Equilibrium], None] = lambda found: None
        held = holds_cavity(system.interactions)
        self._unmodelled = Unmodelled(system.mesh, cavity_held=held)
        self._barred: str | None = None
        self._times_barred = 0

    def solve(
        self, start: State, target: Target, *, passable: bool = False
    ) -> Equilibrium | Failure:
        """Equilibrium near ``start``; its iterations are counted. One that something not modelled
        is in the way of counts as none, unless everything is ``passable``; the path ends before it,
        after some smaller steps."""
        result = solve_equilibrium(
            self.system, self.solver, start, target, tolerance=self._tolerance,
            cancelled=lambda: self._stop() is not None,
        )  # fmt: skip
        self.path.iterations += result.iterations
        if isinstance(result, Equilibrium) and not passable:
            why = self._unmodelled.why(result.state)
            if why is not None:
                self._barred = why
                self._times_barred += 1
                return Failure(why, result.iterations)
        return result

    def ends_at(self, found: Equilibrium) -> bool:
        """Whether something not modelled is in the way of ``found`` already, the path's first."""
        self._barred = self._unmodelled.why(found.state)
        self._times_barred = MOST_BARRED if self._barred is not None else 0
        return self.barred and self.stopped()

    @property
    def barred(self) -> bool:
        """Whether the path ends because something that is not modelled is in its way."""
        return self._times_barred >= MOST_BARRED

    def stopped(self) -> bool:
        """Whether to stop; the reason becomes the path's outcome."""
        why = self._stop()
        if why is None and self.barred:
            why, self.path.reason = Outcome.STALLED, self._barred or ""
        if why is not None:
            self.path.outcome = why
        return why is not None

    def first_pressure(self, start: Equilibrium) -> float:
        """Pressure [Pa] whose linear answer, by the tangent last factorised, moves the body by
        :data:`LARGEST_FIRST_MOVE` of its size."""
        return self.share_of_first_move(self._inflation(start)[0])

    def first_volume(self, start: Equilibrium) -> float:
        """Change of volume [m3] that goes with :meth:`first_pressure`."""
        solution, gradient = self._inflation(start)
        return abs(float(gradient @ solution)) * self.share_of_first_move(solution)

    def _inflation(self, start: Equilibrium) -> tuple[np.ndarray, np.ndarray]:
        """Displacements per pressure at ``start``, and the volume's derivative. A path that is
        resumed, with contact switched on, brings its first state but no tangent."""
        if not self.solver.factorised:
            self.system.linearise(start.state, start.pressure)
            self.system.factorize(self.solver)
        _, gradient = self.system.volume(start.state)
        return self.solver.solve(gradient), gradient

    def share_of_first_move(self, solution: np.ndarray) -> float:
        """How much of this linear answer moves the body by :data:`LARGEST_FIRST_MOVE` of its
        size."""
        largest = float(np.abs(solution).max())
        size = float(np.ptp(self.system.mesh.nodes, axis=0).max())
        return LARGEST_FIRST_MOVE * size / largest if largest > 0 else math.inf

    def summit(self, around: list[Equilibrium], sign: float) -> Equilibrium:
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
            guess = predict_by_volume(self.system, [near, top], volume)
            found = self.solve(guess[0], Target(guess[1], volume=volume))
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
