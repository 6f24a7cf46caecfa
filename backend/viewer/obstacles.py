"""Rigid obstacles of a scene as translucent bodies, no larger than needed to be understood."""

import numpy as np

from actuators.mechanics.obstacles import Cylinder, Plate
from backend.viewer.glb import coloured_body
from backend.viewer.shading import PLAIN, palette, vertex_colours

_OPACITY = 0.34
_EDGES = (0.10, 0.16, 0.24, 0.7)
_TINT = np.array([0.62, 0.80, 1.0, 1.0])
"""Of the plain grey, so that no rubber is taken for an obstacle."""
_THICK = 0.03
"""Thickness of a plate over the size of what stands before it."""
_SIDES = 64


def plate_mesh(
    plate: Plate, body: np.ndarray, box: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Slab under the actuator: points (n, 3) [mm], triangles (m, 3) outward, edges (e, 2).

    ``body``: points (k, 3) [mm] of the undeformed body, from which the gap is measured; ``box``:
    (2, 3) [mm] around all that is shown. Its face towards the actuator is the plate's.
    """
    normal = np.array(plate.normal)
    level = float((body @ normal).min()) - plate.gap * 1e3
    across, along = _beside(normal)
    corners = np.array([[x, y, z] for x in box[:, 0] for y in box[:, 1] for z in box[:, 2]])
    size = float(np.linalg.norm(box[1] - box[0]))
    margin = 0.12 * size
    u = corners @ across
    v = corners @ along
    outline = [
        (u.min() - margin, v.min() - margin), (u.max() + margin, v.min() - margin),
        (u.max() + margin, v.max() + margin), (u.min() - margin, v.max() + margin),
    ]  # fmt: skip
    face = np.array([level * normal + a * across + b * along for a, b in outline])
    points = np.concatenate([face, face - _THICK * size * normal])
    return points, *_prism(4)


def cylinder_mesh(cylinder: Cylinder, box: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Piece of the bar beside the actuator; as :func:`plate_mesh`."""
    axis, centre = np.array(cylinder.axis), np.array(cylinder.centre) * 1e3
    across, along = _beside(axis)
    corners = np.array([[x, y, z] for x in box[:, 0] for y in box[:, 1] for z in box[:, 2]])
    reach = (corners - centre) @ axis
    margin = 0.15 * float(np.linalg.norm(box[1] - box[0]))
    turn = np.linspace(0, 2 * np.pi, _SIDES, endpoint=False)[:, None]
    ring = centre + cylinder.radius * 1e3 * (np.cos(turn) * across + np.sin(turn) * along)
    top, bottom = ring + (reach.max() + margin) * axis, ring + (reach.min() - margin) * axis
    points, triangles, edges = np.concatenate([top, bottom]), *_prism(_SIDES)
    return points, triangles, edges[: 2 * _SIDES]


def obstacle_glb(
    points: np.ndarray, triangles: np.ndarray, edges: np.ndarray, *, take: str
) -> bytes:
    """GLB of one obstacle, marked as part of ``take``; every face is lit by its own normal."""
    flat = points[triangles.ravel()]
    a, b, c = flat[0::3], flat[1::3], flat[2::3]
    normals = np.cross(b - a, c - a)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    faces = vertex_colours(PLAIN, np.zeros(len(flat)), np.repeat(normals, 3, axis=0))
    lines = points[edges.ravel()]
    colours = np.concatenate([faces, np.repeat(faces[:1], len(lines), axis=0)])
    return coloured_body(
        np.concatenate([flat, lines]).astype(np.float32),
        np.arange(len(flat)).reshape(-1, 3),
        (colours * _TINT).astype(np.int16),
        len(flat) + np.arange(len(lines)).reshape(-1, 2),
        factor=palette(PLAIN)[1],
        edge_colour=_EDGES,
        opacity=_OPACITY,
        take=take,
    )


def _beside(normal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Two unit vectors that with ``normal`` make a right-handed frame."""
    helper = np.eye(3)[int(np.argmin(np.abs(normal)))]
    across = np.cross(helper, normal)
    across /= np.linalg.norm(across)
    return across, np.cross(normal, across)


def _prism(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Triangles and edges between a ring of ``n`` points, counterclockwise seen from above, and
    the ring below it."""
    k = np.arange(n)
    after = (k + 1) % n
    sides = np.concatenate(
        [np.stack([k, k + n, after], axis=1), np.stack([after, k + n, after + n], axis=1)]
    )
    fan = np.stack([np.zeros(n - 2, dtype=int), k[1:-1], k[2:]], axis=1)
    edges = np.concatenate(
        [np.stack([k, after], axis=1), np.stack([k, after], axis=1) + n,
         np.stack([k, k + n], axis=1)]
    )  # fmt: skip
    return np.concatenate([fan, fan[:, ::-1] + n, sides]), edges
