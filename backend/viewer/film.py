"""From an answer to a film: the points of a drawn skin at every pressure, and values on them."""

import json
import threading
from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components

from actuators.design import Design, parse_design
from actuators.errors import QuestionError
from actuators.geometry import build_body
from actuators.geometry.surface import body_surface, edge_for
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.response import Centreline, Response
from actuators.mechanics.scene import Scene
from backend.simulations.instant import InstantRung, answer_in_part
from backend.viewer.schemas import Colour
from backend.viewer.skin import Skin, skin
from backend.viewer.sweep import swept
from storage.response_arrays import unpack

MOST_FRAMES = 21
INSTANT_VERTICES = 4000
"""Vertices of a swept body, roughly; it has no finer detail to show."""
MOST_BYTES = 24_000_000
"""All frames together; larger surfaces get fewer frames."""
_BYTES_A_VERTEX = 34


@dataclass(frozen=True, eq=False)
class Film:
    """What a source gives to be shown, SI: points of every frame (k, n, 3) on a skin, values per
    point (k, n) by colour, pressure and cavity volume (NaN where unknown) of every frame (k,), and
    the obstacles of its scene."""

    skin: Skin
    ghost: Skin
    points: np.ndarray
    values: dict[Colour, np.ndarray]
    pressures: np.ndarray
    volumes: np.ndarray
    plate: Plate | None
    cylinder: Cylinder | None


class Shelf:
    """The films of the stored answers shown last: another colour needs no second reading."""

    def __init__(self, most: int = 4) -> None:
        self._films: OrderedDict[str, Film] = OrderedDict()
        self._lock = threading.Lock()
        self._most = most

    def film(self, sha256: str, read: Callable[[], Film]) -> Film:
        """The film of an artifact, read when it is not on the shelf."""
        with self._lock:
            found = self._films.get(sha256)
        film = found or read()
        with self._lock:
            self._films[sha256] = film
            self._films.move_to_end(sha256)
            while len(self._films) > self._most:
                self._films.popitem(last=False)
        return film


def instant_film(
    design: Design, scene: Scene, stamp: Callable[[str], None], *, rung: InstantRung = "energy"
) -> Film:
    """An instant rung's answer without loads it cannot carry: the undeformed surface, moved along
    with the rod."""
    response, _ = answer_in_part(design, replace(scene, steps=MOST_FRAMES - 1), rung=rung)
    stamp("solve")
    _skins(design)
    stamp("surface")
    pressures = np.array([p.pressure for p in response.path])
    film = _rod_film(design, scene, response.centreline, pressures, _volumes(response))
    stamp("sweep")
    return film


def _volumes(response: Response) -> np.ndarray:
    return np.array([np.nan if p.cavity_volume is None else p.cavity_volume for p in response.path])


def _rod_film(
    design: Design,
    scene: Scene,
    rod: Centreline | None,
    pressures: np.ndarray,
    volumes: np.ndarray,
) -> Film:
    if rod is None:
        raise QuestionError(
            "This answer has neither a surface nor a centreline to show.", field="source",
            mend="Show the instant answer or a finite-element job.",
        )  # fmt: skip
    body, ghost = _skins(design)
    which = chosen_frames(len(pressures), MOST_FRAMES)
    points = swept(body.points, rod, which)
    moved = np.linalg.norm(points - body.points, axis=-1)
    return Film(
        body, ghost, points, {"displacement": moved}, pressures[which], volumes[which],
        scene.plate, scene.cylinder,
    )  # fmt: skip


def stored_film(
    artifact: bytes, design: Design, scene: Scene, volumes_ml: Sequence[float | None]
) -> Film:
    """Stored fields of a finite-element answer; a half model is completed by its mirror image. An
    answer without a surface has the undeformed one, moved along with its rod.

    ``volumes_ml``: of the cavity at every path point [ml], as the answer's document has them.
    """
    arrays = unpack(artifact)
    fields, pressures = arrays.surface, arrays.pressures
    volumes = np.array([np.nan if v is None else v * 1e-6 for v in volumes_ml])
    if fields is None:
        return _rod_film(design, scene, arrays.centreline, pressures, volumes)
    vertices = fields.vertices.astype(np.float64)
    triangles = fields.triangles.astype(np.int64)
    mirrored = build_body(design).symmetric and bool(vertices[:, 1].min() > -1e-6)
    which = chosen_frames(len(pressures), _affordable(len(vertices) * (2 if mirrored else 1)))
    moved = fields.displacement[which].astype(np.float64)
    values: dict[Colour, np.ndarray] = {
        "displacement": np.linalg.norm(moved, axis=-1),
        "stretch": fields.stretch[which],
        "stress": fields.stress[which],
    }
    if fields.contact_pressure is not None:
        values["contact"] = fields.contact_pressure[which]
    if mirrored:
        flip = np.array([1.0, -1.0, 1.0])
        triangles = np.concatenate([triangles, triangles[:, ::-1] + len(vertices)])
        vertices = np.concatenate([vertices, vertices * flip])
        moved = np.concatenate([moved, moved * flip], axis=1)
        values = {name: np.concatenate([v, v], axis=1) for name, v in values.items()}
    body = skin(vertices, _outside(vertices, triangles))
    points = body.points + moved[:, body.source]
    values = {name: v[:, body.source] for name, v in values.items()}
    return Film(
        body, skin(vertices, triangles), points, values, pressures[which], volumes[which],
        scene.plate, scene.cylinder,
    )  # fmt: skip


def chosen_frames(found: int, most: int) -> np.ndarray:
    """Indices of at most ``most`` path points, first and last among them."""
    return np.unique(np.round(np.linspace(0, found - 1, min(found, most))).astype(int))


def _affordable(vertices: int) -> int:
    return int(np.clip(MOST_BYTES // (_BYTES_A_VERTEX * max(vertices, 1)), 5, MOST_FRAMES))


def _skins(design: Design) -> tuple[Skin, Skin]:
    """Outer skin to be swept, and the coarse skin with the cavity for the undeformed body."""
    return _skins_of(json.dumps(design.to_document()))


@lru_cache(maxsize=16)
def _skins_of(document: str) -> tuple[Skin, Skin]:
    body = build_body(parse_design(json.loads(document)))
    fine = body_surface(body, max_edge=edge_for(body, INSTANT_VERTICES))
    coarse = body_surface(body)
    return skin(fine.vertices, fine.triangles[~fine.cavity]), skin(
        coarse.vertices, coarse.triangles
    )


def _outside(vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Triangles without those around cavities, which nobody sees: closed parts of the surface whose
    volume is negative."""
    n = len(vertices)
    a, b = triangles[:, [0, 1]].ravel(), triangles[:, [1, 2]].ravel()
    graph = csr_array((np.ones(len(a), dtype=np.int8), (a, b)), shape=(n, n))
    _, part = connected_components(graph, directed=False)
    part = part[triangles[:, 0]]
    p, q, r = (vertices[triangles[:, k]] for k in range(3))
    volume = np.bincount(part, weights=(p * np.cross(q, r)).sum(axis=1))
    return triangles[volume[part] > 0]
