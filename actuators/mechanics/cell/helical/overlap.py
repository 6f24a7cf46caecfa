"""How far the walls of neighbouring chambers stand apart, or run into each other unhindered."""

import numpy as np

from actuators.mechanics.cell.helical.domain import Image
from actuators.mechanics.cell.helical.system import CellState, CellSystem


class WallGap:
    """Walls that face each other across the open gap between two chambers."""

    def __init__(self, system: CellSystem) -> None:
        self._domain = system.domain
        mesh = self._domain.mesh
        number = {tuple(at): n for n, at in enumerate(mesh.node_index.tolist())}
        last = 2 * (len(mesh.lines[0]) - 1)
        begin = 2 * self._domain.middle - last  # the wall that mirrors the pitch's end
        self._own, self._next = np.empty(0, np.int64), np.empty(0, np.int64)
        self._normal = np.array([1.0, 0.0, 0.0])
        if self._domain.middle == last:  # cut in the gap: its middle plane stands for the neighbour
            self._own = np.flatnonzero(
                (mesh.node_index[:, 0] > last // 2) & (mesh.node_index[:, 0] < last)
            )
            return
        pairs = [
            (n, number[0, at[1], at[2]])
            for at, n in number.items()
            if at[0] == begin and (begin + 1, *at[1:]) not in number and (0, *at[1:]) in number
        ]
        if pairs:
            self._own, self._next = np.array(pairs, dtype=np.int64).T
            wall = mesh.nodes[self._own]
            along = wall[np.argmax(wall[:, 1])] - wall[np.argmin(wall[:, 1])]
            normal = np.array([along[1], -along[0], 0.0])
            self._normal = normal / np.linalg.norm(normal)

    def least(self, state: CellState) -> float:
        """Least distance [m] at the nodes, negative inside; infinite where there is no gap."""
        if not len(self._own):
            return np.inf
        positions = self._domain.mesh.nodes + state.nodes.displacement
        motions = self._domain.motions(state.strain)
        half, pitch = motions[Image.MIDWAY], motions[Image.CARRIED]
        direction = half.rotation @ self._normal
        if not len(self._next):
            return float(2 * ((half.shift - positions[self._own]) @ direction).min())
        beyond = positions[self._next] @ pitch.rotation.T + pitch.shift
        return float(((beyond - positions[self._own]) @ direction).min())
