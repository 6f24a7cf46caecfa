"""Bodies to meshes: lattice boxes become 27-node hexahedra, numbered without loops."""

from collections.abc import Sequence

import numpy as np

from actuators.geometry.body import CAVITY, OUTSIDE, Body
from actuators.meshing.hex_mesh import FACE_NODES, Faces, HexMesh
from actuators.meshing.subdivision import subdivide

Parts = int | Sequence[int]


def mesh_body(
    body: Body,
    *,
    uniform: tuple[Parts, Parts, Parts] = (1, 1, 1),
    layers: tuple[int, int, int] = (0, 0, 0),
) -> HexMesh:
    """Mesh of a body, of its half (``body.half()``) or of a periodic cell.

    ``uniform``: equal parts per lattice interval, in each direction one number or one per
    interval. ``layers``: thin layers at the block borders, per direction; not at the free end, the
    outer sides, the middle plane of a half model or the ends of a periodic cell, where no edge
    concentrates strain.
    """
    is_half = bool(body.lines[1][0] == 0.0)
    graded_first = (body.period is None, False, False)
    lines = tuple(
        subdivide(
            body.lines[d], uniform=uniform[d], layers=layers[d],
            graded_first=graded_first[d], graded_last=False,
        )
        for d in range(3)
    )  # fmt: skip
    fill = _refine_fill(body, lines)
    box = np.argwhere(fill >= 0).astype(np.int32)
    elements, node_index = _number(box, fill.shape)
    faces = _classify_faces(fill, box, elements, is_half, body.period is not None)
    membrane_faces, membrane_stiffness = _membranes(body, lines[2], fill, box, elements)
    return HexMesh(
        nodes=body.place(_lattice_coordinates(lines, node_index)),
        elements=elements,
        region=fill[tuple(box.T)].astype(np.int32),
        regions=body.regions,
        lines=(lines[0], lines[1], lines[2]),
        box=box,
        node_index=node_index,
        cavity_faces=faces[0],
        outer_faces=faces[1],
        symmetry_faces=faces[2],
        is_half=is_half,
        period=body.period,
        membrane_faces=membrane_faces,
        membrane_stiffness=membrane_stiffness,
    )


def _refine_fill(body: Body, lines: Sequence[np.ndarray]) -> np.ndarray:
    fill = body.fill
    for d in range(3):
        middles = (lines[d][:-1] + lines[d][1:]) / 2
        fill = np.take(fill, np.searchsorted(body.lines[d], middles) - 1, axis=d)
    return fill


def _number(box: np.ndarray, shape: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray]:
    """Elements (m, 27) and the lattice index (n, 3) of each used node, X1 slowest."""
    local = np.arange(27)
    offset = np.stack([local % 3, local // 3 % 3, local // 9], axis=-1)
    at = 2 * box[:, None, :] + offset
    grid = tuple(2 * n + 1 for n in shape)
    flat = np.ravel_multi_index(tuple(np.moveaxis(at, -1, 0)), grid)
    used = np.zeros(np.prod(grid), dtype=bool)
    used[flat.ravel()] = True
    number = np.cumsum(used) - 1
    node_index = np.stack(np.unravel_index(np.flatnonzero(used), grid), axis=-1)
    return number[flat].astype(np.int32), node_index.astype(np.int32)


def _lattice_coordinates(lines: Sequence[np.ndarray], node_index: np.ndarray) -> np.ndarray:
    columns: list[np.ndarray] = []
    for d, line in enumerate(lines):
        with_middles = np.empty(2 * len(line) - 1)
        with_middles[::2] = line
        with_middles[1::2] = (line[:-1] + line[1:]) / 2
        columns.append(with_middles[node_index[:, d]])
    return np.stack(columns, axis=-1)


def _classify_faces(
    fill: np.ndarray, box: np.ndarray, elements: np.ndarray, is_half: bool, is_periodic: bool
) -> tuple[Faces, Faces, Faces]:
    """Cavity, outer and symmetry faces."""
    inside_only = OUTSIDE - 1  # borders that are no surface of the body: cell ends
    symmetry = OUTSIDE - 2
    padded = np.pad(fill.astype(np.int32), 1, constant_values=OUTSIDE)
    if is_periodic:
        padded[[0, -1]] = inside_only
    if is_half:
        padded[:, 0] = symmetry
    found: dict[int, list[tuple[np.ndarray, np.ndarray]]] = {CAVITY: [], OUTSIDE: [], symmetry: []}
    for local in range(6):
        step = np.zeros(3, dtype=int)
        step[local // 2] = 1 if local % 2 else -1
        neighbour = padded[tuple((box + 1 + step).T)]
        for kind, entries in found.items():
            element = np.flatnonzero(neighbour == kind)
            entries.append((element, np.full(len(element), local)))
    return (
        _faces(found[CAVITY], elements),
        _faces(found[OUTSIDE], elements),
        _faces(found[symmetry], elements),
    )


def _membranes(
    body: Body, heights: np.ndarray, fill: np.ndarray, box: np.ndarray, elements: np.ndarray
) -> tuple[Faces, np.ndarray]:
    """Faces on the body's sheets and the stiffness of each."""
    below = np.pad(fill, ((0, 0), (0, 0), (1, 0)), constant_values=OUTSIDE)[tuple(box.T)] >= 0
    entries: list[tuple[np.ndarray, np.ndarray]] = []
    stiffness: list[np.ndarray] = []
    for sheet in body.membranes:
        plane = int(np.argmin(np.abs(heights - sheet.plane)))
        under = np.flatnonzero(box[:, 2] == plane - 1)
        over = np.flatnonzero((box[:, 2] == plane) & ~below)
        entries += [(under, np.full(len(under), 5)), (over, np.full(len(over), 4))]
        stiffness.append(np.full(len(under) + len(over), sheet.stiffness))
    if not entries:
        return Faces.none(), np.empty(0)
    return _faces(entries, elements), np.concatenate(stiffness)


def _faces(entries: list[tuple[np.ndarray, np.ndarray]], elements: np.ndarray) -> Faces:
    element = np.concatenate([e for e, _ in entries])
    local = np.concatenate([side for _, side in entries])
    return Faces(
        element=element.astype(np.int32),
        local=local.astype(np.int32),
        nodes=np.take_along_axis(elements[element], FACE_NODES[local], axis=1),
    )
