"""From a film to bodies that can be sent: coloured GLB frames in mm, and their legend."""

import secrets
from dataclasses import dataclass

import numpy as np

from backend.viewer import colour_maps
from backend.viewer.film import Film
from backend.viewer.glb import coloured_body
from backend.viewer.obstacles import cylinder_mesh, obstacle_glb, plate_mesh
from backend.viewer.room import Bodies
from backend.viewer.schemas import Colour, Legend
from backend.viewer.shading import PLAIN, palette, vertex_colours
from backend.viewer.skin import Skin

_EDGES = (0.05, 0.06, 0.08, 1.0)
_GHOST_EDGES = (0.35, 0.38, 0.42, 0.55)
_GHOST_OPACITY = 0.10
_GHOST_INSET_MM = 0.08
"""The undeformed body is drawn a little smaller, or its faces would fight with those of a body that
has hardly moved."""


@dataclass(frozen=True)
class _Scale:
    """How a quantity is coloured. ``unit_si``: SI value of one unit."""

    label: str
    unit: str
    unit_si: float
    map_name: str


_SCALES: dict[Colour, _Scale] = {
    "displacement": _Scale("Displacement", "mm", 1e-3, "viridis"),
    "stretch": _Scale("Largest principal stretch", "", 1.0, "cividis"),
    "stress": _Scale("Largest principal stress", "kPa", 1e3, "inferno"),
    "contact": _Scale("Contact pressure", "kPa", 1e3, "viridis"),
}


@dataclass(frozen=True, eq=False)
class Picture:
    """Bodies ready to be sent, and what they mean."""

    bodies: Bodies
    colour: Colour
    colours: list[Colour]
    legend: Legend | None
    pressures: np.ndarray
    volumes: np.ndarray
    vertices: int


def picture(film: Film, colour: Colour, *, undeformed: bool) -> Picture:
    """Colour every frame, and write it as GLB."""
    used: Colour = colour if colour == "none" or colour in film.values else "displacement"
    normals = film.skin.normals(film.points)
    position, legend = _position(film, used)
    map_name = PLAIN if used == "none" else _SCALES[used].map_name
    colours = vertex_colours(map_name, position, normals)
    factor = palette(map_name)[1]
    points = (film.points * 1e3).astype(np.float32)
    take = secrets.token_hex(6)
    frames = [
        coloured_body(
            points[k], film.skin.triangles, colours[k], film.skin.edges, factor=factor,
            edge_colour=_EDGES, take=take,
        )
        for k in range(len(points))
    ]  # fmt: skip
    undeformed_points = film.ghost.points * 1e3
    low, high = undeformed_points.min(axis=0), undeformed_points.max(axis=0)
    for axis in range(3):
        low[axis] = min(low[axis], points[..., axis].min())
        high[axis] = max(high[axis], points[..., axis].max())
    root = undeformed_points[undeformed_points[:, 0] < undeformed_points[:, 0].min() + 0.1]
    box = np.stack([low, high]).astype(float)
    obstacles, box = _obstacles(film, undeformed_points, box, take)
    bodies = Bodies(
        take=take,
        frames=frames,
        undeformed=_ghost(film.ghost, take) if undeformed else None,
        obstacles=obstacles,
        box=box,
        clamp=np.stack([root[:, 1:].min(axis=0), root[:, 1:].max(axis=0)]),
    )
    available: list[Colour] = [name for name in _SCALES if name in film.values]
    return Picture(
        bodies, used, [*available, "none"], legend, film.pressures, film.volumes, points.shape[1]
    )


def _obstacles(
    film: Film, undeformed: np.ndarray, box: np.ndarray, take: str
) -> tuple[list[bytes], np.ndarray]:
    """GLBs of the scene's obstacles, and the box (2, 3) [mm] that holds them as well."""
    meshes = []
    if film.plate is not None:
        meshes.append(plate_mesh(film.plate, undeformed, box))
    if film.cylinder is not None:
        meshes.append(cylinder_mesh(film.cylinder, box))
    for points, _, _ in meshes:
        box = np.stack([np.minimum(box[0], points.min(0)), np.maximum(box[1], points.max(0))])
    return [obstacle_glb(*mesh, take=take) for mesh in meshes], box


def _position(film: Film, colour: Colour) -> tuple[np.ndarray, Legend | None]:
    """Where every value lies on the scale, and the scale. One scale for all frames."""
    if colour == "none":
        return np.zeros(film.points.shape[:2], dtype=np.float32), None
    scale = _SCALES[colour]
    values = film.values[colour].astype(np.float32) / np.float32(scale.unit_si)
    lower = 1.0 if colour == "stretch" else 0.0
    if colour in ("displacement", "contact"):
        upper = float(values.max())
    else:
        # a re-entrant corner has no finite stress: its few points must not flatten all others
        upper = float(np.quantile(values[-1], 0.995))
        lower = min(lower, float(np.quantile(values[-1], 0.005)))
    if not upper > lower:
        upper = lower + 1e-3
    legend = Legend(
        label=scale.label,
        unit=scale.unit,
        lower=float(f"{lower:.4g}"),
        upper=float(f"{upper:.4g}"),
        clipped=bool(values.max() > 1.001 * upper),
        stops=colour_maps.stops(scale.map_name),
    )
    return np.clip((values - lower) / (upper - lower), 0.0, 1.0), legend


def _ghost(body: Skin, take: str) -> bytes:
    colours = vertex_colours(PLAIN, np.zeros(len(body.points)), np.zeros_like(body.points))
    inset = _GHOST_INSET_MM * body.normals(body.points[None])[0]
    return coloured_body(
        (body.points * 1e3 - inset).astype(np.float32),
        body.triangles,
        colours,
        body.edges,
        factor=palette(PLAIN)[1],
        edge_colour=_GHOST_EDGES,
        opacity=_GHOST_OPACITY,
        take=take,
    )
