"""Newton's method, damped by the natural monotonicity test (Deuflhard).

A step with factor f < 1 is accepted if the simplified correction (new residual, old tangent) is
shorter than (1 - f/4) of the correction itself; a full step under a more lenient rule. Where the
simplified correction shrinks well it is added, and the old tangent is used again while that pays: a
residual costs a tenth of a factorisation.

Full steps that bring surfaces into contact, or apart, are taken although the correction grows: the
old tangent knew nothing of them, the next one does. That is an active-set method, and started from
a prediction that ran surfaces into each other it takes about five tangents; where the corrections
run away it is ended early, for two smaller steps cost less.

Either the cavity pressure is given, or it is one more unknown and something else is: the cavity's
volume, which passes a pressure's limit points, or a plane across the path, which passes those of
the volume too.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from actuators.mechanics.continuum.system import Balance, ContinuumSystem, State
from actuators.mechanics.direct_solver import FactorizationError, SymmetricSolver

SMALLEST_FACTOR = 1 / 32
TRUSTED_CONTRACTION = 0.3
"""Contraction below which the old tangent is used once more instead of a new one."""
LENIENCE = 20.0
"""Growth of the simplified correction that a full step may show: a slender body that turns
stretches on the way, and the next step takes that back. Held to monotony, it creeps."""
MONOTONE = 0.75
"""The natural monotonicity test for full steps too: from a coarser mesh's answer, where nothing
turns, it is the safer rule."""
TOUCHING = 1e-2
"""Share of the tolerance where surfaces touch: there a thousandth of the body's size is a pressure
of many shear moduli, and its resultant is part of the answer."""
NEGLIGIBLE = 1e-3
MOST_CONTACT_CHANGES = 12
"""Steps taken because contact changed; they do not count as iterations."""
DEEPEST = 60.0
"""Overlap, in distances at which contact sets in, to which a step is cut that runs surfaces into
each other: they must not pass through each other, and what touches first is in the next tangent."""
RUNAWAY = 4.0
"""Growth over the first correction (of :data:`NEAR` at least) at which a state with surfaces in
contact is given up."""
MOST_STALE, SHORTER = 6, 0.8
"""Tangents in contact whose corrections are none below this share of the shortest one before: the
state is given up, for it goes to and fro between sets of touching points."""
TOO_DEEP = "surfaces run too deep into each other"
NEAR = 1e-3
"""Correction [body sizes] before a tangent that takes contact pressures for those of the
equilibrium, however high they are."""


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A converged state. ``negative_eigenvalues`` of the last tangent: 0 where stable, None where
    the solver does not say. ``wrinkles``: whether there are fewer of them because embedded sheets,
    which bend freely here and would wrinkle as finely as the mesh allows, are taken to stay flat.
    """

    state: State
    pressure: float
    volume: float
    iterations: int
    negative_eigenvalues: int | None
    wrinkles: bool = False


@dataclass(frozen=True)
class Failure:
    """No equilibrium found, and why."""

    reason: str
    iterations: int


@dataclass(frozen=True, eq=False)
class Plane:
    """States whose unknowns x (n,) satisfy ``normal`` . (x - ``through``) = 0."""

    normal: np.ndarray
    through: np.ndarray


@dataclass(frozen=True, eq=False)
class Target:
    """What is prescribed: ``pressure`` [Pa]; or ``volume`` [m3] or ``plane``, with ``pressure`` as
    first guess. ``loads``: share of weight and outer loads."""

    pressure: float
    volume: float | None = None
    loads: float = 1.0
    plane: Plane | None = None


def solve_equilibrium(
    system: ContinuumSystem,
    solver: SymmetricSolver,
    start: State,
    target: Target,
    *,
    tolerance: float = 1e-6,
    most_iterations: int = 12,
    lenience: float = LENIENCE,
    cancelled: Callable[[], bool] | None = None,
) -> Equilibrium | Failure:
    """Equilibrium near ``start``. ``tolerance``: largest displacement correction over the body's
    size."""
    size = float(np.ptp(system.mesh.nodes, axis=0).max())
    state, pressure = start, target.pressure
    iterations = changes = 0
    length = longest = shortest = np.inf
    stale, met = 0, False
    while iterations < most_iterations + changes:
        if cancelled is not None and cancelled():
            return Failure("cancelled", iterations)
        near = length < NEAR * size
        balance = system.linearise(state, pressure, loads=target.loads, near=near)
        if not balance.admissible:
            blind = any(touch.blind for touch in balance.touches)
            return Failure(TOO_DEEP if blind else "an element is turned inside out", iterations)
        touches = balance.touches
        met = met or any(touch.points for touch in touches)
        iterations += 1
        try:
            system.factorize(solver)
        except FactorizationError as error:
            return Failure(str(error), iterations)
        border = _Border(system, solver, state, target)
        step, dp = border.correction(state, balance)
        length = _length(system, step)
        if not np.isfinite(length):
            return Failure("the tangent is singular", iterations)
        if iterations == 1:
            longest = RUNAWAY * max(length, NEAR * size)
        elif met and iterations > 2 and length > longest:
            return Failure("surfaces in contact: the correction grows", iterations)
        if met:
            stale = 0 if length < SHORTER * shortest else stale + 1
            shortest = min(shortest, length)
        if stale >= MOST_STALE:
            return Failure("surfaces in contact: the correction does not shrink", iterations)
        factor = first = _until_contact(system, state, step)
        while True:
            trial, trial_pressure = system.moved(state, factor, step), pressure + factor * dp
            balance = system.balance(trial, trial_pressure, loads=target.loads)
            if balance.admissible:
                again, dp_again = border.correction(trial, balance)
                rest = _length(system, again)
                changed = balance.touches != touches
                slack = (MONOTONE if changed else lenience) if factor == 1.0 else 1 - factor / 4
                if rest <= slack * length or rest <= NEGLIGIBLE * tolerance * size:
                    break
                if changed and factor == first and changes < MOST_CONTACT_CHANGES:
                    changes += 1
                    break
            factor /= 2
            if factor < SMALLEST_FACTOR:
                return Failure("the correction does not shrink", iterations)
        state, pressure = trial, trial_pressure
        negligible = NEGLIGIBLE * tolerance * size
        while factor == 1.0 and rest <= max(TRUSTED_CONTRACTION * length, negligible):
            state, pressure = system.moved(state, 1.0, again), pressure + dp_again
            pressed = any(touch.points for touch in balance.touches)
            if rest <= tolerance * size * (TOUCHING if pressed else 1.0):
                volume, _ = system.volume(state)
                below = solver.negative_eigenvalues
                found = Equilibrium(state, pressure, volume, iterations, below)
                return _judged(system, solver, found, target.loads)
            balance = system.balance(state, pressure, loads=target.loads)
            if not balance.admissible:
                state, pressure = trial, trial_pressure
                break
            length = rest
            again, dp_again = border.correction(state, balance)
            rest = _length(system, again)
    return Failure(f"not converged in {most_iterations} iterations", iterations)


def _judged(
    system: ContinuumSystem, solver: SymmetricSolver, found: Equilibrium, loads: float
) -> Equilibrium:
    """``found``, its stability judged with sheets held flat: without the stiffness against bending
    that a real layer has, compression wrinkles them in waves of an element's length."""
    below, sheet = found.negative_eigenvalues, found.state.sheet
    if not below or not (sheet < 0.0).any():
        return found
    system.linearise(found.state, found.pressure, loads=loads, sheets_flat=True)
    try:
        system.factorize(solver)
    except FactorizationError:
        return found
    flat = solver.negative_eigenvalues
    if flat is None or flat >= below:
        return found
    return replace(found, negative_eigenvalues=flat, wrinkles=True)


def _until_contact(system: ContinuumSystem, state: State, step: State) -> float:
    """Largest part of a step that runs surfaces no deeper into each other than :data:`DEEPEST`, or
    twice as deep as they are."""
    factor = 1.0
    if not system.interactions:
        return factor
    allowed = max(DEEPEST, 2 * system.overlap(state))
    while factor > 2 * SMALLEST_FACTOR:
        if system.overlap(system.moved(state, factor, step)) <= allowed:
            break
        factor /= 2
    return factor


class _Border:
    """Corrections with the tangent just factorised, for given pressure or one condition more."""

    def __init__(
        self, system: ContinuumSystem, solver: SymmetricSolver, state: State, target: Target
    ) -> None:
        self._system, self._solver, self._target = system, solver, target
        if target.volume is not None or target.plane is not None:
            _, gradient = system.volume(state)
            self._inflation = solver.solve(gradient)
            self._row = target.plane.normal if target.plane is not None else gradient

    def _lack(self, state: State) -> float | None:
        """How much the condition lacks at ``state``; None where the pressure is given."""
        plane, volume = self._target.plane, self._target.volume
        if plane is not None:
            return float(plane.normal @ (plane.through - self._system.unknowns_of(state)))
        return None if volume is None else volume - self._system.volume(state)[0]

    def correction(self, state: State, balance: Balance) -> tuple[State, float]:
        """Step of the state and of the pressure."""
        solution = self._solver.solve(-self._system.reduce(balance))
        change, lack = 0.0, self._lack(state)
        if lack is not None:
            change = float((lack - self._row @ solution) / (self._row @ self._inflation))
            solution = solution + change * self._inflation
        return self._system.expand(solution, balance), change


def _length(system: ContinuumSystem, step: State) -> float:
    """Largest displacement of a step [m]."""
    return float(np.abs(step.displacement).max())
