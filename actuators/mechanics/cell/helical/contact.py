"""Frictionless contact between this chamber's walls and the next one's.

The continuum's own contact acts on the nodes of both sides of the gap (:mod:`.walls`), free of each
other; that they are images of the same sites is the reduction's business, as for the mesh.
"""

import math
from collections.abc import Sequence

import numpy as np

from actuators.materials import Material
from actuators.mechanics.cell.helical.domain import Domain, carried
from actuators.mechanics.cell.helical.screw import Motion
from actuators.mechanics.cell.helical.walls import Walls, gap_walls
from actuators.mechanics.continuum.contact.build import CONCENTRATED
from actuators.mechanics.continuum.contact.interaction import Tangent, Touch
from actuators.mechanics.continuum.contact.self_contact import SelfContact
from actuators.mechanics.continuum.contact.surface import ContactLaw
from actuators.mechanics.continuum.kernel.pattern import node_neighbours, upper_rows

TOLERANCE = 1e-3
"""Penetration [cell sizes] at the contact pressure to be expected: as in the 3D solver for an
actuator five times as long."""


class WallContact:
    """Contact across one gap.

    ``site``, ``image``: (m,) of the nodes on both sides. ``coupled``: (c,) those of them that have
    a place in the matrix, whose blocks stand in ``indptr``, ``indices`` (upper triangle by rows)
    and ``values``.
    """

    def __init__(self, walls: Walls, law: ContactLaw, height: float) -> None:
        self.site, self.image = walls.site, walls.image
        self._law, self._contact = law, SelfContact(walls.surface, law, height)
        self._sets = np.empty((0, 18), dtype=np.int32)
        self._dof = np.full((len(self.site), 3), -1, dtype=np.int32)
        self.coupled = np.empty(0, dtype=np.int64)
        self.indptr, self.indices = np.zeros(1, dtype=np.int32), np.empty(0, dtype=np.int32)
        self.values = np.empty(0)

    def positions(self, place: np.ndarray, motions: Sequence[Motion]) -> np.ndarray:
        """(m, 3) of the nodes, sites at ``place`` (s, 3)."""
        return carried(place, self.site, self.image, motions)

    def press(self, positions: np.ndarray) -> tuple[np.ndarray, Touch]:
        """The potential's gradient (m, 3) [N], and what touches."""
        residual = np.zeros_like(positions)
        return residual, self._contact.add(positions, residual, None)

    def linearise(self, positions: np.ndarray, *, near: bool) -> None:
        """Fill :attr:`values`. ``near``: see :class:`.contact.interaction.Tangent`."""
        self._widen(positions)
        self.values = np.zeros(len(self.indices))
        tangent = Tangent(self._dof, self.indptr, self.indices, self.values, near)
        self._contact.add(positions, np.zeros_like(positions), tangent)

    def _widen(self, positions: np.ndarray) -> None:
        """Make room for faces that have come near each other."""
        more = self._contact.couples(positions).astype(np.int32)
        sets = np.unique(np.concatenate([self._sets, more]), axis=0)
        if len(sets) == len(self._sets):
            return
        self._sets = sets
        first, neighbours = node_neighbours(sets, len(self.site))
        self.coupled = np.flatnonzero(np.diff(first))
        self._dof[self.coupled] = np.arange(3 * len(self.coupled), dtype=np.int32).reshape(-1, 3)
        self.indptr, self.indices = upper_rows(first, neighbours, self._dof, 3 * len(self.coupled))

    def overlap(self, positions: np.ndarray) -> float:
        """Deepest penetration over the distance in which contact sets in."""
        return self._contact.overlap(positions)

    def depth(self, positions: np.ndarray) -> float:
        """Deepest penetration of a Gauss point [m], negative where there is none."""
        return self._contact.depth(positions)

    def largest_pressure(self, positions: np.ndarray) -> float:
        """Largest contact pressure at a Gauss point [Pa], per undeformed area."""
        return self._contact.largest_pressure(positions)


def wall_contact(
    domain: Domain, materials: Sequence[Material], pressure_to: float = math.inf
) -> WallContact | None:
    """As hard as chambers at this pressure [Pa] need it; None where no walls face each other."""
    walls = gap_walls(domain)
    if walls is None:
        return None
    extent = np.ptp(domain.mesh.nodes, axis=0)
    size, height = float(extent.max()), float(extent[2])
    expected = CONCENTRATED * abs(pressure_to)
    modulus = max(material.shear_modulus for material in materials)
    stiffness = min(modulus, expected) / (TOLERANCE * size)
    return WallContact(walls, ContactLaw(stiffness, TOLERANCE / 2 * size), height)
