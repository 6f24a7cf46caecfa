"""How far apart the walls of the cavity are: suction draws them together."""

from collections.abc import Sequence

import numpy as np

from actuators.mechanics.continuum.system import State
from actuators.meshing import Faces, HexMesh

FARTHEST = 1.0
"""Distance at rest [body heights] beyond which walls are not held against each other: the two ends
of a channel through the whole body turn against each other as it bends."""
# faces x-, y-, z- number their nodes across, x+, y+, z+ along
_TRANSPOSE = np.arange(9).reshape(3, 3).T.ravel()


class CavityWalls:
    """Walls of ``mesh`` that face each other across its cavity, or across the middle plane."""

    def __init__(self, mesh: HexMesh) -> None:
        self._nodes = mesh.nodes
        self._side = _facing_their_mirror(mesh)
        low, high = _facing_walls(mesh)
        rest = _distances(mesh.nodes, low, high)
        near = (rest < FARTHEST * float(np.ptp(mesh.nodes[:, 2]))).all(axis=1)
        self._low, self._high, self._rest = low[near], high[near], rest[near]

    def openness(self, displacement: np.ndarray) -> float:
        """Smallest distance over that at rest, at most 1; below 0 where walls have run through each
        other."""
        now = self._nodes + displacement
        across = _distances(now, self._low, self._high) / self._rest
        return float(min(1.0, self.from_the_middle(displacement), across.min(initial=1.0)))

    def from_the_middle(self, displacement: np.ndarray) -> float:
        """Smallest distance of a half model's side walls from its middle plane over that at rest,
        at most 1; below 0 where they have crossed it, and with it their mirror images."""
        rest = self._nodes[self._side, 1]
        open_by = 1 + displacement[self._side, 1] / rest
        return float(open_by.min(initial=1.0))


def least_openness(mesh: HexMesh, states: Sequence[State]) -> np.ndarray:
    """(k,) :meth:`CavityWalls.openness` of every state."""
    walls = CavityWalls(mesh)
    return np.array([walls.openness(state.displacement) for state in states])


def _facing_their_mirror(mesh: HexMesh) -> np.ndarray:
    """Nodes of a half model's side walls, opposite to the middle plane."""
    faces = mesh.cavity_faces
    nodes = np.unique(faces.nodes[faces.local == 2]) if mesh.is_half else np.empty(0, dtype=int)
    return nodes[mesh.nodes[nodes, 1] > 0.0]


def _distances(at: np.ndarray, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """(f, 9) from node to opposite node along the mean normal of the lower wall."""
    patch = at[low]
    normal = np.cross(patch[:, 2] - patch[:, 6], patch[:, 8] - patch[:, 0])
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    return np.einsum("fni,fi->fn", at[high] - patch, normal)


def _facing_walls(mesh: HexMesh) -> tuple[np.ndarray, np.ndarray]:
    """Nodes (f, 9) of walls that face each other across the cavity, opposite ones in the same
    column."""
    low: list[np.ndarray] = []
    high: list[np.ndarray] = []
    for direction in range(3):
        across = {key: f for f, key in _places(mesh, mesh.cavity_faces, direction, 0)}
        lines: dict[tuple[int, ...], list[int]] = {}
        for *line, at in across:
            lines.setdefault(tuple(line), []).append(at)
        for f, (*line, at) in _places(mesh, mesh.cavity_faces, direction, 1):
            beyond = [other for other in lines.get(tuple(line), []) if other > at]
            if beyond:
                low.append(mesh.cavity_faces.nodes[f])
                opposite = across[(*line, min(beyond))]
                high.append(mesh.cavity_faces.nodes[opposite][_TRANSPOSE])
    return np.array(low, dtype=int).reshape(-1, 9), np.array(high, dtype=int).reshape(-1, 9)


def _places(
    mesh: HexMesh, faces: Faces, direction: int, side: int
) -> list[tuple[int, tuple[int, ...]]]:
    """Faces on one side, each with its element's place: along the other directions, then this."""
    order = [d for d in range(3) if d != direction] + [direction]
    chosen = np.flatnonzero(faces.local == 2 * direction + side)
    boxes = mesh.box[faces.element[chosen]][:, order]
    return [(int(f), tuple(int(n) for n in box)) for f, box in zip(chosen, boxes, strict=True)]
