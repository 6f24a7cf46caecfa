"""Whether walls of the cavity have run through each other: suction draws them together, and this
version has contact on the outside only."""

from collections.abc import Sequence

import numpy as np

from actuators.mechanics.continuum.system import State
from actuators.meshing import Faces, HexMesh

# faces x-, y-, z- number their nodes across, x+, y+, z+ along
_TRANSPOSE = np.arange(9).reshape(3, 3).T.ravel()


def least_openness(mesh: HexMesh, states: Sequence[State]) -> np.ndarray:
    """(k,) smallest distance between facing walls of the cavity over that at rest, at most 1;
    below 0 where they have run through each other."""
    low, high = _facing_walls(mesh)
    side = _facing_their_mirror(mesh)
    share = np.ones(len(states))
    for row, state in enumerate(states):
        now = mesh.nodes + state.displacement
        open_by = [now[side, 1] / mesh.nodes[side, 1]]
        if len(low):
            rest = _distances(mesh.nodes, low, high)
            open_by.append((_distances(now, low, high) / rest).ravel())
        share[row] = min([1.0, *(float(part.min()) for part in open_by if len(part))])
    return share


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
