"""Cook's membrane in plane strain: a tapered panel held at one side, sheared at the other.

Corners (0, 0), (48, 44), (48, 60), (0, 44) mm; 100 N per mm of thickness, upwards, spread evenly
over the side X1 = 48 mm as it was before loading.
"""

import numpy as np
import scipy.sparse.linalg as spla

from actuators.geometry import Body, Region
from actuators.materials import LinearElastic, NeoHooke
from actuators.mechanics.continuum.assembly import linear_system
from actuators.mechanics.continuum.system import ContinuumSystem
from actuators.meshing import HexMesh, mesh_body
from benchmarks.verification.statics import (
    dead_load,
    ramp,
    rubber,
    simpson_weights,
    solver_of,
)

MPa, mm = 1e6, 1e-3
BULK, SHEAR = 400942.0, 80.1938
"""K and G of the nearly incompressible case [MPa], as printed."""
LINEAR = LinearElastic(70.0 * MPa, 1 / 3)
TRACTION = 100.0 / 16.0
"""[MPa]"""
GRADING = 2.5
# ngsolve_cook.py: 603 triangles of order 4, 0.02 mm at the corners; 332 give 6.9312 and 32.2965
NEO_HOOKE_REFERENCE, LINEAR_REFERENCE = 6.9349, 32.3000


def _panel(parts: int) -> HexMesh:
    """Lines graded towards all four corners: two are singular, and at the loaded ones the stress
    depends on the direction from which it is looked at, so that the corner's own displacement is
    found with an error of the element's size."""

    def place(lattice: np.ndarray) -> np.ndarray:
        x, y, s = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
        low, high = 44.0 * x / 48.0, 44.0 + 16.0 * x / 48.0
        return np.stack([x, y, low + s * (high - low)], axis=-1) * mm

    even = np.linspace(0.0, 1.0, parts + 1)
    both = np.where(even < 0.5, (2 * even) ** GRADING / 2, 1 - (2 - 2 * even) ** GRADING / 2)
    body = Body(
        (48.0 * both, np.array([0.0, 1.0]), both),
        np.zeros((parts, 1, parts), dtype=np.int8), (Region("rubber", "test"),), place, False,
    )  # fmt: skip
    return mesh_body(body)


def _held(mesh: HexMesh) -> np.ndarray:
    free = np.ones_like(mesh.nodes, dtype=bool)
    free[:, 1] = False
    free[mesh.clamp_nodes] = False
    return free


def _shear(mesh: HexMesh, traction: float) -> np.ndarray:
    end = mesh.tip_nodes
    share = simpson_weights(mesh.node_index[end, 1], mesh.lines[1]) * simpson_weights(
        mesh.node_index[end, 2], mesh.lines[2]
    )
    forces = np.zeros_like(mesh.nodes)
    forces[end, 2] = traction * share * 16.0 * mm * mm  # the panel is 1 mm thick
    return forces


def _corner(mesh: HexMesh) -> int:
    end = mesh.tip_nodes
    top = mesh.node_index[end, 2] == 2 * (len(mesh.lines[2]) - 1)
    return int(end[top & (mesh.node_index[end, 1] == 0)][0])


def neo_hooke_corner(parts: int) -> float:
    """Upward displacement [mm] of the upper right corner."""
    mesh = _panel(parts)
    load = dead_load(_shear(mesh, TRACTION * MPa))
    material = rubber(NeoHooke(SHEAR * MPa), bulk_to_shear=BULK / SHEAR)
    system = ContinuumSystem(mesh, [material], free=_held(mesh), outer_loads=load)
    states = ramp(system, solver_of(system), [0.2, 0.4, 0.6, 0.8, 1.0])
    return float(states[-1].displacement[_corner(mesh), 2] / mm)


def linear_corner(parts: int) -> float:
    """The same [mm] at small strain with E = 70, nu = 1/3 (all in the units of the traction)."""
    mesh = _panel(parts)
    material = rubber(LINEAR, bulk_to_shear=LINEAR.bulk_to_shear)
    linear = linear_system(mesh, [material])
    free = _held(mesh)[linear.nodes].ravel()
    load = _shear(mesh, TRACTION * MPa)[linear.nodes].ravel()
    solution = np.zeros(len(load))
    stiffness = linear.stiffness[free][:, free].tocsc()
    solution[free] = spla.spsolve(stiffness, load[free])
    where = int(np.flatnonzero(linear.nodes == _corner(mesh))[0])
    return float(solution.reshape(-1, 3)[where, 2] / mm)
