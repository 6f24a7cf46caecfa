"""The body against itself: neighbouring chamber walls, folds of a bellows, the curled-up end.

Both surfaces of a pair are integrated over, each with half the weight: neither is the master.
"""

import numpy as np

from actuators.mechanics.continuum.contact.interaction import Tangent, Touch
from actuators.mechanics.continuum.contact.search import PairSearch
from actuators.mechanics.continuum.contact.surface import (
    ContactLaw,
    ContactSurface,
    law_pressure,
)
from actuators.mechanics.continuum.kernel.facing import add_facing, find_opposite

REACH = 3e-3
"""Distance [body sizes] at which opposite faces get their place in the matrix."""
SKIN = 1e-2
"""Motion [body sizes] after which faces are searched anew."""
DEPTH = 0.25
"""Penetration [body heights] up to which faces see each other."""

MOST_TURNING = 2.0
"""Contact pressure, over that at a penetration of ``onset``, up to which the tangent knows that
pressed surfaces turn while the state is far from equilibrium. Pressures there are far too high as a
rule and would make it indefinite; near equilibrium they are the true ones and count in full."""

_NO_DOF = np.empty((0, 3), dtype=np.int32)
_NO_INDEX = np.empty(0, dtype=np.int32)
_NO_VALUES = np.empty(0)


class SelfContact:
    """Contact of ``surface`` with itself. ``height`` of the undeformed body [m]; ``within``: the
    surface is the cavity's."""

    def __init__(
        self, surface: ContactSurface, law: ContactLaw, height: float, *, within: bool = False
    ) -> None:
        self.within = within
        self._surface, self._law = surface, law
        size = float(np.ptp(surface.nodes, axis=0).max())
        self._reach, self._skin, self._depth = REACH * size, SKIN * size, DEPTH * height
        self._search = PairSearch(surface.nodes, surface.faces, height)
        self._half_areas = 0.5 * surface.areas
        self._searched_at: np.ndarray | None = None
        self._start = np.zeros(len(surface.faces) + 1, dtype=np.int64)
        self._candidates = np.empty(0, dtype=np.int64)
        self._looked_at: np.ndarray | None = None
        self._partner = np.full(self._half_areas.shape, -1, dtype=np.int64)
        self._gaps = np.full(self._half_areas.shape, self._reach)

    def couples(self, positions: np.ndarray) -> np.ndarray:
        """(k, 18) nodes of faces that are within reach of each other."""
        self._look(positions)
        face, point = np.nonzero(self._partner >= 0)
        other = self._candidates[self._partner[face, point]]
        pairs = np.unique(np.sort(np.stack([face, other], axis=1), axis=1), axis=0)
        return self._surface.faces[pairs].reshape(-1, 18)

    def add(self, positions: np.ndarray, residual: np.ndarray, tangent: Tangent | None) -> Touch:
        """See :class:`Interaction`."""
        self._look(positions)
        law, into = self._law, tangent or Tangent(_NO_DOF, _NO_INDEX, _NO_INDEX, _NO_VALUES)
        pressed = self._gaps < law.onset
        if not pressed.any():
            return Touch()
        believed = np.inf if into.near else MOST_TURNING * law.stiffness * law.onset
        complete = add_facing(
            positions, self._surface.faces, self._surface.points.values, self._half_areas,
            self._start, self._candidates, self._partner, law.stiffness, law.onset, believed,
            residual, tangent is not None, into.dof, into.indptr, into.indices, into.values,
        )  # fmt: skip
        if not complete:
            raise RuntimeError("faces touch that have no place in the matrix")
        return Touch(pressed.tobytes(), bool(self._gaps.min() < -0.5 * self._depth))

    def gaps(self, positions: np.ndarray) -> np.ndarray:
        """(f, q) distance [m] of each point to the face opposite, negative inside; no more
        than the reach is seen."""
        self._look(positions)
        return self._gaps.copy()

    def depth(self, positions: np.ndarray) -> float:
        """Deepest penetration of a point [m], negative where there is none."""
        return -float(self.gaps(positions).min())

    def largest_pressure(self, positions: np.ndarray) -> float:
        """Largest contact pressure at a point [Pa], per undeformed area."""
        return float(law_pressure(self.gaps(positions), self._law).max())

    def overlap(self, positions: np.ndarray) -> float:
        """See :class:`Interaction`."""
        return max(0.0, -float(self.gaps(positions).min()) / self._law.onset)

    def contact_pressure(self, positions: np.ndarray) -> np.ndarray:
        """See :class:`Interaction`."""
        return self._surface.nodal(positions, self.gaps(positions), self._law)

    def _look(self, positions: np.ndarray) -> None:
        """Find the face opposite to each point; once per positions."""
        if self._looked_at is not None and np.array_equal(self._looked_at, positions):
            return
        self._find_candidates(positions)
        if len(self._candidates):
            find_opposite(
                positions, self._surface.faces, self._surface.points.values, self._start,
                self._candidates, self._reach, self._depth, self._partner, self._gaps,
            )  # fmt: skip
        else:
            self._partner[:], self._gaps[:] = -1, self._reach
        self._looked_at = positions.copy()

    def _find_candidates(self, positions: np.ndarray) -> None:
        """Refresh the list of pairs that can come within reach before the next refreshment."""
        if self._searched_at is not None:
            moved = np.linalg.norm(positions - self._searched_at, axis=1).max()
            if moved < 0.5 * self._skin:
                return
        pairs = self._search.near(positions, self._reach + self._skin)
        both = np.concatenate([pairs, pairs[:, ::-1]])
        both = both[np.lexsort((both[:, 1], both[:, 0]))].astype(np.int64)
        per_face = np.bincount(both[:, 0], minlength=len(self._surface.faces))
        self._start = np.concatenate([[0], np.cumsum(per_face)]).astype(np.int64)
        self._candidates = np.ascontiguousarray(both[:, 1])
        self._searched_at = positions
