"""Small bodies and systems that the tests of the continuum engine share."""

from collections.abc import Callable

import numpy as np

from actuators.geometry import CAVITY, Body, Region
from actuators.materials import HyperelasticLaw, Material, MooneyRivlin, NeoHooke, Ogden, Yeoh
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.direct_solver import SymmetricSolver, open_solver
from actuators.meshing import HexMesh, mesh_body

LAWS: dict[str, HyperelasticLaw] = {
    "neo-hooke": NeoHooke(0.4e5),
    "yeoh": Yeoh(2e4, 3e3, -40.0),
    "mooney-rivlin-2": MooneyRivlin(1.5e4, 0.5e4),
    "mooney-rivlin-5": MooneyRivlin(-0.233e6, 2.562e6, 0.116e6, -0.561e6, 0.900e6),
    "ogden-2": Ogden(((6e4, 1.3), (-2e4, -2.0)), "classical"),
    "ogden-tiny-exponent": Ogden(((0.13e6, 3.05), (-1214e6, -0.0054)), "work-conjugate"),
}


def rubber(law: HyperelasticLaw, *, density: float = 1000.0) -> Material:
    return Material("test", "test", law, density, "test")


def block(place: Callable[[np.ndarray], np.ndarray] | None = None, *, cavity: bool = True) -> Body:
    """3 x 3 x 3 boxes of 4 mm, hollow in the middle, mapped by ``place``."""
    line = np.array([0.0, 4.0, 8.0, 12.0]) * 1e-3
    fill = np.zeros((3, 3, 3), dtype=np.int8)
    if cavity:
        fill[1, 1, 1] = CAVITY
    return Body(
        (line, line - 6e-3, line), fill, (Region("rubber", "test"),),
        place or (lambda lattice: np.array(lattice, dtype=float)), False,
    )  # fmt: skip


def skewed(lattice: np.ndarray) -> np.ndarray:
    """A map without symmetry, so that nothing vanishes by accident."""
    x, y, z = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
    return np.stack([x + 0.2 * y + 9.0 * z * y, y + 0.1 * z, z + 0.15 * x + 12.0 * x * y], axis=-1)


def system_of(
    mesh: HexMesh, law: HyperelasticLaw, *, gravity: tuple[float, float, float] | None = None
) -> tuple[ContinuumSystem, SymmetricSolver]:
    materials = [rubber(law)] * len(mesh.regions)
    system = ContinuumSystem(mesh, materials, free=clamped(mesh), gravity=gravity)
    return system, open_solver(system.indptr, system.indices)


def skewed_mesh() -> HexMesh:
    return mesh_body(block(skewed))
