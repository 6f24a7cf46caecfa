"""One mesh of a body with its equations and their solver."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from actuators.materials import Material, NeoHooke
from actuators.mechanics.continuum.assembly import region_materials
from actuators.mechanics.continuum.contact.build import interactions
from actuators.mechanics.continuum.contact.interaction import Interaction
from actuators.mechanics.continuum.outer_loads import OuterLoads, outer_loads
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.continuum.weight import with_weight
from actuators.mechanics.direct_solver import SymmetricSolver, open_solver
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh


@dataclass(eq=False)
class Level:
    """What a mesh needs to be solved on."""

    system: ContinuumSystem
    solver: SymmetricSolver


def open_level(mesh: HexMesh, scene: Scene) -> Level:
    """Equations of ``scene`` on ``mesh``. What the scene switches off has no part in them: see
    :attr:`.effects.EffectPlan.applied`."""
    materials = region_materials(mesh)
    if scene.choice("hyperelasticity") == "off":
        materials = tuple(neo_hookean(m) for m in materials)
    system = ContinuumSystem(
        mesh, materials, free=clamped(mesh), outer_loads=_loads(mesh, materials, scene),
        interactions=_interactions(mesh, materials, scene),
    )  # fmt: skip
    return Level(system, open_solver(system.indptr, system.indices))


def neo_hookean(material: Material) -> Material:
    """The same initial constants with the neo-Hookean law: what is left of any law at small
    strain."""
    if material.law.code == NeoHooke.code and not any(material.law.coefficients[1:]):
        return material
    return replace(material, law=NeoHooke(material.shear_modulus))


def _loads(mesh: HexMesh, materials: Sequence[Material], scene: Scene) -> OuterLoads | None:
    loads = outer_loads(mesh, scene)
    if scene.gravity is None or not any(scene.gravity):
        return loads
    return with_weight(loads, mesh, materials, scene.gravity)


def _interactions(
    mesh: HexMesh, materials: Sequence[Material], scene: Scene
) -> tuple[Interaction, ...]:
    if not scene.has_obstacle and scene.self_contact == "off":
        return ()
    return interactions(mesh, materials, scene)


def condensed_size(mesh: HexMesh) -> int:
    """Unknowns of a mesh, those held included."""
    return 3 * (len(mesh.nodes) - len(mesh.elements))
