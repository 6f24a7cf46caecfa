"""Walking along a path with the pressure unknown: past limit points of pressure, then of volume.

The cavity's volume is prescribed in adaptive steps. Where that fails however small the step (one
chamber runs away while others shrink, and the volume itself turns back), the next state is sought
on a plane across the last secant instead (Riks' arc length): it passes limit points of both.
"""

from collections.abc import Callable, Sequence

import numpy as np

from actuators.mechanics.continuum.newton import Equilibrium, Failure, Plane, Target
from actuators.mechanics.continuum.prediction import (
    LARGEST_VOLUME_STEP,
    growth,
    predict_by_volume,
)
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.mechanics.continuum.trail import Trail

SMALLEST_VOLUME_STEP = 1 / 2000
"""Fraction of the cavity's volume below which arc length takes over."""
CAREFUL_STEP, EASY_ITERATIONS = 0.01, 4
"""A step that changes stability in more iterations, or ends farther aside than it was long, is
halved, down to this share of the volume."""
ASIDE, FAR_ASIDE = 1.0, 3.0
"""Distance of a state found from the one predicted, over the step predicted: from the first on a
laborious step is tried again with half its length, from the second on it is a leap."""
STRIDES = (0.015, 0.02, 0.03, 0.04, 0.05, 0.06, 0.08, 0.11)
"""Shares of the volume tried where smaller steps fail."""
CHORD = 0.002
"""Shortest change of volume [its share] that a stride is predicted from."""
CAREFUL_MOVE = 0.002
"""As :data:`CAREFUL_STEP`, of an arc step: largest displacement, as a fraction of the body's
size."""
LARGEST_MOVE = 0.1
"""Largest displacement of an arc step, as a fraction of the body's size."""
SMALLEST_MOVE = 1e-5
"""Below it, nothing continues the path."""
SURELY_ONWARD = 2
"""Arc steps in the walk's direction, after others against it, before volume is the control."""

Solve = Callable[[State, Target], Equilibrium | Failure]


class Walk:
    """States one after the other, beyond those of ``trail``. ``step``: first change of volume [m3],
    its sign the direction. ``leaping``: whether it may go over to another branch also where that
    has less pressure, or suction. ``by_arc``: whether arc length is the control instead of volume;
    ``arrived``: the last state is at the volume asked for; ``leapt``: it lies so far from where the
    path led that it belongs to another branch; ``reason`` says why :meth:`advance` came to
    nothing."""

    def __init__(
        self,
        system: ContinuumSystem,
        solve: Solve,
        trail: Sequence[Equilibrium],
        step: float,
        *,
        leaping: bool = False,
    ) -> None:
        self._system, self._solve = system, solve
        self.trail = Trail(system, trail)
        self._sign, self._leaping = float(np.copysign(1.0, step)), leaping
        self._size = float(np.ptp(system.mesh.nodes, axis=0).max())
        self._step, self._move = step, 0.0  # the next one by volume [m3] and by arc length [m]
        self.by_arc = self._ever_by_arc = False
        self._owed = 0  # steps onward before volume is the control again; 0: it has not turned back
        self._other_branch: Equilibrium | None = None
        self.arrived = self.leapt = False
        self.reason = ""

    @property
    def past_volume(self) -> bool:
        """Whether volume control failed somewhere on the way: states from there on may not be
        the only ones of their volume."""
        return self._ever_by_arc or self.by_arc

    def take_up_turned(self) -> None:
        """Go on by arc length from a trail on which the volume was turning back: by volume it
        would go back the way it came."""
        self.by_arc, self._owed = True, SURELY_ONWARD

    def advance(
        self, volume: float | None = None, *, given_up: Callable[[float], bool] = lambda step: False
    ) -> Equilibrium | None:
        """The next equilibrium, at ``volume`` exactly where a step comes to it; None where there is
        none to be found. ``given_up`` is asked after a failure with the next smaller step, as a
        fraction of the volume: whether to leave it at that."""
        self.arrived = self.leapt = False
        ahead = None if self.by_arc else self._advance_by_volume(volume, given_up)
        if ahead is None and self.by_arc:
            ahead = self._advance_by_arc(volume, given_up)
            if ahead is None and not given_up(0.0):
                ahead = self._stride(volume)
                ahead = ahead if ahead is not None else self._leap(volume)
        return ahead

    def _advance_by_volume(
        self, volume: float | None, given_up: Callable[[float], bool]
    ) -> Equilibrium | None:
        """The next state at a volume that is prescribed; without one, :attr:`by_arc` is set unless
        it is given up."""
        last = self.trail.last
        while not self.by_arc:
            step = self._sign * min(abs(self._step), self._widest(last))
            wanted = last.volume + step
            if volume is not None and (volume - wanted) * step < 0.2 * step * step:
                wanted = volume
            share = abs(wanted - last.volume) / last.volume
            guess = predict_by_volume(self._system, self.trail.nearest, wanted)
            found = self._solve(guess[0], Target(guess[1], volume=wanted))
            aside = self._doubtful(found, guess[0])
            doubtful = aside is not None and share > CAREFUL_STEP
            if isinstance(found, Equilibrium) and not doubtful:
                self._step = (wanted - last.volume) * growth(found.iterations)
                self.arrived = wanted == volume
                return self._taken(found, elsewhere=(aside or 0.0) > FAR_ASIDE)
            self._step = (wanted - last.volume) / 2
            if isinstance(found, Failure):
                self.reason = found.reason
                if given_up(share / 2):
                    return None
                self.by_arc = share / 2 < SMALLEST_VOLUME_STEP
        return None

    def _advance_by_arc(
        self, volume: float | None, given_up: Callable[[float], bool]
    ) -> Equilibrium | None:
        if len(self.trail.states) < 2:
            return None
        before, last = self.trail.states[-2:]
        x, x_before = (self._system.unknowns_of(e.state) for e in (last, before))
        secant = x - x_before
        length = float(np.abs(secant).max())
        if self._move == 0.0:
            self._move = length / 2
        while self._move > SMALLEST_MOVE * self._size:
            move = min(self._move, LARGEST_MOVE * self._size)
            ratio = min(
                move / length,
                self._widest(last) / max(abs(last.volume - before.volume), 1e-300),
            )
            plane = Plane(secant / length, x + ratio * secant)
            start = self._system.onward(before.state, last.state, ratio)
            guess = last.pressure + ratio * (last.pressure - before.pressure)
            found = self._solve(start, Target(guess, plane=plane))
            aside = self._doubtful(found, start)
            if aside is not None and ratio * length > CAREFUL_MOVE * self._size:
                self._move = ratio * length / 2
                continue
            if isinstance(found, Equilibrium) and not self.trail.retraces(found):
                self._move = ratio * length * growth(found.iterations)
                there = self._stopped_at(last, found, volume)
                taken = self._taken(there, elsewhere=(aside or 0.0) > FAR_ASIDE)
                if not self.leapt:
                    self._choose_control(taken.volume - last.volume)
                return taken
            turned_back = "the path turns back to states already found"
            self.reason = found.reason if isinstance(found, Failure) else turned_back
            self._move = ratio * length / 2
            if given_up(0.0):
                return None
        return None

    def _stride(self, volume: float | None) -> Equilibrium | None:
        """Where small steps fail, one over the place: contact between coarse faces jumps where a
        point goes over an edge, and a short stretch of the path has no equilibrium."""
        last, base = self.trail.last, self.trail.before_chord(CHORD)
        if base is None or self._owed or self._sign * (last.volume - base.volume) < 0:
            return None
        for share in STRIDES:
            wanted = last.volume * (1 + self._sign * share)
            if volume is not None and self._sign * (volume - wanted) < 0:
                wanted = volume
            guess = predict_by_volume(self._system, [base, last], wanted)
            found = self._solve(guess[0], Target(guess[1], volume=wanted))
            if (
                isinstance(found, Equilibrium)
                and found.negative_eigenvalues == last.negative_eigenvalues
                and self.trail.aside(found, guess[0]) < ASIDE
            ):
                self._control_volume(self._sign * CAREFUL_STEP * found.volume)
                self.arrived = wanted == volume
                return self._taken(found, elsewhere=False)
            if wanted == volume:
                break
        return None

    def _leap(self, volume: float | None) -> Equilibrium | None:
        """Where nothing continues the path: the stable state of another branch that was met on the
        last steps tried, if it lies ahead. An actuator snaps to it."""
        found, self._other_branch = self._other_branch, None
        last = self.trail.last
        if found is None or self._sign * (found.volume - last.volume) <= 0:
            return None
        if not self._leaping and self._sign * (found.pressure - last.pressure) <= 0:
            return None
        self.arrived = found.volume == volume
        return self._taken(found, elsewhere=True)

    def _widest(self, last: Equilibrium) -> float:
        return LARGEST_VOLUME_STEP * last.volume

    def _doubtful(self, found: Equilibrium | Failure, guess: State) -> float | None:
        """How far ``found`` lies aside, in predicted steps, where it cost so much, and is so
        differently stable or lies so far from its prediction, that it may lie on another branch:
        smaller steps will tell. The nearest such state is remembered. None where there is no
        doubt."""
        if isinstance(found, Failure) or found.iterations <= EASY_ITERATIONS:
            return None
        aside = self.trail.aside(found, guess)
        if found.negative_eigenvalues == self.trail.last.negative_eigenvalues and aside <= ASIDE:
            return None
        if not found.negative_eigenvalues:
            self._other_branch = found
        return aside

    def _taken(self, found: Equilibrium, *, elsewhere: bool) -> Equilibrium:
        self.leapt = elsewhere
        if elsewhere:  # the branch left tells nothing of how this one goes on
            self._ever_by_arc = self.past_volume
            self._control_volume(self._sign * CAREFUL_STEP * found.volume)
        self.trail.add(found, elsewhere=elsewhere)
        return found

    def _control_volume(self, step: float) -> None:
        """Prescribe volumes from here on; an arc has no secant then."""
        self.by_arc, self._owed = False, 0
        self._step, self._move = step, 0.0

    def _choose_control(self, change: float) -> None:
        """Back to volume control once the volume, having turned back, goes on again with states
        that are stable: a syringe's way."""
        self._ever_by_arc = True
        if change * self._sign < 0:
            self._owed = SURELY_ONWARD
        elif self._owed > 1:
            self._owed -= 1
        elif self._owed == 1 and not self.trail.last.negative_eigenvalues:
            self._control_volume(change)

    def _stopped_at(
        self, last: Equilibrium, found: Equilibrium, volume: float | None
    ) -> Equilibrium:
        """``found``, or the state at ``volume`` where that lies between it and ``last``."""
        if volume is None or (found.volume - volume) * (last.volume - volume) > 0:
            return found
        share = (volume - last.volume) / (found.volume - last.volume)
        start = self._system.onward(last.state, found.state, share - 1)
        guess = last.pressure + share * (found.pressure - last.pressure)
        there = self._solve(start, Target(guess, volume=volume))
        self.arrived = isinstance(there, Equilibrium)
        return there if isinstance(there, Equilibrium) else found
