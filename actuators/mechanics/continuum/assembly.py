"""The linear operator of an undeformed mesh, for those who solve with their own conditions."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

from actuators.materials import Material, material
from actuators.mechanics.continuum.kernel.cavity import face_traction
from actuators.mechanics.continuum.system import ContinuumSystem
from actuators.mechanics.direct_solver import open_solver
from actuators.meshing import HexMesh


@dataclass(frozen=True, eq=False)
class LinearSystem:
    """Small-strain equations K u = p f of a mesh on which nothing is held yet.

    ``stiffness``: (3 k, 3 k) csr, symmetric, both triangles [N/m]; six rigid motions are its null
    space. ``pressure_load``: (3 k,) forces for a cavity pressure of 1 Pa [m2]: the integral of
    N n over the cavity faces that the mesh has (the open ends of a periodic cell's channel carry
    none). Row 3 a + i belongs to component i of mesh node ``nodes[a]``; the nodes inside elements
    and the element pressures are condensed out.
    """

    stiffness: sp.csr_matrix
    pressure_load: np.ndarray
    nodes: np.ndarray

    def motions(self, held: np.ndarray, loads: np.ndarray) -> np.ndarray:
        """(k, 3, m) displacements [m] under ``loads`` (3 k, m) [N] where ``held`` (k, 3) components
        stay; raises FactorizationError where that leaves a rigid motion."""
        free = np.flatnonzero(~held.ravel())
        matrix = sp.csr_matrix(sp.triu(self.stiffness[free][:, free]))
        matrix.sort_indices()
        solver = open_solver(matrix.indptr, matrix.indices)
        solver.factorize(matrix.data)
        motion = np.zeros_like(loads)
        motion[free] = solver.solve(loads[free])
        return motion.reshape(-1, 3, loads.shape[1])


def region_materials(mesh: HexMesh) -> tuple[Material, ...]:
    """Catalogue records of the mesh's regions."""
    return tuple(material(region.material) for region in mesh.regions)


def linear_system(mesh: HexMesh, materials: Sequence[Material] | None = None) -> LinearSystem:
    """Stiffness and pressure load at rest; ``materials`` one per region, or the catalogue's."""
    free = np.ones((len(mesh.nodes), 3), dtype=bool)
    system = ContinuumSystem(mesh, materials or region_materials(mesh), free=free)
    system.linearise(system.rest(), 0.0)
    upper = sp.csr_matrix(
        (system.values, system.indices, system.indptr), shape=(system.unknowns,) * 2
    )
    load = np.zeros_like(mesh.nodes)
    face_traction(mesh.nodes, mesh.cavity_faces.nodes, load)
    kept = np.ones(len(mesh.nodes), dtype=bool)
    kept[mesh.centre_nodes] = False
    nodes = np.flatnonzero(kept)
    # a pressure pushes along the normal that points into the rubber, against the faces' own
    return LinearSystem(sp.csr_matrix(upper + sp.triu(upper, 1).T), -load[nodes].ravel(), nodes)
