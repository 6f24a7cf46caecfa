"""Which faces can touch each other: pairs that face each other and are near."""

import numpy as np

from actuators.mechanics.continuum.kernel.nearby import near_pairs

OPPOSED = -0.2
"""Largest product of the unit normals of two faces that can touch."""
LEVEL = -1e-6
"""How far behind each other's plane, over their distance, two faces of the undeformed body may lie:
what lies further behind is the other side of the same wall."""
FAR = 2.0
"""Distance between faces of the undeformed body [its height] beyond which they may meet whatever
their places were: by curling up."""


def frames(positions: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Middle (f, 3), unit normal (f, 3) and radius (f,) of faces (f, 9)."""
    x = positions[faces]
    middle = x[:, 4]
    normal = np.cross(x[:, 8] - x[:, 0], x[:, 6] - x[:, 2])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    radius = np.linalg.norm(x - middle[:, None], axis=2).max(axis=1)
    return middle, normal, radius


class PairSearch:
    """Pairs of ``faces`` (f, 9) of a body undeformed at ``nodes`` (n, 3) with this ``height``."""

    def __init__(self, nodes: np.ndarray, faces: np.ndarray, height: float) -> None:
        self._faces, self._far = faces, FAR * height
        self._middle, self._normal, self._radius = frames(nodes, faces)

    def near(self, positions: np.ndarray, reach: float) -> np.ndarray:
        """(k, 2) pairs whose enclosing spheres are closer than ``reach``, with nothing but air
        between them at rest, that share no node; each once."""
        middle, normal, radius = frames(positions, self._faces)
        order = np.argsort(middle[:, 0] - radius)
        return near_pairs(
            order, middle, normal, radius, self._middle, self._normal, self._radius, self._faces,
            reach, OPPOSED, LEVEL, self._far,
        )  # fmt: skip
