"""Following equilibrium from rest through its loads and inflation, up to a limit point if any.

Pressure is raised with adaptive steps from a linear prediction. Where a pressure step fails or
lands on an unstable state, the cavity volume takes over as control: it passes the pressure's
maximum, which is then the answer, located by a parabola through the three states around it.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from actuators.mechanics.continuum.newton import (
    Equilibrium,
    Failure,
    Target,
    solve_equilibrium,
)
from actuators.mechanics.continuum.prediction import (
    LARGEST_VOLUME_STEP,
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
from actuators.mechanics.direct_solver import SymmetricSolver
from actuators.mechanics.response import Outcome

FIRST_STEP, LARGEST_STEP = 0.05, 0.1
"""Fractions of the pressure range."""
LARGEST_FIRST_MOVE = 0.1
SMALLEST_SHARE_OF_LOADS = 1 / 256
SMALLEST_FIRST_STEP = 1 / 500
"""Fraction of the range below which volume takes over."""
SMALLEST_VOLUME_STEP = 1 / 2000
"""Fraction of the cavity's volume below which the path has stalled."""
MOST_VOLUME_STEPS = 200
SMALL_VOLUME_STEP = 0.02
"""Failing below this, with the pressure's maximum in sight, ends the path there."""

Watch = Callable[[float], None]


@dataclass(eq=False)
class Path:
    """Equilibria found, in order; ``beyond`` is a state past the limit point, where one was solved:
    the proof that the pressure falls there."""

    points: list[Equilibrium] = field(default_factory=list)
    outcome: Outcome = Outcome.CONVERGED
    reason: str = ""
    beyond: Equilibrium | None = None
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
        watch: Watch = lambda pressure: None,
    ) -> None:
        self._system, self._solver, self._tolerance = system, solver, tolerance
        self._stop, self._watch = stop, watch
        self._path = Path()

    def follow(self, pressure_to: float, report: Sequence[float] | None) -> Path:
        """Path from zero to ``pressure_to`` [Pa]. ``report``: increasing pressures to stop at, the
        last one ``pressure_to``; None keeps every step."""
        path = self._path
        start = self._apply_loads()
        if start is None:
            return path
        path.points.append(start)
        if pressure_to > 0.0:
            visited = self._inflate([start], pressure_to, report)
            path.points = [start, *visited]
        return path

    def resume(
        self, history: Sequence[Equilibrium], pressure_to: float, report: Sequence[float] | None
    ) -> Path:
        """The rest of a path whose last states are ``history``; only new points are returned."""
        self._path.points = self._inflate(list(history), pressure_to, report)
        return self._path

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
        self, history: list[Equilibrium], pressure_to: float, report: Sequence[float] | None
    ) -> list[Equilibrium]:
        targets = list(report) if report is not None else None
        visited: list[Equilibrium] = []
        step = FIRST_STEP * pressure_to
        if len(history) > 1:
            step = history[-1].pressure - history[-2].pressure
        else:
            step = min(step, self._first_pressure(history[0]))
        while True:
            last = history[-1]
            goal = targets[0] if targets else pressure_to
            step = min(step, LARGEST_STEP * pressure_to, pressure_step(history))
            wanted = last.pressure + step
            if wanted > goal - 0.2 * step:
                wanted = goal
            result = self._solve(predict(history, wanted), Target(wanted))
            if isinstance(result, Equilibrium) and not result.negative_eigenvalues:
                history = [*history[-2:], result]
                step = (wanted - last.pressure) * growth(result.iterations)
                self._watch(wanted)
            elif self._stopped():
                return visited
            else:
                step = (wanted - last.pressure) / 2
                if len(history) == 1 and step >= SMALLEST_FIRST_STEP * pressure_to:
                    continue
                found = self._inflate_by_volume(history, goal, visited, targets is None)
                if found is None:
                    return visited
                history = found
            if targets is None or history[-1].pressure >= goal:
                visited.append(history[-1])
                if targets:
                    targets.pop(0)
            if history[-1].pressure >= pressure_to:
                return visited

    def _inflate_by_volume(
        self, history: list[Equilibrium], goal: float, visited: list[Equilibrium], keep: bool
    ) -> list[Equilibrium] | None:
        """Raise the volume until the pressure passes ``goal`` (then the two last states, the last
        one at ``goal``) or a maximum (then None, with the limit state as last visited)."""
        path = self._path
        trail = history[-3:]
        step = 0.5 * (trail[-1].volume - trail[-2].volume) if len(trail) > 1 else 0.0
        step = max(step, 0.02 * trail[-1].volume)
        for _ in range(MOST_VOLUME_STEPS):
            last = trail[-1]
            step = min(step, LARGEST_VOLUME_STEP * last.volume)
            volume = last.volume + step
            guess = predict_by_volume(trail, volume)
            result = self._solve(guess[0], Target(guess[1], volume=volume))
            if isinstance(result, Failure):
                if self._stopped():
                    return None
                step /= 2
                if step < SMALL_VOLUME_STEP * last.volume and is_near_summit(trail):
                    path.outcome = Outcome.LIMIT_POINT
                    return None
                if step < SMALLEST_VOLUME_STEP * last.volume:
                    path.outcome, path.reason = Outcome.STALLED, result.reason
                    return None
                continue
            if result.pressure <= last.pressure:
                self._locate_limit([*trail, result], visited)
                return None
            if result.pressure >= goal:
                share = (goal - last.pressure) / (result.pressure - last.pressure)
                start = last.state.moved(share, difference(result.state, last.state))
                there = self._solve(start, Target(goal))
                if isinstance(there, Equilibrium) and not there.negative_eigenvalues:
                    return [last, there]
                goal = np.inf  # an unstable stretch: leave it to the volume
            self._watch(result.pressure)
            if keep:
                visited.append(result)
            trail = [*trail[-2:], result]
            step *= growth(result.iterations)
        path.outcome = Outcome.STALLED
        path.reason = "the volume grows without the pressure coming to a maximum"
        return None

    def _locate_limit(self, around: list[Equilibrium], visited: list[Equilibrium]) -> None:
        """Solve at the volume where a parabola through the last three states has its maximum."""
        path = self._path
        path.outcome = Outcome.LIMIT_POINT
        path.beyond = around[-1]
        top = around[-2]
        if len(around) >= 3:
            volume = summit_volume(around[-3:])
            guess = predict_by_volume(around[-2:], volume)
            result = self._solve(guess[0], Target(guess[1], volume=volume))
            if isinstance(result, Equilibrium) and result.pressure > top.pressure:
                top = result
        while visited and visited[-1].volume > top.volume:
            visited.pop()
        if not visited or top is not visited[-1]:
            visited.append(top)
