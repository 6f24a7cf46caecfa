"""The body's own weight as dead forces at the nodes: they depend on the undeformed body only, and
are assembled once, where there is gravity."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from actuators.materials import Material
from actuators.mechanics.continuum.kernel.shape import CUBE_SLOPES, CUBE_VALUES, CUBE_WEIGHTS
from actuators.mechanics.continuum.outer_loads import OuterLoads, underside_faces
from actuators.meshing import HexMesh


def with_weight(
    loads: OuterLoads | None,
    mesh: HexMesh,
    materials: Sequence[Material],
    gravity: tuple[float, float, float],
) -> OuterLoads:
    """``loads`` and the weight under ``gravity`` [m/s2]."""
    if loads is None:
        loads = OuterLoads(np.zeros_like(mesh.nodes), underside_faces(mesh), 0.0)
    return replace(loads, force=loads.force + weight_forces(mesh, materials, gravity))


def weight_forces(
    mesh: HexMesh, materials: Sequence[Material], gravity: tuple[float, float, float]
) -> np.ndarray:
    """(n, 3) consistent nodal forces [N] of the body force density * gravity."""
    at = mesh.nodes[mesh.elements]
    jacobian = np.einsum("mni,gdn->mgid", at, CUBE_SLOPES)
    volume = np.linalg.det(jacobian) * CUBE_WEIGHTS
    density = np.array([material.density for material in materials])[mesh.region]
    mass = np.zeros(len(mesh.nodes))
    np.add.at(mass, mesh.elements, density[:, None] * (volume @ CUBE_VALUES))
    return np.outer(mass, gravity)
