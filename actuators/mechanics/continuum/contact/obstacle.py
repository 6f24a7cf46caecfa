"""A rigid, frictionless obstacle that the outside of the body presses against."""

import numpy as np

from actuators.mechanics.continuum.contact.interaction import Tangent, Touch
from actuators.mechanics.continuum.contact.points import GRID_VALUES
from actuators.mechanics.continuum.contact.surface import (
    ContactLaw,
    ContactSurface,
    law_pressure,
)
from actuators.mechanics.continuum.kernel.contact import (
    CYLINDER,
    PLANE,
    add_rigid,
)
from actuators.mechanics.obstacles import Cylinder, Plate

_NO_DOF = np.empty((0, 3), dtype=np.int32)
_NO_INDEX = np.empty(0, dtype=np.int32)
_NO_VALUES = np.empty(0)
_NO_COUPLES = np.empty((0, 9), dtype=np.int32)


class Obstacle:
    """Contact of ``surface`` with a plate or a cylinder. The force acts on it along the obstacle's
    normal."""

    def __init__(
        self, surface: ContactSurface, law: ContactLaw, obstacle: Plate | Cylinder
    ) -> None:
        self.obstacle = obstacle
        self._surface, self._law = surface, law
        self._deepest = np.inf
        if isinstance(obstacle, Plate):
            normal = np.array(obstacle.normal)
            # contact begins at its onset: what touches at rest must not be pressed by that
            gap = max(obstacle.gap, law.onset)
            offset = float((surface.nodes @ normal).min()) - gap
            self._kind, self._shape = PLANE, np.append(normal, offset)
        else:
            axis, centre = np.array(obstacle.axis), np.array(obstacle.centre)
            self._kind = CYLINDER
            self._shape = np.concatenate([axis, centre, [obstacle.radius]])
            self._deepest = 0.5 * obstacle.radius
            patch = surface.nodes[surface.faces]
            looked = np.einsum("gn,fni->fgi", surface.points.values, patch)
            near = float(self._distances_of(looked.reshape(-1, 3)).min())
            if 0.0 <= near < law.onset:
                self._shape[6] -= law.onset - near

    def couples(self, positions: np.ndarray) -> np.ndarray:
        """None: an obstacle couples no nodes but those of one face."""
        return _NO_COUPLES

    def add(self, positions: np.ndarray, residual: np.ndarray, tangent: Tangent | None) -> Touch:
        """See :class:`Interaction`."""
        bulge = float(np.ptp(positions[self._surface.faces], axis=1).max())
        if self._distance(positions).min() > self._law.onset + bulge:
            return Touch()
        gaps = self._press(positions, residual, tangent)
        pressed = gaps < self._law.onset
        points = pressed.tobytes() if pressed.any() else b""
        return Touch(points, bool(gaps.min() < -self._deepest))

    def gaps(self, positions: np.ndarray) -> np.ndarray:
        """(f, q) distance [m] of the points of every face, negative inside."""
        return self._press(positions, np.zeros_like(positions), None)

    def depth(self, positions: np.ndarray) -> float:
        """Deepest penetration [m] anywhere, negative where there is none: on a fine grid over every
        face that is near. What is thinner than the points are apart slips between them."""
        patch = positions[self._surface.faces]
        low = self._distances_of(patch.reshape(-1, 3)).reshape(-1, 9)
        # a face reaches no farther beyond its nodes than these are apart
        near = low.min(axis=1) - np.ptp(patch, axis=1).max(axis=1) < low.min()
        grid = np.einsum("gn,fni->fgi", GRID_VALUES, patch[near])
        return -float(self._distances_of(grid.reshape(-1, 3)).min())

    def force(self, positions: np.ndarray) -> np.ndarray:
        """(3,) resultant on the obstacle [N]; that of the half for a half model."""
        residual = np.zeros_like(positions)
        self._press(positions, residual, None)
        return residual.sum(axis=0)

    def largest_pressure(self, positions: np.ndarray) -> float:
        """Largest contact pressure at a point [Pa], per undeformed area."""
        return float(law_pressure(self.gaps(positions), self._law).max())

    def overlap(self, positions: np.ndarray) -> float:
        """See :class:`Interaction`."""
        return max(0.0, -float(self.gaps(positions).min()) / self._law.onset)

    def contact_pressure(self, positions: np.ndarray) -> np.ndarray:
        """See :class:`Interaction`."""
        return self._surface.nodal(positions, self.gaps(positions), self._law)

    def _distance(self, positions: np.ndarray) -> np.ndarray:
        """(m,) distance of the surface's nodes."""
        return self._distances_of(positions[self._surface.faces].reshape(-1, 3))

    def _distances_of(self, x: np.ndarray) -> np.ndarray:
        if self._kind == PLANE:
            return x @ self._shape[:3] - self._shape[3]
        apart = x - self._shape[3:6]
        apart = apart - np.outer(apart @ self._shape[:3], self._shape[:3])
        return np.linalg.norm(apart, axis=1) - self._shape[6]

    def _press(
        self, positions: np.ndarray, residual: np.ndarray, tangent: Tangent | None
    ) -> np.ndarray:
        surface, law = self._surface, self._law
        gaps = np.empty(surface.areas.shape)
        into = tangent or Tangent(_NO_DOF, _NO_INDEX, _NO_INDEX, _NO_VALUES)
        add_rigid(
            positions, surface.faces, surface.points.values, surface.areas, self._kind,
            self._shape, law.stiffness, law.onset, residual, tangent is not None, into.dof,
            into.indptr, into.indices, into.values, gaps,
        )  # fmt: skip
        return gaps
