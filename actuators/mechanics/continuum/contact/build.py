"""The interactions that a scene asks for."""

import math
from collections.abc import Sequence

import numpy as np

from actuators.errors import QuestionError
from actuators.materials import Material
from actuators.mechanics.continuum.contact.interaction import Interaction
from actuators.mechanics.continuum.contact.obstacle import Obstacle
from actuators.mechanics.continuum.contact.points import (
    OBSTACLE_POINTS,
    WALL_POINTS,
    FacePoints,
    even_points,
)  # fmt: skip
from actuators.mechanics.continuum.contact.self_contact import SelfContact
from actuators.mechanics.continuum.contact.surface import (
    ContactLaw,
    contact_law,
    inside,
    outside,
)
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh

CONCENTRATED = 6.0
"""Contact pressure over the loads', counted amply: 2 to 4 where walls meet, measured."""
SLIPS = 1e-3
"""How far [body sizes] a cylinder may enter between two points where it is looked for."""
DIVISIONS = (4, 8, 16, 32)
"""Of a face's sides."""


def interactions(
    mesh: HexMesh, materials: Sequence[Material], scene: Scene
) -> tuple[Interaction, ...]:
    """Plate, cylinder, and the body against itself, outside and in the cavity, unless that is
    switched off."""
    law = contact_law(mesh, materials, expected_pressure(mesh, materials, scene))
    rigid = obstacles(mesh, law, scene)
    if scene.self_contact == "off":
        return rigid
    height = float(np.ptp(mesh.nodes[:, 2]))
    outer = SelfContact(outside(mesh, WALL_POINTS), law, height)
    if not len(mesh.cavity_faces.nodes):
        return (*rigid, outer)
    return (*rigid, SelfContact(inside(mesh), law, height, within=True), outer)


def obstacles(mesh: HexMesh, law: ContactLaw, scene: Scene) -> tuple[Obstacle, ...]:
    """Plate and cylinder of a scene. Raises :class:`QuestionError` for a cylinder inside the
    undeformed body."""
    found = tuple(
        Obstacle(outside(mesh, _points(mesh, obstacle)), law, obstacle)
        for obstacle in (scene.plate, scene.cylinder)
        if obstacle is not None
    )
    for obstacle in found:
        _refuse_overlap(obstacle, mesh)
    return found


def _points(mesh: HexMesh, obstacle: Plate | Cylinder) -> FacePoints:
    """Where an obstacle is looked for on every face: in as many places as it takes for a cylinder
    not to enter between two of them by more than :data:`SLIPS` of the body's size."""
    if isinstance(obstacle, Plate):
        return OBSTACLE_POINTS
    patch = mesh.nodes[mesh.outer_faces.nodes]
    axis = np.array(obstacle.axis)
    extent = np.ptp(patch - (patch @ axis)[..., None] * axis, axis=1)
    side = float(np.linalg.norm(extent, axis=1).max())
    size = float(np.ptp(mesh.nodes, axis=0).max())
    apart = math.sqrt(8 * obstacle.radius * SLIPS * size)
    return next(
        (even_points(n) for n in DIVISIONS if side / n <= apart), even_points(DIVISIONS[-1])
    )


def holds_cavity(contacts: Sequence[Interaction]) -> bool:
    """Whether walls of the cavity press on each other where they meet."""
    return any(isinstance(each, SelfContact) and each.within for each in contacts)


def expected_pressure(mesh: HexMesh, materials: Sequence[Material], scene: Scene) -> float:
    """Contact pressure [Pa] that the loads can make: some times the pressures, weight and force on
    the body's section; infinite where the loads do not bound it."""
    if scene.pressure_to is None:
        return math.inf
    length, _, height = np.ptp(mesh.nodes, axis=0)
    weight = max(m.density for m in materials) * math.hypot(*(scene.gravity or (0.0,))) * length
    force = math.hypot(*(scene.tip_force or (0.0,))) / height**2
    return CONCENTRATED * (abs(scene.pressure_to) + abs(scene.outside_pressure) + weight + force)


def _refuse_overlap(obstacle: Obstacle, mesh: HexMesh) -> None:
    depth = -float(obstacle.gaps(mesh.nodes).min())
    if isinstance(obstacle.obstacle, Cylinder) and depth > 0.0:
        raise QuestionError(
            f"The cylinder reaches {depth * 1e3:.2g} mm into the undeformed body.",
            field="cylinder", value=f"{depth * 1e3:.2g} mm inside",
            mend="Move its centre away from the body, or make it thinner.",
        )  # fmt: skip
