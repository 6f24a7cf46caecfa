"""Walls that face each other across open gaps, and how far apart they are: a cheap look at every
state of a path whose problem holds no contact.

Which places face each other is settled once, on the undeformed body: neighbours stand along X1.
"""

import numpy as np
from scipy.spatial import KDTree

from actuators.meshing import HexMesh

SIDEWAYS = 0.2
"""Least component along X1 of the normal of a wall that has a neighbour."""
OPPOSED = -0.5
"""Largest product of the normals of two walls that face each other."""
ASIDE = 0.5
"""How far beside the normal of one place the other may lie, over the size of its face: coarse faces
of oblique chambers have no nodes just opposite."""
NARROW = 0.3
"""Pairs nearer than this share of the middle gap are left out: where a gap runs out into its
bottom, walls are one."""
FARTHEST = 1.0
"""Widest gap [body heights]."""
_NEIGHBOURS = 48
# slopes of a quadratic at its first, middle and last node
_SLOPE = np.array([[-1.5, 2.0, -0.5], [-0.5, 0.0, 0.5], [0.5, -2.0, 1.5]])


class FacingWalls:
    """Pairs of places, nodes of outer faces, on either side of the gaps of ``mesh``."""

    def __init__(self, mesh: HexMesh) -> None:
        self._nodes = mesh.nodes
        faces = mesh.outer_faces.nodes
        clamp = np.zeros(len(mesh.nodes), dtype=bool)
        clamp[mesh.clamp_nodes] = True
        faces = faces[~clamp[faces].all(axis=1)]
        self._one, self._other = self._pairs(faces, float(np.ptp(mesh.nodes[:, 2])))
        self.at_rest = self._distances(mesh.nodes)
        if len(self.at_rest):
            wide = self.at_rest > NARROW * np.median(self.at_rest)
            self._one, self._other = _rows(self._one, wide), _rows(self._other, wide)
            self.at_rest = self.at_rest[wide]

    def distances(self, displacement: np.ndarray) -> np.ndarray:
        """(k,) distance [m] of each pair along the walls' normals, negative where they overlap."""
        return self._distances(self._nodes + displacement)

    def openness(self, displacement: np.ndarray) -> float:
        """Least distance of a pair over that at rest; infinite where no walls face each other."""
        if len(self.at_rest) == 0:
            return np.inf
        return float((self.distances(displacement) / self.at_rest).min())

    def _distances(self, positions: np.ndarray) -> np.ndarray:
        one, other = self._one, self._other
        if len(one[0]) == 0:
            return np.empty(0)
        normal = _normals(positions, *one) - _normals(positions, *other)
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
        across = positions[_nodes_of(*other)] - positions[_nodes_of(*one)]
        return np.einsum("ki,ki->k", across, normal)

    def _pairs(
        self, faces: np.ndarray, height: float
    ) -> tuple[tuple[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]:
        """(faces (k, 9), local place (k,)) on either side."""
        face = np.repeat(np.arange(len(faces)), 9)
        place = np.tile(np.arange(9), len(faces))
        normal = _normals(self._nodes, faces[face], place)
        position = self._nodes[faces[face, place]]
        right = np.flatnonzero(normal[:, 0] > SIDEWAYS)
        left = np.flatnonzero(normal[:, 0] < -SIDEWAYS)
        none = (np.empty((0, 9), dtype=faces.dtype), np.empty(0, dtype=int))
        if len(right) == 0 or len(left) == 0:
            return none, none
        near = min(_NEIGHBOURS, len(left))
        _, found = KDTree(position[left]).query(position[right], k=near)
        candidate = left[np.asarray(found).reshape(len(right), near)]
        across = position[candidate] - position[right][:, None]
        ahead = np.einsum("rki,ri->rk", across, normal[right])
        aside = np.linalg.norm(across - ahead[..., None] * normal[right][:, None], axis=-1)
        facing = np.einsum("rki,ri->rk", normal[candidate], normal[right]) < OPPOSED
        corners = self._nodes[faces[:, [0, 2, 6, 8]]]
        size = np.linalg.norm(corners[:, [1, 3, 3, 2]] - corners[:, [0, 1, 2, 0]], axis=2).max(
            axis=1
        )
        fits = facing & (ahead > 0) & (ahead < FARTHEST * height)
        fits &= aside < ASIDE * size[face[right]][:, None]
        cost = np.where(fits, ahead + aside, np.inf)
        best = cost.argmin(axis=1)
        kept = np.isfinite(cost.min(axis=1))
        one, other = right[kept], candidate[np.arange(len(right)), best][kept]
        return (faces[face[one]], place[one]), (faces[face[other]], place[other])


def _nodes_of(faces: np.ndarray, place: np.ndarray) -> np.ndarray:
    return faces[np.arange(len(faces)), place]


def _rows(side: tuple[np.ndarray, np.ndarray], kept: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return side[0][kept], side[1][kept]


def _normals(positions: np.ndarray, faces: np.ndarray, place: np.ndarray) -> np.ndarray:
    """Unit normals (k, 3) at local places (k,) of faces (k, 9)."""
    patch = positions[faces].reshape(-1, 3, 3, 3)
    row, column = place // 3, place % 3
    number = np.arange(len(faces))
    along = np.einsum("kc,kci->ki", _SLOPE[column], patch[number, row])
    across = np.einsum("kr,kri->ki", _SLOPE[row], patch[number, :, column])
    normal = np.cross(along, across)
    return normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
