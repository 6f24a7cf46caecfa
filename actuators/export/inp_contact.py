"""Contact in a deck: walls that face each other across the gaps of a body.

Face-to-face penalty contact without friction. Which faces can meet is read from the undeformed
body: the walls on either side of an open gap. A body that curls up until its bottom meets itself is
not covered.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree

from actuators.export.inp_lines import chosen_faces, middles, surface
from actuators.materials import Material
from actuators.mechanics.continuum.contact.build import expected_pressure
from actuators.mechanics.continuum.contact.surface import ContactLaw, contact_law
from actuators.mechanics.scene import Scene
from actuators.meshing import Faces, HexMesh

FACING = 0.5
"""Least part of a wall's normal along X1."""
NEAR = 0.5
"""Of the body's height: how far apart two walls may stand to be taken as facing."""
TENSION = 1e-8
"""Pull between surfaces far apart [MPa], which CalculiX asks for: negligible beside any load. With
this value its walls and ours agree (a test compares them)."""
TOUCH = "TOUCH"
"""The deck's one surface interaction."""
_MPA_PER_MM = 1e-9


@dataclass(frozen=True)
class WallPair:
    """Two walls across a gap: forward (normal towards +X1) and backward."""

    forward: Faces
    backward: Faces


def wall_pairs(mesh: HexMesh) -> tuple[WallPair, ...]:
    """Walls of the outside that face each other, gap by gap along X1."""
    faces = touchable(mesh)
    _, normal = middles(mesh, faces)
    forward = _walls(chosen_faces(faces, normal[:, 0] > FACING))
    backward = _walls(chosen_faces(faces, normal[:, 0] < -FACING))
    height = float(np.ptp(mesh.nodes[:, 2]))
    pairs: list[WallPair] = []
    for wall in forward:
        other = _ahead(mesh, wall, backward, NEAR * height)
        if other is not None:
            # walls that meet at the bottom of a gap: the faces at their joint cannot close
            shared = np.intersect1d(wall.nodes, other.nodes)
            free = WallPair(_without(wall, shared), _without(other, shared))
            if len(free.forward) and len(free.backward):
                pairs.append(free)
    return tuple(pairs)


def wall_cards(pairs: Sequence[WallPair]) -> list[str]:
    """Surfaces and contact pairs of facing walls."""
    lines: list[str] = []
    for number, pair in enumerate(pairs, 1):
        names = f"WALL_{number}_FORWARD", f"WALL_{number}_BACKWARD"
        lines += [*surface(names[0], pair.forward), *surface(names[1], pair.backward)]
        lines += contact_pair(*names)
    return lines


def deck_law(mesh: HexMesh, materials: Sequence[Material], scene: Scene) -> ContactLaw:
    """How hard surfaces are against each other in our own solver."""
    expected = expected_pressure(mesh, materials, scene)
    return contact_law(mesh, materials, expected or np.inf)


def interaction_cards(law: ContactLaw) -> list[str]:
    """The one interaction that all contact pairs of a deck share."""
    return [
        f"*SURFACE INTERACTION, NAME={TOUCH}",
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
        f"{law.stiffness * _MPA_PER_MM:.6e}, {TENSION:g}",
    ]


def contact_pair(slave: str, master: str) -> list[str]:
    """Two surfaces, by name, that :func:`interaction_cards` holds apart."""
    return [
        f"*CONTACT PAIR, INTERACTION={TOUCH}, TYPE=SURFACE TO SURFACE", f"{slave}, {master}",
    ]  # fmt: skip


def _without(faces: Faces, nodes: np.ndarray) -> Faces:
    """Those that have none of these nodes."""
    joined = np.asarray(np.isin(faces.nodes, nodes)).any(axis=1)
    return chosen_faces(faces, np.logical_not(joined))


def touchable(mesh: HexMesh) -> Faces:
    """All outer faces but those on the clamp."""
    clamp = np.zeros(len(mesh.nodes), dtype=bool)
    clamp[mesh.clamp_nodes] = True
    return chosen_faces(
        mesh.outer_faces, np.logical_not(np.all(clamp[mesh.outer_faces.nodes], axis=1))
    )


def _walls(faces: Faces) -> list[Faces]:
    """Faces that hang together by their nodes."""
    if not len(faces):
        return []
    nodes, place = np.unique(faces.nodes, return_inverse=True)
    row = np.repeat(np.arange(len(faces)), 9)
    belongs = coo_array((np.ones(row.size), (row, place.ravel())), (len(faces), len(nodes))).tocsr()
    count, label = connected_components(belongs @ belongs.T, directed=False)
    return [chosen_faces(faces, label == k) for k in range(count)]


def _ahead(mesh: HexMesh, wall: Faces, others: Sequence[Faces], reach: float) -> Faces | None:
    """The nearest wall in front of ``wall`` that most of it faces, or None."""
    middle, normal = middles(mesh, wall)
    best, nearest = None, reach
    for other in others:
        there, _ = middles(mesh, other)
        distance, which = KDTree(there).query(middle)
        front = np.einsum("fi,fi->f", there[which] - middle, normal) > 0
        if front.mean() > 0.5 and np.median(distance) < nearest:
            best, nearest = other, float(np.median(distance))
    return best
