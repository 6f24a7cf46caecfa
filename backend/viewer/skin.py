"""The skin that is drawn: a surface with its sharp edges kept sharp."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components

SHARP_DEG = 35.0
"""Faces that meet at a larger angle than this keep an edge between them."""


@dataclass(frozen=True, eq=False)
class Skin:
    """``points``: (n, 3) [m] undeformed; ``triangles``: (m, 3), outward; ``edges``: (e, 2) sharp
    edges; ``source``: (n,) the vertex of the surface that each point came from."""

    points: np.ndarray
    triangles: np.ndarray
    edges: np.ndarray
    source: np.ndarray
    _gather: csr_array

    def normals(self, points: np.ndarray) -> np.ndarray:
        """Outward unit normals of deformed points (k, n, 3), weighted by area: (k, n, 3)."""
        # (n, 3, k): the innermost loops run over all frames, which makes it five times faster
        p = np.ascontiguousarray(points.transpose(1, 2, 0), dtype=np.float32)
        a = p[self.triangles[:, 0]]
        u, v = p[self.triangles[:, 1]] - a, p[self.triangles[:, 2]] - a
        faces = np.empty_like(u)
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            faces[:, i] = u[:, j] * v[:, k] - u[:, k] * v[:, j]
        normals = (self._gather @ faces.reshape(len(faces), -1)).reshape(-1, *p.shape[1:])
        length = np.sqrt((normals**2).sum(axis=1, keepdims=True))
        return (normals / np.maximum(length, np.float32(1e-30))).transpose(2, 0, 1)


def skin(vertices: np.ndarray, triangles: np.ndarray) -> Skin:
    """Split a surface's vertices (n, 3) where its triangles (m, 3) meet at a sharp edge."""
    triangles = np.asarray(triangles, dtype=np.int64)
    pairs, ends = _neighbours(triangles, len(vertices))
    corner = vertices[triangles]
    face = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    face /= np.maximum(np.linalg.norm(face, axis=1, keepdims=True), 1e-30)
    cosine = (face[pairs[:, 0]] * face[pairs[:, 1]]).sum(axis=1)
    smooth = cosine > np.cos(np.radians(SHARP_DEG))

    # corners of neighbouring triangles at the same vertex are one point, unless the edge is sharp
    m = len(triangles)
    joined_a, joined_b = [], []
    for end in (0, 1):
        vertex = ends[smooth, end]
        for side, joined in ((0, joined_a), (1, joined_b)):
            triangle = pairs[smooth, side]
            place = np.argmax(triangles[triangle] == vertex[:, None], axis=1)
            joined.append(3 * triangle + place)
    a, b = np.concatenate(joined_a), np.concatenate(joined_b)
    graph = csr_array((np.ones(len(a), dtype=np.int8), (a, b)), shape=(3 * m, 3 * m))
    count, label = connected_components(graph, directed=False)

    source = np.empty(count, dtype=np.int64)
    source[label] = triangles.ravel()
    first = np.full(len(vertices), -1, dtype=np.int64)
    first[source[::-1]] = np.arange(count)[::-1]
    gather = csr_array(
        (np.ones(3 * m, dtype=np.float32), (label, np.repeat(np.arange(m), 3))), shape=(count, m)
    )
    return Skin(
        points=vertices[source],
        triangles=label.reshape(m, 3).astype(np.int32),
        edges=first[ends[~smooth]].astype(np.int32),
        source=source,
        _gather=gather,
    )


def _neighbours(triangles: np.ndarray, vertices: int) -> tuple[np.ndarray, np.ndarray]:
    """Pairs of triangles that share an edge (p, 2), and the two vertices of that edge (p, 2)."""
    a, b = triangles, np.roll(triangles, -1, axis=1)
    low, high = np.minimum(a, b).ravel(), np.maximum(a, b).ravel()
    key = low * vertices + high
    order = np.argsort(key, kind="stable")
    same = np.flatnonzero(key[order][1:] == key[order][:-1])
    one, other = order[same], order[same + 1]
    pairs = np.stack([one // 3, other // 3], axis=1)
    return pairs, np.stack([low[one], high[one]], axis=1)
