"""The part of a pitch that is computed, and whose image every node of its mesh is.

The half X2 >= 0 of one pitch, as the linear cell takes it (:mod:`..lattice`), about the chamber's
vertical middle axis. Half a turn h about that axis leaves the chamber unchanged, oblique ones too,
and so does h after a whole pitch g about the axis midway to the next chamber. Each mesh node is
the image of a *site* under one of a few motions (:class:`Image`), which depend on the rod strains.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import IntEnum

import numpy as np

from actuators.geometry import CAVITY, OUTSIDE, Body
from actuators.mechanics.cell.helical.screw import Motion, screw
from actuators.mechanics.cell.lattice import divide, intervals
from actuators.mechanics.cell.periodic import CellMesh
from actuators.meshing import FACE_NODES, Faces, HexMesh, mesh_body

HALF_TURN: np.ndarray = np.diag([-1.0, -1.0, 1.0])
"""About the vertical axis."""


class Image(IntEnum):
    """How a node follows from its site: half-turned, carried on by the screw motion of a pitch, or
    told in the frame midway between two chambers (there the site's place is (0, 0, height))."""

    ITSELF = 0
    TURNED = 1
    CARRIED = 2
    TURNED_AND_CARRIED = 3
    MIDWAY = 4
    MIDWAY_BEFORE = 5


@dataclass(frozen=True, eq=False)
class Domain:
    """Mesh and ties of half a pitch.

    ``mesh``: nodes about the chamber's middle axis; its cavity and outer faces include those whose
    air lies in the next pitch. ``site``: (n,) site of each node; ``image``: (n,) :class:`Image`
    values; ``place``: (s, 3) undeformed position of the sites [m]; ``on_axis``: (s,) sites on one
    of the two axes of symmetry; ``air``: (nx, ny, nz) mask of air under pressure; ``middle``:
    lattice index along X1 of the plane midway between two chambers; ``lowest``: sites on that
    plane's axis from the underside on, (2,); ``period`` [m].
    """

    mesh: HexMesh
    site: np.ndarray
    image: np.ndarray
    place: np.ndarray
    on_axis: np.ndarray
    air: np.ndarray
    middle: int
    lowest: np.ndarray
    period: float

    def motions(self, strain: np.ndarray) -> tuple[Motion, ...]:
        """Of every :class:`Image`, at rod strains (4,)."""
        return _motions(strain, self.period)


def carried(
    place: np.ndarray, site: np.ndarray, image: np.ndarray, motions: Sequence[Motion]
) -> np.ndarray:
    """(n, 3) where nodes with these sites and images are, sites at ``place`` (s, 3)."""
    at = place[site]
    for kind in list(Image)[1:]:
        mine = np.flatnonzero(image == kind)
        at[mine] = at[mine] @ motions[kind].rotation.T + motions[kind].shift
    return at


def _motions(strain: np.ndarray, period: float) -> tuple[Motion, ...]:
    pitch, still = screw(strain, period), screw(np.zeros(4), 0.0)
    return (
        still, still.before(HALF_TURN), pitch, pitch.before(HALF_TURN),
        screw(strain, period / 2), screw(strain, -period / 2),
    )  # fmt: skip


def half_pitch(body: Body, mesh: CellMesh) -> Domain:
    """The domain of the periodic cell ``body``."""
    assert body.period is not None
    x, y, z, fill = intervals(body)
    counts = mesh.even
    half = replace(body, lines=(x, y, z), fill=fill, symmetric=False)
    made = mesh_body(half, uniform=(counts[0], counts[1], counts[2]))
    origin = body.place(np.array([(body.lines[0][0] + body.lines[0][-1]) / 2, 0.0, 0.0]))
    nodes = made.nodes - origin * [1, 1, 0]
    made = replace(made, nodes=nodes)
    equal = [[[1 / n] * n for n in axis] for axis in counts]
    shape = tuple(
        len(divide(line, parts)) - 1 for line, parts in zip((x, y, z), equal, strict=True)
    )
    for axis in range(3):
        fill = np.repeat(fill, counts[axis], axis=axis)
    assert fill.shape == shape
    nx = shape[0]
    turn = nx if body.curved else nx - counts[0][-1]
    middle = turn + nx
    made = replace(
        made,
        cavity_faces=_with_wrapped(made, made.cavity_faces, fill == CAVITY),
        outer_faces=_with_wrapped(made, made.outer_faces, fill == OUTSIDE),
    )
    site_key, image = _ties(made.node_index, shape, turn)
    keys, site = np.unique(site_key, return_inverse=True)
    place = np.empty((len(keys), 3))
    for kind, motion in zip(Image, _motions(np.zeros(4), body.period), strict=True):
        mine = image == kind
        place[site[mine]] = (nodes[mine] - motion.shift) @ motion.rotation
    i, j, k = np.unravel_index(keys, _site_shape(shape))
    on_axis = (j == 0) & ((i == turn) | (i == middle % (2 * nx)))
    midway = np.flatnonzero((j == 0) & (i == middle % (2 * nx)))
    lowest = midway[np.argsort(k[midway])][:2]
    return Domain(
        mesh=made, site=site.astype(np.int32), image=image, place=place, on_axis=on_axis,
        air=fill == CAVITY, middle=middle, lowest=lowest, period=body.period,
    )  # fmt: skip


def _site_shape(shape: tuple[int, ...]) -> tuple[int, int, int]:
    return 2 * shape[0], 2 * shape[1] + 1, 2 * shape[2] + 1


def _ties(index: np.ndarray, shape: tuple[int, ...], turn: int) -> tuple[np.ndarray, np.ndarray]:
    """Site (flat lattice number) and image of nodes at lattice ``index`` (n, 3)."""
    period = 2 * shape[0]
    i, j, k = (index[:, d].astype(np.int64) for d in range(3))
    middle = turn + shape[0]
    image = np.full(len(index), Image.ITSELF, dtype=np.int64)
    image[i == period] = Image.CARRIED
    at = i % period
    low = j == 0
    before = low & (i < turn)
    image[before] = Image.TURNED
    at = np.where(before, 2 * turn - i, at)
    after = low & (i > middle)
    image[after] = Image.TURNED_AND_CARRIED
    at = np.where(after, 2 * turn + period - i, at)
    image[low & (i == middle)] = Image.MIDWAY
    image[low & (i == middle - period)] = Image.MIDWAY_BEFORE
    at = np.where(low & (i % period == middle % period), middle % period, at)
    image[low & (i == turn)] = Image.ITSELF
    return np.ravel_multi_index((at % period, j, k), _site_shape(shape)), image


def _with_wrapped(mesh: HexMesh, found: Faces, air: np.ndarray) -> Faces:
    """The faces ``found``, and those on the mesh's two ends that face ``air`` (nx, ny, nz) of the
    next pitch."""
    last = air.shape[0] - 1
    element, local = [found.element], [found.local]
    for side, layer, beyond in ((0, 0, last), (1, last, 0)):
        there = np.flatnonzero(mesh.box[:, 0] == layer)
        there = there[air[beyond, mesh.box[there, 1], mesh.box[there, 2]]]
        element.append(there.astype(np.int32))
        local.append(np.full(len(there), side, dtype=np.int32))
    elements, sides = np.concatenate(element), np.concatenate(local)
    nodes = np.take_along_axis(mesh.elements[elements], FACE_NODES[sides], axis=1)
    return Faces(element=elements, local=sides, nodes=nodes)
