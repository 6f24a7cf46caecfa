"""Rigid obstacles in a deck: solid elements with every node held, pressed on without friction.

Face-to-face penalty contact as stiff as our own law. A deck has no half spaces and no endless bars:
plate and cylinder reach as far as the body could, clamped as it is.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from actuators.export.inp_contact import contact_pair, touchable
from actuators.export.inp_lines import node_rows, rows, surface
from actuators.mechanics.continuum.contact.surface import ONSET
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh

REACH = 1.2
"""How far beyond the undeformed body obstacles go on, in the body's sizes."""
BESIDE = 0.5
"""How far beside a half model a bar across it goes on, in the half's widths."""
SECTORS = 24
"""Quadratic faces around a cylinder: an arc of 15 degrees is met to 1e-5 of the radius."""
LONGEST = 12.0
"""Length of a cylinder's faces along its axis over that around it."""
CORE = 0.5
"""Inner radius of the cylinder's ring of elements over its outer one."""
BODY = "BODY_OUTSIDE"


@dataclass(frozen=True, eq=False)
class RigidSolid:
    """``nodes`` (n, 3) [m]; ``elements`` (m, 8 or 20) indices of them in Abaqus's order; ``side``
    of each element that the body meets, by Abaqus's number; ``facing`` nodes of these sides."""

    name: str
    nodes: np.ndarray
    elements: np.ndarray
    side: int
    facing: np.ndarray


def rigid_solids(mesh: HexMesh, scene: Scene) -> tuple[RigidSolid, ...]:
    """Plate and cylinder of a scene."""
    out = [_plate(mesh, scene.plate)] if scene.plate is not None else []
    return (*out, _cylinder(mesh, scene.cylinder)) if scene.cylinder is not None else tuple(out)


def obstacle_cards(
    mesh: HexMesh, solids: Sequence[RigidSolid], first_node: int, first_element: int
) -> list[str]:
    """Nodes, elements, surfaces and contact pairs, numbered from the two numbers on. The
    interaction itself is :func:`.inp_contact.interaction_cards`."""
    if not solids:
        return []
    lines = [
        "** rigid obstacles: solid elements with every node held, their material of no account",
        "*MATERIAL, NAME=M-HELD", "*ELASTIC", "210000., 0.3",
        *surface(BODY, touchable(mesh)),
    ]  # fmt: skip
    node, element = first_node, first_element
    for solid in solids:
        every, sides = f"{solid.name}_NODES", f"{solid.name}_SURFACE"
        kind = "C3D8" if solid.elements.shape[1] == 8 else "C3D20R"
        lines += [f"*NODE, NSET={every}"]
        lines += node_rows(range(node, node + len(solid.nodes)), solid.nodes)
        lines += [f"*NSET, NSET={force_set(solid)}", *rows(solid.facing + node, 16)]
        lines += [f"*ELEMENT, TYPE={kind}, ELSET={solid.name}"]
        for number, own in enumerate(solid.elements, element):
            lines += rows([number, *(own + node)], 16)
        lines += [f"*SOLID SECTION, ELSET={solid.name}, MATERIAL=M-HELD"]
        lines += ["*BOUNDARY", f"{every}, 1, 3"]
        last = element + len(solid.elements)
        lines += [f"*SURFACE, NAME={sides}, TYPE=ELEMENT"]
        lines += [f"{number}, S{solid.side}" for number in range(element, last)]
        lines += contact_pair(BODY, sides)
        node, element = node + len(solid.nodes), last
    return lines


def force_requests(solids: Sequence[RigidSolid]) -> list[str]:
    """Lines of a step that print the force on each obstacle, as the sum over its nodes."""
    return [
        line
        for solid in solids
        for line in (f"*NODE PRINT, NSET={force_set(solid)}, TOTALS=YES", "RF")
    ]


def force_set(solid: RigidSolid) -> str:
    """The set of nodes whose reactions are the force on an obstacle."""
    return f"{solid.name}_FACE"


def _plate(mesh: HexMesh, plate: Plate) -> RigidSolid:
    """One block below the plane."""
    size = float(np.ptp(mesh.nodes, axis=0).max())
    normal = np.array(plate.normal)
    along, across = _beside(normal)
    # as in our solver, where contact begins at its onset
    height = float((mesh.nodes @ normal).min()) - max(plate.gap, ONSET * size)
    middle = 0.5 * (mesh.nodes.min(axis=0) + mesh.nodes.max(axis=0))
    middle = middle + (height - float(middle @ normal)) * normal
    wide = (0.5 + REACH) * size
    corners = np.array(
        [
            middle + wide * (a * along + b * across) - deep * size * normal
            for deep in (0.5, 0.0)
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
        ]
    )
    return RigidSolid("PLATE", corners, np.arange(8)[None], 2, np.arange(4, 8))


def _cylinder(mesh: HexMesh, cylinder: Cylinder) -> RigidSolid:
    """A ring of quadratic bricks around the axis."""
    axis, centre = np.array(cylinder.axis), np.array(cylinder.centre)
    along, across = _beside(axis)
    low, high = _span(mesh, axis, centre)
    around = 2 * np.pi * cylinder.radius / SECTORS
    parts = max(2, int(np.ceil((high - low) / (LONGEST * around))))
    angle = np.arange(2 * SECTORS) * np.pi / SECTORS
    ring = np.cos(angle)[:, None] * along + np.sin(angle)[:, None] * across
    radii = cylinder.radius * np.linspace(CORE, 1.0, 3)
    heights = np.linspace(low, high, 2 * parts + 1)
    # node (h, a, r): height, angle, radius
    places = (
        centre
        + heights[:, None, None, None] * axis
        + radii[None, None, :, None] * ring[None, :, None, :]
    )
    number = np.arange(places[..., 0].size).reshape(places.shape[:3])
    h, a = (grid.ravel() for grid in np.meshgrid(
        2 * np.arange(parts), 2 * np.arange(SECTORS), indexing="ij"))  # fmt: skip

    def at(r: int, turn: int, up: int) -> np.ndarray:
        return number[h + up, (a + turn) % (2 * SECTORS), r]

    # Abaqus's order: corners below and above, middles below, above and between
    local = ((0, 0), (2, 0), (2, 2), (0, 2))
    middles = ((1, 0), (2, 1), (1, 2), (0, 1))
    order = [(r, t, 0) for r, t in local] + [(r, t, 2) for r, t in local]
    order += [(r, t, 0) for r, t in middles] + [(r, t, 2) for r, t in middles]
    order += [(r, t, 1) for r, t in local]
    elements = np.stack([at(*place) for place in order], axis=1)
    used, packed = np.unique(elements, return_inverse=True)
    packed = packed.reshape(elements.shape)
    outer = np.unique(packed[:, [1, 2, 5, 6, 9, 13, 17, 18]])
    # side 4 holds the corners 2, 3, 7, 6: those of the outer radius
    return RigidSolid("CYLINDER", places.reshape(-1, 3)[used], packed, 4, outer)


def _span(mesh: HexMesh, axis: np.ndarray, centre: np.ndarray) -> tuple[float, float]:
    """Ends of a bar along its axis, from its centre [m]."""
    at = (mesh.nodes - centre) @ axis
    beyond = REACH * float(np.ptp(mesh.nodes, axis=0).max())
    if mesh.is_half and abs(axis[1]) == 1.0:
        beyond = BESIDE * float(np.ptp(at))
    return float(at.min()) - beyond, float(at.max()) + beyond


def _beside(direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Two unit vectors that are right-handed with ``direction`` as the third."""
    other = np.eye(3)[int(np.argmin(np.abs(direction)))]
    along = np.cross(other, direction)
    along /= np.linalg.norm(along)
    return along, np.cross(direction, along)
