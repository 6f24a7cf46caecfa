"""The interactions that a scene asks for."""

from collections.abc import Sequence

import numpy as np

from actuators.errors import QuestionError
from actuators.materials import Material
from actuators.mechanics.continuum.contact.interaction import Interaction
from actuators.mechanics.continuum.contact.obstacle import Obstacle
from actuators.mechanics.continuum.contact.self_contact import SelfContact
from actuators.mechanics.continuum.contact.surface import contact_law, outside
from actuators.mechanics.obstacles import Cylinder
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh


def interactions(
    mesh: HexMesh, materials: Sequence[Material], scene: Scene
) -> tuple[Interaction, ...]:
    """Plate, cylinder, and the body against itself unless that is switched off."""
    surface, law = outside(mesh), contact_law(mesh, materials)
    obstacles = [
        Obstacle(surface, law, obstacle)
        for obstacle in (scene.plate, scene.cylinder)
        if obstacle is not None
    ]
    for obstacle in obstacles:
        _refuse_overlap(obstacle, mesh)
    if scene.self_contact == "off":
        return tuple(obstacles)
    height = float(np.ptp(mesh.nodes[:, 2]))
    return (*obstacles, SelfContact(surface, law, height))


def _refuse_overlap(obstacle: Obstacle, mesh: HexMesh) -> None:
    depth = -float(obstacle.gaps(mesh.nodes).min())
    if isinstance(obstacle.obstacle, Cylinder) and depth > 0.0:
        raise QuestionError(
            f"The cylinder reaches {depth * 1e3:.2g} mm into the undeformed body.",
            field="cylinder", value=f"{depth * 1e3:.2g} mm inside",
            mend="Move its centre away from the body, or make it thinner.",
        )  # fmt: skip
