"""The states that a walk along a path has come by."""

from collections.abc import Sequence

import numpy as np

from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.system import ContinuumSystem, State

MOST_STATES = 40
"""How many are kept whole."""
RETRACED = 0.04
"""A state nearer to the chord between two known ones than this share of it is no new one."""
FOOTPRINT = 2000
"""Unknowns by which states are told apart."""


class Trail:
    """``states``: the last ones of the branch that the path is on, oldest first; of all before, a
    sample of unknowns is kept, by which they are known again."""

    def __init__(self, system: ContinuumSystem, states: Sequence[Equilibrium]) -> None:
        self._system = system
        self.states = list(states)
        self._known = [self._footprint(state) for state in states[-3:]]

    @property
    def last(self) -> Equilibrium:
        """Where the path has come to."""
        return self.states[-1]

    @property
    def nearest(self) -> list[Equilibrium]:
        """The last three states at most, oldest first."""
        return self.states[-3:]

    def add(self, found: Equilibrium, *, elsewhere: bool) -> None:
        """Go on to ``found``. What lies ``elsewhere``, on another branch, is told nothing by the
        states before it."""
        self.states = [found] if elsewhere else [*self.states[-MOST_STATES:], found]
        self._known.append(self._footprint(found))

    def before_chord(self, share: float) -> Equilibrium | None:
        """The newest state whose volume differs from the last one's by more than this share."""
        last = self.last
        return next(
            (e for e in reversed(self.states) if abs(e.volume - last.volume) > share * last.volume),
            None,
        )

    def aside(self, found: Equilibrium, guess: State) -> float:
        """Distance of ``found`` from its prediction, over that of the prediction from the last
        state; 0 where there was nothing to predict from."""
        if len(self.states) < 2:
            return 0.0
        ahead = guess.displacement - self.last.state.displacement
        aside = found.state.displacement - guess.displacement
        return float(np.abs(aside).max() / max(np.abs(ahead).max(), 1e-300))

    def retraces(self, found: Equilibrium) -> bool:
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

    def _footprint(self, found: Equilibrium) -> np.ndarray:
        values = self._system.unknowns_of(found.state)
        return values[:: max(1, len(values) // FOOTPRINT)]
