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
CHORD, MOST_RECENT = 0.002, 40
"""Shortest change of volume [its share] that a stride is predicted from, and how many states back
it is looked for."""
CAREFUL_MOVE = 0.002
"""As :data:`CAREFUL_STEP`, of an arc step: largest displacement, as a fraction of the body's
size."""
LARGEST_MOVE = 0.1
"""Largest displacement of an arc step, as a fraction of the body's size."""
SMALLEST_MOVE = 1e-5
"""Below it, nothing continues the path."""
RETRACED = 0.04
"""A state nearer to the chord between two known ones than this share of it is no new one."""
SURELY_ONWARD = 2
"""Arc steps in the walk's direction, after others against it, before volume is the control."""
FOOTPRINT = 2000
"""Unknowns by which states are told apart."""

Solve = Callable[[State, Target], Equilibrium | Failure]


class Walk:
    """States one after the other, from ``trail`` on. ``step``: first change of volume [m3], its
    sign the direction. ``leaping``: whether it may go over to another branch also where that has
    less pressure, or suction. ``arrived``: the last state is at the volume asked for; ``leapt``:
    it lies so far from where the path led that it belongs to another branch; ``reason`` says why
    :meth:`advance` came to nothing."""

    def __init__(
        self,
        system: ContinuumSystem,
        solve: Solve,
        trail: Sequence[Equilibrium],
        step: float,
        *,
        leaping: bool = False,
    ) -> None:
        self._system, self._solve, self._step = system, solve, step
        self._leaping, self._beyond = leaping, None
        self._size = float(np.ptp(system.mesh.nodes, axis=0).max())
        self._move, self._onward = 0.0, 0
        self._turned = self._ever_by_arc = False
        self._sign = np.copysign(1.0, step)
        self.trail = list(trail[-3:])
        self._recent = list(trail)
        self._known = [self._footprint(state) for state in self.trail]
        self.by_arc = False
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
        self.by_arc = self._turned = True

    def advance(
        self, volume: float | None = None, *, given_up: Callable[[float], bool] = lambda step: False
    ) -> Equilibrium | None:
        """The next equilibrium, at ``volume`` exactly where a step comes to it; None where there is
        none to be found. ``given_up`` is asked after a failure with the next smaller step, as a
        fraction of the volume: whether to leave it at that."""
        self.arrived = self.leapt = False
        while not self.by_arc:
            last = self.trail[-1]
            step = float(np.copysign(min(abs(self._step), self._widest(last)), self._step))
            wanted = last.volume + step
            if volume is not None and (volume - wanted) * step < 0.2 * step * step:
                wanted = volume
            share = abs(wanted - last.volume) / last.volume
            guess = predict_by_volume(self._system, self.trail, wanted)
            found = self._solve(guess[0], Target(guess[1], volume=wanted))
            aside = self._aside(found, guess[0])
            doubtful = self._doubt(last, found, aside)
            if isinstance(found, Equilibrium) and not (doubtful and share > CAREFUL_STEP):
                self.leapt = doubtful and aside > FAR_ASIDE
                self._step = (wanted - last.volume) * growth(found.iterations)
                self.arrived = wanted == volume
                return self._taken(found)
            self._step = (wanted - last.volume) / 2
            if isinstance(found, Failure):
                self.reason = found.reason
                if given_up(share / 2):
                    return None
                self.by_arc = share / 2 < SMALLEST_VOLUME_STEP
        ahead = self._advance_by_arc(volume, given_up)
        if ahead is not None or given_up(0.0):
            return ahead
        ahead = self._stride(volume)
        return ahead if ahead is not None else self._leap(volume)

    def _widest(self, last: Equilibrium) -> float:
        return LARGEST_VOLUME_STEP * last.volume

    def _aside(self, found: Equilibrium | Failure, guess: State) -> float:
        """Distance of ``found`` from its prediction, over that of the prediction from the last
        state; 0 where there was nothing to predict from."""
        if isinstance(found, Failure) or len(self.trail) < 2:
            return 0.0
        ahead = guess.displacement - self.trail[-1].state.displacement
        aside = found.state.displacement - guess.displacement
        return float(np.abs(aside).max() / max(np.abs(ahead).max(), 1e-300))

    def _doubt(self, last: Equilibrium, found: Equilibrium | Failure, aside: float) -> bool:
        """Whether ``found`` may lie on another branch; the nearest such state is remembered."""
        if isinstance(found, Failure) or not _is_laborious(last, found, aside):
            return False
        if not found.negative_eigenvalues:
            self._beyond = found
        return True

    def _stride(self, volume: float | None) -> Equilibrium | None:
        """Where small steps fail, one over the place: contact between coarse faces jumps where a
        point goes over an edge, and a short stretch of the path has no equilibrium."""
        last = self.trail[-1]
        base = next(
            (e for e in reversed(self._recent)
             if abs(e.volume - last.volume) > CHORD * last.volume), None,
        )  # fmt: skip
        if base is None or self._turned or self._sign * (last.volume - base.volume) < 0:
            return None
        for share in STRIDES:
            wanted = last.volume * (1 + self._sign * share)
            if volume is not None and self._sign * (volume - wanted) < 0:
                wanted = volume
            guess = predict_by_volume(self._system, [base, last], wanted)
            found = self._solve(guess[0], Target(guess[1], volume=wanted))
            alike = isinstance(found, Equilibrium) and (
                found.negative_eigenvalues == last.negative_eigenvalues
            )
            if isinstance(found, Equilibrium) and alike and self._aside(found, guess[0]) < ASIDE:
                self.by_arc, self._move = False, 0.0
                self._step = float(np.copysign(CAREFUL_STEP * found.volume, self._sign))
                self.arrived = wanted == volume
                return self._taken(found)
            if wanted == volume:
                break
        return None

    def _leap(self, volume: float | None) -> Equilibrium | None:
        """Where nothing continues the path: the stable state of another branch that was met on the
        last steps tried, if it lies ahead. An actuator snaps to it."""
        found, self._beyond = self._beyond, None
        last = self.trail[-1]
        if found is None or self._sign * (found.volume - last.volume) <= 0:
            return None
        if not self._leaping and self._sign * (found.pressure - last.pressure) <= 0:
            return None
        self.leapt, self.arrived = True, found.volume == volume
        return self._taken(found)

    def _taken(self, found: Equilibrium) -> Equilibrium:
        # what lies on another branch tells nothing of how this one goes on, nor has an arc a secant
        if self.leapt:
            self._ever_by_arc = self.past_volume
            self.by_arc, self._turned, self._move = False, False, 0.0
            self._step = float(np.copysign(CAREFUL_STEP * found.volume, self._sign))
        self.trail = [found] if self.leapt else [*self.trail[-2:], found]
        self._recent = [found] if self.leapt else [*self._recent[-MOST_RECENT:], found]
        self._known.append(self._footprint(found))
        return found

    def _footprint(self, found: Equilibrium) -> np.ndarray:
        values = self._system.unknowns_of(found.state)
        return values[:: max(1, len(values) // FOOTPRINT)]

    def _retraces(self, found: Equilibrium) -> bool:
        """Whether ``found`` lies on the part of the path that is known, its last step aside."""
        known = np.array(self._known[:-1])
        if len(known) < 2:
            return False
        chords = np.diff(known, axis=0)
        there = self._footprint(found) - known[:-1]
        length = np.einsum("ij,ij->i", chords, chords)
        share = np.clip(np.einsum("ij,ij->i", there, chords) / np.maximum(length, 1e-300), 0, 1)
        aside = there - share[:, None] * chords
        return bool((np.einsum("ij,ij->i", aside, aside) < RETRACED**2 * length).any())

    def _advance_by_arc(
        self, volume: float | None, given_up: Callable[[float], bool]
    ) -> Equilibrium | None:
        if len(self.trail) < 2:
            return None
        before, last = self.trail[-2:]
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
            aside = self._aside(found, start)
            doubtful = self._doubt(last, found, aside)
            if doubtful and ratio * length > CAREFUL_MOVE * self._size:
                self._move = ratio * length / 2
                continue
            if isinstance(found, Equilibrium) and not self._retraces(found):
                self.leapt = doubtful and aside > FAR_ASIDE
                self._move = ratio * length * growth(found.iterations)
                found = self._taken(self._stopped_at(last, found, volume))
                if not self.leapt:
                    self._choose_control(found.volume - last.volume)
                return found
            turned_back = "the path turns back to states already found"
            self.reason = found.reason if isinstance(found, Failure) else turned_back
            self._move = ratio * length / 2
            if given_up(0.0):
                return None
        return None

    def _choose_control(self, change: float) -> None:
        """Back to volume control once the volume, having turned back, goes on again with states
        that are stable: a syringe's way."""
        self._ever_by_arc = True
        if change * self._sign < 0:
            self._turned, self._onward = True, 0
            return
        self._onward += 1
        stable = not self.trail[-1].negative_eigenvalues
        if self._turned and self._onward >= SURELY_ONWARD and stable:
            self.by_arc = self._turned = False
            self._step, self._move = change, 0.0

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


def _is_laborious(last: Equilibrium, found: Equilibrium, aside: float) -> bool:
    """Whether ``found`` cost so much, and is so differently stable or lies so far ``aside``, that
    it may lie on another branch of the path: smaller steps will tell."""
    one, other = last.negative_eigenvalues, found.negative_eigenvalues
    return found.iterations > EASY_ITERATIONS and (one != other or aside > ASIDE)
