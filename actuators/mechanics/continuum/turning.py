"""Moving a slender body by a correction that turns it: along arcs instead of straight lines.

A step that turns a section by an angle w, taken straight, stretches the body by w^2/2, and the next
one has to take that back. Here every section X1 = const turns rigidly by its share of the step (the
best fit to its bottom layer), carries along what the step changes within it, and is put at the end
of the one before. To first order in the step that is the step itself: solutions and their
convergence stay what they are, iterations get fewer and steps longer.
"""

import numpy as np

from actuators.meshing import HexMesh

BOTTOM_REGION = 0


class Turning:
    """Sections of a body clamped at X1 = 0. A half model turns about X2 only."""

    def __init__(self, mesh: HexMesh) -> None:
        self._station = mesh.node_index[:, 0].astype(np.int64)
        self._count = int(self._station.max()) + 1
        self._is_half = mesh.is_half
        bottom = np.unique(mesh.elements[mesh.region == BOTTOM_REGION])
        everywhere = len(np.unique(self._station[bottom])) == self._count
        self._marked = bottom if everywhere else np.arange(len(mesh.nodes))
        self._marked_station = self._station[self._marked]
        self._size = np.bincount(self._marked_station, minlength=self._count).astype(float)

    def moved(self, positions: np.ndarray, step: np.ndarray) -> np.ndarray:
        """(n, 3) positions after ``step`` (n, 3)."""
        centre = self._means(positions[self._marked])
        shift = self._means(step[self._marked])
        turn = self._turns(positions, step, centre, shift)
        return self._placed(positions, step, centre, shift, turn)

    def extrapolated(self, before: np.ndarray, last: np.ndarray, ratio: float) -> np.ndarray:
        """(n, 3) positions beyond ``last`` by ``ratio`` times the motion from ``before``."""
        c0, c1 = self._means(before[self._marked]), self._means(last[self._marked])
        r0 = before - c0[self._station]
        r1 = last - c1[self._station]
        outer = np.zeros((self._count, 3, 3))
        np.add.at(
            outer, self._marked_station, r1[self._marked][:, :, None] * r0[self._marked][:, None]
        )
        u, _, vt = np.linalg.svd(outer)
        u[..., :, 2] *= np.where(np.linalg.det(u @ vt) < 0, -1.0, 1.0)[:, None]
        rotation = u @ vt
        turn = _rotation_vectors(rotation)
        if self._is_half:
            turn[:, [0, 2]] = 0.0
            rotation = _rotations(turn)
        # what else has changed, seen in the frame of ``last``
        within = r1 - np.einsum("nij,nj->ni", rotation[self._station], r0)
        middle = (turn[1:] + turn[:-1]) / 2
        along = np.diff(c1, axis=0) - np.einsum(
            "sij,sj->si", _rotations(middle), np.diff(c0, axis=0)
        )
        ahead = _rotations(ratio * middle)
        link = np.einsum("sij,sj->si", ahead, np.diff(c1, axis=0) + ratio * along)
        start = c1[:1] + ratio * (c1[:1] - c0[:1])
        centre = np.concatenate([start, start + np.cumsum(link, axis=0)])
        local = np.einsum(
            "nij,nj->ni", _rotations(ratio * turn)[self._station], r1 + ratio * within
        )
        return centre[self._station] + local

    def _means(self, values: np.ndarray) -> np.ndarray:
        total = np.zeros((self._count, 3))
        np.add.at(total, self._marked_station, values)
        return total / self._size[:, None]

    def _turns(
        self, positions: np.ndarray, step: np.ndarray, centre: np.ndarray, shift: np.ndarray
    ) -> np.ndarray:
        """(s, 3) rotation of each section that fits the step best, to first order."""
        r = positions[self._marked] - centre[self._marked_station]
        du = step[self._marked] - shift[self._marked_station]
        moment, inertia = np.zeros((self._count, 3)), np.zeros((self._count, 3, 3))
        np.add.at(moment, self._marked_station, np.cross(r, du))
        square = np.einsum("ni,ni->n", r, r)
        np.add.at(
            inertia, self._marked_station,
            square[:, None, None] * np.eye(3) - r[:, :, None] * r[:, None],
        )  # fmt: skip
        if self._is_half:
            turn = np.zeros((self._count, 3))
            turn[:, 1] = moment[:, 1] / inertia[:, 1, 1]
            return turn
        return np.linalg.solve(inertia, moment[..., None])[..., 0]

    def _placed(
        self,
        positions: np.ndarray,
        step: np.ndarray,
        centre: np.ndarray,
        shift: np.ndarray,
        turn: np.ndarray,
    ) -> np.ndarray:
        station = self._station
        r = positions - centre[station]
        within = step - shift[station] - np.cross(turn[station], r)
        local = np.einsum("nij,nj->ni", _rotations(turn)[station], r + within)
        middle, apart = (turn[1:] + turn[:-1]) / 2, np.diff(centre, axis=0)
        along = np.diff(shift, axis=0) - np.cross(middle, apart)
        link = np.einsum("sij,sj->si", _rotations(middle), apart + along)
        start = (centre + shift)[:1]
        return np.concatenate([start, start + np.cumsum(link, axis=0)])[station] + local


def _rotations(vectors: np.ndarray) -> np.ndarray:
    """(s, 3, 3) matrices of rotation vectors (s, 3)."""
    angle = np.linalg.norm(vectors, axis=1)
    safe = np.where(angle > 1e-12, angle, 1.0)
    axis = vectors / safe[:, None]
    k = np.zeros((len(vectors), 3, 3))
    k[:, 0, 1], k[:, 0, 2], k[:, 1, 2] = -axis[:, 2], axis[:, 1], -axis[:, 0]
    k -= np.swapaxes(k, 1, 2)
    sine, cosine = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.eye(3) + sine * k + (1 - cosine) * (k @ k)


def _rotation_vectors(rotation: np.ndarray) -> np.ndarray:
    """Rotation vectors (s, 3) of matrices, for angles below pi."""
    axial = np.stack(
        [
            rotation[:, 2, 1] - rotation[:, 1, 2],
            rotation[:, 0, 2] - rotation[:, 2, 0],
            rotation[:, 1, 0] - rotation[:, 0, 1],
        ],
        axis=-1,
    )
    sine = np.linalg.norm(axial, axis=-1) / 2
    angle = np.arctan2(sine, (np.trace(rotation, axis1=-2, axis2=-1) - 1) / 2)
    return axial / 2 * np.where(sine > 1e-12, angle / np.maximum(sine, 1e-12), 1.0)[:, None]
