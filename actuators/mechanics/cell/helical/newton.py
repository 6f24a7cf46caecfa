"""Newton's method for one pitch.

An old tangent is used for as long as corrections shrink: a residual costs a fraction of a tangent.
Where walls touch it is an active-set method, started hard as in the 3D solver: full steps are taken
although points come into contact or leave it.
"""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.cell.helical.step import Step, step_of
from actuators.mechanics.cell.helical.system import CellState, CellSystem
from actuators.mechanics.cell.helical.tangent import Factor, Tangent, Target, factorised
from actuators.mechanics.continuum.system import Balance
from actuators.mechanics.direct_solver import FactorizationError

TOLERANCE = 1e-6
"""Largest displacement of the last correction, in body sizes."""
TRUSTED = 0.4
"""Contraction up to which the old tangent is used again."""
LENIENT = 4.0
"""Growth of the simplified correction that a full step with a new tangent may show."""
SMALLEST_FACTOR = 1 / 16
MOST_TANGENTS = 8
MOST_CHORDS = 12
MOST_CONTACT_CHANGES = 12
"""Steps that may change what touches without shrinking the correction."""
SHORTER, FUTILE = 0.8, 6
"""Correction over the shortest before that is progress; tangents without any that end a search: it
goes to and fro between sets of points that touch."""
DEEPEST = 30.0
"""Penetration, over the distance in which contact sets in, into which a step may run walls."""
NEAR = 1e-3
"""Correction [body sizes] below which contact pressures are to be believed."""
MEMORY = 4
"""Steps that :class:`_Mixing` remembers."""


@dataclass(frozen=True, eq=False)
class Found:
    """A converged state, and what it cost: ``tangents``. ``factor``: the last of them, made this
    far from the state: ``distance`` [body sizes]."""

    state: CellState
    pressure: float
    tangents: int
    factor: Factor
    distance: float


@dataclass(frozen=True)
class Missed:
    """No equilibrium found, and why."""

    reason: str


class Solver:
    """Equilibria of one cell; ``tangents`` counts factorisations."""

    def __init__(self, system: CellSystem) -> None:
        self.system = system
        self.numbering = system.numbering("even")
        self.tangents = 0

    def factor(
        self, state: CellState, pressure: float, *, near: bool = True, sheets_flat: bool = False
    ) -> Factor | None:
        """Tangent at ``state``; None where it is inadmissible or singular. ``near``: whether
        contact pressures are to be believed; ``sheets_flat``: whether sheets under compression are
        held flat."""
        self.tangents += 1
        balance = self.system.linearise(state, pressure, near=near, sheets_flat=sheets_flat)
        if not balance.admissible:
            return None
        try:
            return factorised(self.system, self.numbering, state, balance, pressure)
        except FactorizationError:
            return None

    def solve(self, start: CellState, target: Target) -> Found | Missed:
        """Equilibrium near ``start``."""
        try:
            return _Search(self, start, target).run()
        except np.linalg.LinAlgError:
            return Missed("a singular state")


class _Search:
    """One run of :meth:`Solver.solve`."""

    def __init__(self, solver: Solver, start: CellState, target: Target) -> None:
        self._solver, self._system, self._target = solver, solver.system, target
        self._reference = None
        if target.held:
            self._reference = self._system.held(start, solver.numbering)
        self._state, self._pressure = start, target.pressure
        self._tolerance = TOLERANCE * self._system.size
        self._length, self._changes = np.inf, 0

    def run(self) -> Found | Missed:
        made = 0
        shortest, futile = np.inf, 0
        while made < MOST_TANGENTS + min(self._changes, MOST_CONTACT_CHANGES):
            made += 1
            near = self._length <= NEAR * self._system.size
            factor = self._solver.factor(self._state, self._pressure, near=near)
            if factor is None:
                return Missed("an inadmissible or singular state")
            tangent = Tangent(factor, self._target, self._reference)
            done = self._along(tangent, factor.balance)
            if done is None:
                return Missed("the correction does not shrink")
            futile = 0 if self._length < SHORTER * shortest else futile + 1
            shortest = min(shortest, self._length)
            if futile == FUTILE:
                return Missed("what touches goes to and fro")
            if done:
                moved = np.abs(self._state.place - factor.state.place).max() / self._system.size
                return Found(self._state, self._pressure, made, factor, float(moved))
        return Missed("not converged")

    def _along(self, tangent: Tangent, balance: Balance) -> bool | None:
        """Corrections with one tangent: True when converged, False when a new one is needed, None
        where not even a short step helps."""
        correction = self._step(tangent, self._state, balance, self._pressure)
        mixing = _Mixing()
        factor = first = self._until_contact(correction)
        touches = balance.touches
        for _ in range(MOST_CHORDS):
            self._length = correction.length
            step = mixing.next(correction).times(factor)
            state = step.taken(self._system, self._state, 1.0)
            pressure = self._pressure + step.rise
            if correction.length <= self._tolerance:
                self._state, self._pressure = state, pressure
                return True
            after = self._system.balance(state, pressure)
            growth, again = np.inf, correction
            changed = after.touches != touches and factor == first
            if after.admissible:
                again = self._step(tangent, state, after, pressure)
                growth = again.length / correction.length
            shrinks = growth <= (LENIENT if factor == 1.0 else 1 - factor / 4)
            if shrinks or (changed and after.admissible and self._changes < MOST_CONTACT_CHANGES):
                self._state, self._pressure = state, pressure
                self._changes += changed
                if factor < 1.0 or growth > TRUSTED:
                    return False
                touches = after.touches
                mixing.went(step, correction)
                correction = again
                continue
            factor /= 2
            if factor < SMALLEST_FACTOR:
                return None
        return False

    def _until_contact(self, step: Step) -> float:
        """Largest part of a step that runs walls no deeper into each other than :data:`DEEPEST`,
        or twice as deep as they are."""
        walls, system, factor = self._system.walls, self._system, 1.0
        if walls is None:
            return factor
        allowed = max(DEEPEST, 2 * walls.overlap(system.wall_positions(self._state)))
        while factor > 2 * SMALLEST_FACTOR:
            ahead = step.taken(system, self._state, factor)
            if walls.overlap(system.wall_positions(ahead)) <= allowed:
                break
            factor /= 2
        return factor

    def _step(self, tangent: Tangent, state: CellState, balance: Balance, pressure: float) -> Step:
        solution, hold, rise = tangent.correction(state, balance, pressure)
        return step_of(self._system, state, solution, balance, hold, rise)


class _Mixing:
    """Anderson's mixing: from how corrections with one tangent changed over the last steps, the
    step after which the next correction should vanish."""

    def __init__(self) -> None:
        self._steps: list[Step] = []
        self._changes: list[Step] = []
        self._last: Step | None = None

    def went(self, step: Step, correction: Step) -> None:
        """``step`` was taken where ``correction`` was asked for."""
        self._steps = [*self._steps[-MEMORY + 1 :], step]
        self._last = correction

    def next(self, correction: Step) -> Step:
        """The step to take."""
        if self._last is None:
            return correction
        if len(self._changes) < len(self._steps) or len(self._steps) == MEMORY:
            change = correction.combined([-1.0], [self._last])
            self._changes = [*self._changes[-MEMORY + 1 :], change]
        columns = np.stack([c.place.ravel() for c in self._changes], axis=1)
        share = np.linalg.lstsq(columns, correction.place.ravel(), rcond=1e-10)[0]
        both = [*self._steps, *self._changes]
        return correction.combined([*-share, *-share], both)
