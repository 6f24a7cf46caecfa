"""One mesh of a body with its equations and their solver."""

from dataclasses import dataclass

from actuators.mechanics.continuum.assembly import region_materials
from actuators.mechanics.continuum.contact.build import interactions
from actuators.mechanics.continuum.outer_loads import outer_loads
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.direct_solver import SymmetricSolver, open_solver
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh


@dataclass(eq=False)
class Level:
    """What a mesh needs to be solved on."""

    system: ContinuumSystem
    solver: SymmetricSolver


def open_level(mesh: HexMesh, scene: Scene) -> Level:
    """Equations of ``scene`` on ``mesh``."""
    materials = region_materials(mesh)
    system = ContinuumSystem(
        mesh, materials, free=clamped(mesh), gravity=scene.gravity,
        outer_loads=outer_loads(mesh, scene), interactions=interactions(mesh, materials, scene),
    )  # fmt: skip
    return Level(system, open_solver(system.indptr, system.indices))


def condensed_size(mesh: HexMesh) -> int:
    """Unknowns of a mesh, those held included."""
    return 3 * (len(mesh.nodes) - len(mesh.elements))
