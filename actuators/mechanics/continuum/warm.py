"""Compile every kernel and keep it on disk: ``python -m actuators.mechanics.continuum.warm``.

Part of setting up, so that no job waits for a compiler. Kernels older than the sources they were
made from are dropped first: numba itself notices a change only in the file of the outermost
function.
"""

import sys
import time
from pathlib import Path

import numpy as np

from actuators.geometry.body import CAVITY, OUTSIDE, Body, Region
from actuators.materials import Material, NeoHooke, Ogden
from actuators.mechanics.continuum import kernel
from actuators.mechanics.continuum.assembly import linear_system
from actuators.mechanics.continuum.contact.build import interactions
from actuators.mechanics.continuum.kernel.assemble import assemble
from actuators.mechanics.continuum.newton import Equilibrium, Target, solve_equilibrium
from actuators.mechanics.continuum.state import State
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.direct_solver import open_solver
from actuators.mechanics.scene import Plate, Scene
from actuators.meshing import mesh_body


def main() -> int:
    """Drop stale kernels, compile, and say how long it took."""
    start = time.perf_counter()
    dropped = drop_stale()
    exercise()
    seconds = time.perf_counter() - start
    compiled = "compiled" if seconds > 3 else "ready"
    print(f"finite-element kernels {compiled} in {seconds:.1f} s ({dropped} stale files dropped)")
    return 0


def drop_stale() -> int:
    """Remove cached kernels older than the newest source; returns how many files went."""
    folder = Path(kernel.__file__).parent
    newest = max(source.stat().st_mtime for source in folder.glob("*.py"))
    cache = Path(str(assemble.stats.cache_path))
    stale = [f for f in cache.glob("*.nb[ic]") if f.stat().st_mtime < newest]
    for file in stale:
        file.unlink(missing_ok=True)
    return len(stale)


def exercise() -> None:
    """Call every kernel once, with the types that jobs use, on a box with one chamber."""
    side = np.array([0.0, 1.0, 2.0, 3.0])
    fill = np.ones((3, 3, 3), dtype=np.int8)
    fill[1, 1, 1] = CAVITY
    fill[:, :, 0] = 0
    body = Body((side, side, side), fill, (Region("a", "a"), Region("b", "b")), lambda x: x, False)
    mesh = mesh_body(body)
    materials = [
        Material("a", "a", NeoHooke(1.0), 1.0, "exercise"),
        Material("b", "b", Ogden(((1.0, 2.0),), "classical"), 1.0, "exercise"),
    ]
    linear_system(mesh, materials)
    system = ContinuumSystem(mesh, materials, free=clamped(mesh), gravity=(0.0, 0.0, -1e-3))
    solver = open_solver(system.indptr, system.indices)
    for target in (Target(1e-3), Target(1e-3, volume=1.001)):
        found = solve_equilibrium(system, solver, system.rest(), target)
        if not isinstance(found, Equilibrium):
            raise RuntimeError(f"the kernels do not solve a small box: {found.reason}")
    exercise_contact(materials[0])


def exercise_contact(material: Material) -> None:
    """Two blocks that touch each other, pressed onto a plate."""
    side, height = np.array([0.0, 1.0]), np.array([0.0, 1.0, 1.0 + 1e-5, 2.0])
    fill = np.array([0, OUTSIDE, 0], dtype=np.int8).reshape(1, 1, 3)
    body = Body((side, side, height), fill, (Region("a", "a"),), lambda x: x, False)
    mesh = mesh_body(body)
    scene = Scene(pressure_to=1.0, plate=Plate(0.0))
    contacts = interactions(mesh, [material], scene)
    system = ContinuumSystem(mesh, [material], free=clamped(mesh), interactions=contacts)
    lower = State(np.tile([0.0, 0.0, -0.02], (len(mesh.nodes), 1)), system.rest().pressure)
    pressed = system.linearise(lower, 0.0)
    if not all(touch.points for touch in pressed.touches):
        raise RuntimeError("the kernels do not see two blocks touch")
    for contact in contacts:
        contact.contact_pressure(mesh.nodes)


if __name__ == "__main__":
    sys.exit(main())
