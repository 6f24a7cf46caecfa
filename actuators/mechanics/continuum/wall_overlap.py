"""How far neighbouring chamber walls have run into each other where contact is switched off."""

from collections.abc import Sequence

import numpy as np

from actuators.mechanics.continuum.system import State
from actuators.meshing import Faces, HexMesh


def wall_overlap(mesh: HexMesh, states: Sequence[State]) -> np.ndarray:
    """(k,) depth [m] of the deepest overlap across any open gap, 0 where the walls are apart.

    Every node of a wall is compared with the node opposite to it, along the wall's mean normal.
    """
    left, right = _facing_walls(mesh)
    depth = np.zeros(len(states))
    if len(left) == 0:
        return depth
    for row, state in enumerate(states):
        at = mesh.nodes + state.displacement
        one, other = at[left], at[right]
        normal = _patch_normal(one) + _patch_normal(other)
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
        gap = np.einsum("fni,fi->fn", other - one, normal)
        depth[row] = max(0.0, float(-gap.min()))
    return depth


def _facing_walls(mesh: HexMesh) -> tuple[np.ndarray, np.ndarray]:
    """Nodes (f, 9) of the walls on either side of each gap, opposite nodes in the same column."""
    faces = mesh.outer_faces
    first, last = _boxes(mesh, faces, 1), _boxes(mesh, faces, 0)
    right_at = {(int(j), int(k), int(i)): f for f, (i, j, k) in last}
    columns: dict[tuple[int, int], list[int]] = {}
    for j, k, i in right_at:
        columns.setdefault((j, k), []).append(i)
    left: list[np.ndarray] = []
    right: list[np.ndarray] = []
    # faces x+ run (y fastest, z), faces x- run (z fastest, y)
    transpose = np.arange(9).reshape(3, 3).T.ravel()
    for f, (i, j, k) in first:
        beyond = [c for c in columns.get((int(j), int(k)), []) if c > i]
        if beyond:
            left.append(faces.nodes[f])
            right.append(faces.nodes[right_at[int(j), int(k), min(beyond)]][transpose])
    return np.array(left, dtype=int).reshape(-1, 9), np.array(right, dtype=int).reshape(-1, 9)


def _boxes(mesh: HexMesh, faces: Faces, side: int) -> list[tuple[int, np.ndarray]]:
    return [(int(f), mesh.box[faces.element[f]]) for f in np.flatnonzero(faces.local == side)]


def _patch_normal(patch: np.ndarray) -> np.ndarray:
    """Unit normal (f, 3) of patches (f, 9, 3) from the diagonals between corners 0, 2, 6, 8."""
    normal = np.cross(patch[:, 8] - patch[:, 0], patch[:, 6] - patch[:, 2])
    return normal / np.linalg.norm(normal, axis=-1, keepdims=True)
