"""The boundary of a body as triangles: watertight, outward from the rubber, as fine as asked.

Block borders are cut into equal parts, so that curved outlines and sheared chambers are followed
through ``Body.place``; every face between rubber and air becomes two triangles.
"""

from dataclasses import dataclass

import numpy as np

from actuators.geometry.body import CAVITY, OUTSIDE, Body

CURVED_PARTS = 4
"""Chords of every curved block of a body, at least."""
TOO_MANY = 2.5
"""Vertices for the screen over those asked for."""


@dataclass(frozen=True, eq=False)
class Surface:
    """Closed surface of the rubber: outside and cavity walls.

    ``vertices``: (n, 3) float64 [m], each used; ``triangles``: (m, 3) int32, counter-clockwise seen
    from the air; ``cavity``: (m,) bool, True where the pressure acts; ``region``: (m,) int8, index
    into ``Body.regions`` of the rubber behind the triangle.
    """

    vertices: np.ndarray
    triangles: np.ndarray
    cavity: np.ndarray
    region: np.ndarray

    @property
    def volume(self) -> float:
        """Volume of the rubber by the divergence theorem [m3]."""
        return _enclosed(self.vertices, self.triangles)

    @property
    def cavity_volume(self) -> float:
        """Volume of the air under pressure [m3]; its walls face inwards."""
        return -_enclosed(self.vertices, self.triangles[self.cavity])


def body_surface(
    body: Body, *, max_edge: float = np.inf, parts: tuple[int, int, int] = (1, 1, 1)
) -> Surface:
    """Surface with no edge longer than ``max_edge`` [m]; infinite keeps the blocks' own faces, cut
    into so many equal ``parts`` in each direction (curved ones at least into
    :data:`CURVED_PARTS` along x')."""
    if body.curved:
        parts = (max(parts[0], CURVED_PARTS), parts[1], parts[2])
    # two legs of a quad at this length have a shorter diagonal of at most max_edge
    lines, counts = _refined(body, max_edge / np.sqrt(2.0), parts)
    fill = body.fill
    for axis in range(3):
        fill = np.repeat(fill, counts[axis], axis=axis)

    quads: list[np.ndarray] = []
    cavity: list[np.ndarray] = []
    region: list[np.ndarray] = []
    for axis in range(3):
        for corners, air, rubber in _faces(fill, axis):
            quads.append(corners)
            cavity.append(air == CAVITY)
            region.append(rubber)
    nodes = np.concatenate(quads)

    used = np.zeros((fill.shape[0] + 1) * (fill.shape[1] + 1) * (fill.shape[2] + 1), dtype=bool)
    used[nodes.ravel()] = True
    number = np.cumsum(used, dtype=np.int32) - 1
    index = np.unravel_index(np.flatnonzero(used), [n + 1 for n in fill.shape])
    vertices = body.place(np.stack([lines[a][index[a]] for a in range(3)], axis=-1))
    return Surface(
        vertices=np.ascontiguousarray(vertices, dtype=np.float64),
        triangles=_split(number[nodes], vertices),
        cavity=np.repeat(np.concatenate(cavity), 2),
        region=np.repeat(np.concatenate(region), 2),
    )


def edge_for(body: Body, vertices: int) -> float:
    """``max_edge`` [m] that gives a surface of very roughly so many vertices; never fewer than the
    blocks' own."""
    coarse = body_surface(body)
    a, b, c = (coarse.vertices[coarse.triangles[:, k]] for k in range(3))
    area = float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)
    edge = float(np.sqrt(2 * area / vertices))
    # what is short on the floor of a curved body is long on its skin, and cut for that everywhere
    while len(body_surface(body, max_edge=edge).vertices) > max(
        TOO_MANY * vertices, 1.1 * len(coarse.vertices)
    ):
        edge *= 1.3
    return edge


def _refined(
    body: Body, leg: float, least: tuple[int, int, int]
) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Lattice lines with every interval in equal parts, at least so many and no longer than ``leg``
    anywhere in the body, and the number of parts of each interval."""
    lines = list(body.lines)
    counts: list[np.ndarray] = []
    for axis in range(3):
        coarse = lines[axis]
        parts = np.full(len(coarse) - 1, least[axis])
        while True:
            lines[axis] = _subdivided(coarse, parts)
            grid = np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1)
            steps = np.linalg.norm(np.diff(body.place(grid), axis=axis), axis=-1)
            longest = np.moveaxis(steps, axis, 0).reshape(steps.shape[axis], -1).max(axis=1)
            excess = np.maximum.reduceat(longest, np.cumsum(parts) - parts) / leg
            if np.all(excess <= 1 + 1e-9):
                break
            # once is enough where the border is straight; arcs may steepen within an interval
            parts = np.ceil(parts * np.maximum(excess, 1) - 1e-9).astype(int)
        counts.append(parts)
    return lines, counts


def _subdivided(line: np.ndarray, parts: np.ndarray) -> np.ndarray:
    pieces = [
        start + (end - start) * np.arange(n) / n
        for start, end, n in zip(line[:-1], line[1:], parts, strict=True)
    ]
    return np.concatenate([*pieces, line[-1:]])


def _faces(fill: np.ndarray, axis: int) -> list[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Faces across ``axis`` between rubber and air: node numbers of the corners (m, 4) in the order
    that faces the air, the air's kind (m,) and the rubber's region (m,)."""
    shape = fill.shape
    padding = [(1, 1) if a == axis else (0, 0) for a in range(3)]
    padded = np.pad(fill, padding, constant_values=OUTSIDE)
    before = np.take(padded, range(shape[axis] + 1), axis=axis)
    after = np.take(padded, range(1, shape[axis] + 2), axis=axis)
    first, second = (axis + 1) % 3, (axis + 2) % 3
    stride = np.array([(shape[1] + 1) * (shape[2] + 1), shape[2] + 1, 1])
    around = np.array([0, stride[first], stride[first] + stride[second], stride[second]])

    faces: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
    for rubber, air, order in ((before, after, around), (after, before, around[::-1])):
        where = np.nonzero((rubber >= 0) & (air < 0))
        origin = np.stack(where, axis=-1) @ stride
        faces.append((origin[:, None] + order, air[where], rubber[where]))
    return faces


def _split(quads: np.ndarray, vertices: np.ndarray) -> np.ndarray:
    """Two triangles for each quad, cut along its shorter diagonal: (2 m, 3) int32."""
    a, b, c, d = (vertices[quads[:, k]] for k in range(4))
    # a tie must not be decided by rounding, or mirrored bodies get unlike triangles
    along_ac = ((c - a) ** 2).sum(axis=1) <= ((d - b) ** 2).sum(axis=1) * (1 + 1e-9)
    turned = np.where(along_ac[:, None], quads, np.roll(quads, -1, axis=1))
    return turned[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3).astype(np.int32)


def _enclosed(vertices: np.ndarray, triangles: np.ndarray) -> float:
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)
