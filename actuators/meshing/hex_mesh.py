"""A structured mesh of 27-node hexahedra."""

from dataclasses import dataclass, field

import numpy as np

from actuators.geometry.body import Region

# local nodes i + 3 j + 9 k of each face as a 3 x 3 patch (first axis fastest), right-handed about
# the outward normal; faces x-, x+, y-, y+, z-, z+
FACE_NODES: np.ndarray = np.array(
    [
        [0 + 3 * b + 9 * a for b in range(3) for a in range(3)],
        [2 + 3 * a + 9 * b for b in range(3) for a in range(3)],
        [a + 0 + 9 * b for b in range(3) for a in range(3)],
        [b + 6 + 9 * a for b in range(3) for a in range(3)],
        [b + 3 * a + 0 for b in range(3) for a in range(3)],
        [a + 3 * b + 18 for b in range(3) for a in range(3)],
    ],
    dtype=np.int32,
)
CENTRE = 13
"""Local number of the node inside an element."""


@dataclass(frozen=True, eq=False)
class Faces:
    """Sides of elements: ``element`` (f,), ``local`` (f,) row of :data:`FACE_NODES`, ``nodes``
    (f, 9) global nodes, right-handed about the normal that points out of the rubber."""

    element: np.ndarray
    local: np.ndarray
    nodes: np.ndarray

    def __len__(self) -> int:
        return len(self.element)

    @staticmethod
    def none() -> "Faces":
        """No faces at all."""
        empty = np.empty(0, dtype=np.int32)
        return Faces(element=empty, local=empty, nodes=np.empty((0, 9), dtype=np.int32))


@dataclass(frozen=True, eq=False)
class HexMesh:
    """n nodes, m elements of order 2.

    ``nodes``: (n, 3) [m], undeformed. ``elements``: (m, 27) int32, local node i + 3 j + 9 k.
    ``region``: (m,) index into ``regions``. ``lines``: mesh lines in lattice coordinates;
    ``box``: (m, 3) position of each element between those lines; ``node_index``: (n, 3)
    position of each node on the lines and the middles between them.
    ``cavity_faces`` meet the air under pressure, ``outer_faces`` the surroundings (a periodic
    cell: without its two ends), ``symmetry_faces`` the plane X2 = 0 of a half model.
    ``membrane_faces`` lie on embedded sheets, each face once: side z+ of the element below the
    sheet, or z- of the one above where nothing is below; ``membrane_stiffness``: (f,) [N/m], see
    :class:`.geometry.Membrane`.
    """

    nodes: np.ndarray
    elements: np.ndarray
    region: np.ndarray
    regions: tuple[Region, ...]
    lines: tuple[np.ndarray, np.ndarray, np.ndarray]
    box: np.ndarray
    node_index: np.ndarray
    cavity_faces: Faces
    outer_faces: Faces
    symmetry_faces: Faces
    is_half: bool
    period: float | None = None
    membrane_faces: Faces = field(default_factory=Faces.none)
    membrane_stiffness: np.ndarray = field(default_factory=lambda: np.empty(0))

    def on_first_plane(self, direction: int) -> np.ndarray:
        """Nodes of the plane where lattice coordinate ``direction`` is smallest."""
        return np.flatnonzero(self.node_index[:, direction] == 0)

    def on_last_plane(self, direction: int) -> np.ndarray:
        """Nodes of the plane where lattice coordinate ``direction`` is largest."""
        last = 2 * (len(self.lines[direction]) - 1)
        return np.flatnonzero(self.node_index[:, direction] == last)

    @property
    def clamp_nodes(self) -> np.ndarray:
        """Nodes of the clamped end."""
        return self.on_first_plane(0)

    @property
    def tip_nodes(self) -> np.ndarray:
        """Nodes of the free end."""
        return self.on_last_plane(0)

    @property
    def bottom_nodes(self) -> np.ndarray:
        """Nodes of the underside."""
        return self.on_first_plane(2)

    @property
    def symmetry_nodes(self) -> np.ndarray:
        """Nodes of the plane X2 = 0 of a half model; empty for a whole body."""
        return self.on_first_plane(1) if self.is_half else np.empty(0, dtype=np.int64)

    @property
    def underside_line(self) -> np.ndarray:
        """Nodes of the underside in the middle plane, from the clamp to the tip; the last one is
        the tip point."""
        middle = 0 if self.is_half else len(self.lines[1]) - 1
        on_line = (self.node_index[:, 1] == middle) & (self.node_index[:, 2] == 0)
        nodes = np.flatnonzero(on_line)
        return nodes[np.argsort(self.node_index[nodes, 0])]

    @property
    def centre_nodes(self) -> np.ndarray:
        """(m,) the node inside each element."""
        return self.elements[:, CENTRE]
