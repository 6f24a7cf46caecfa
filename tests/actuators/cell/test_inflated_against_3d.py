"""The inflated cell against the middle of a long weightless actuator in 3D, on the same elements.

Between two sections one pitch apart the whole body is a screw motion: its angle and its advance
along its axis are compared, which do not depend on any reference line.
"""

import numpy as np
import pytest

from actuators.design import Design, preset
from actuators.geometry import build_body, build_cell
from actuators.materials import material
from actuators.mechanics.cell.helical.screw import screw
from actuators.mechanics.cell.inflated import CellPath, inflate_cell
from actuators.mechanics.cell.periodic import coarse_mesh
from actuators.mechanics.cell.row import pitch_starts
from actuators.mechanics.continuum.assembly import region_materials
from actuators.mechanics.continuum.contact.build import interactions
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.direct_solver import open_solver
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh, mesh_body

Screw = tuple[float, float]


def of_motion(rotation: np.ndarray, shift: np.ndarray) -> Screw:
    """Angle [rad] and advance along the axis [m]."""
    axis = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0],
                     rotation[1, 0] - rotation[0, 1]]) / 2  # fmt: skip
    sine = float(np.linalg.norm(axis))
    return float(np.arctan2(sine, (np.trace(rotation) - 1) / 2)), float(shift @ axis) / sine


def long_body(design: Design, pressure: float) -> tuple[HexMesh, np.ndarray]:
    """Mesh as fine as the cell's, and its node positions."""
    counts = coarse_mesh(build_cell(design, 0)).even
    body = build_body(design)
    if body.symmetric:
        body, across = body.half(), list(counts[1])
    else:
        across = [*counts[1][:0:-1], 2 * counts[1][0], *counts[1][1:]]
    mesh = mesh_body(body, uniform=(1, across, counts[2]))
    materials = region_materials(mesh)
    contact = interactions(mesh, materials, Scene(pressure_to=pressure, gravity=None))
    system = ContinuumSystem(mesh, materials, free=clamped(mesh), interactions=contact)
    path = PathFollower(system, open_solver(system.indptr, system.indices)).follow(
        pressure, [pressure]
    )
    return mesh, mesh.nodes + path.points[-1].state.displacement


def middle_screw(mesh: HexMesh, positions: np.ndarray, begin: float, pitch: float) -> Screw:
    """From the section x' = ``begin`` to the one a pitch further, by the best rigid fit."""
    line = mesh.lines[0]
    stations = np.sort(np.concatenate([line, (line[1:] + line[:-1]) / 2]))
    places: list[dict[tuple[int, ...], np.ndarray]] = []
    for x in (begin, begin + pitch):
        number = int(np.argmin(np.abs(stations - x)))
        assert abs(stations[number] - x) < 1e-9
        nodes = np.flatnonzero(mesh.node_index[:, 0] == number)
        index = mesh.node_index[nodes, 1:].tolist()
        places.append({tuple(at): positions[n] for at, n in zip(index, nodes, strict=True)})
    both = [at for at in places[0] if at in places[1]]
    a, b = (np.array([place[at] for at in both]) for place in places)
    if mesh.is_half:
        mirror = np.array([1.0, -1.0, 1.0])
        a, b = np.concatenate([a, a * mirror]), np.concatenate([b, b * mirror])
    u, _, vt = np.linalg.svd((b - b.mean(axis=0)).T @ (a - a.mean(axis=0)))
    rotation = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
    return of_motion(rotation, b.mean(axis=0) - rotation @ a.mean(axis=0))


def compare(design: Design, pressure: float) -> tuple[Screw, Screw, CellPath]:
    body = build_cell(design, 0)
    materials = tuple(material(region.material) for region in body.regions)
    found = inflate_cell(body, materials, pressure_to=pressure)
    motion = screw(found.strain[-1], found.period)
    start, pitch = pitch_starts(design)
    mesh, positions = long_body(design, pressure)
    there = middle_screw(mesh, positions, float(start[len(start) // 2]), pitch)
    return of_motion(motion.rotation, motion.shift), there, found


def test_a_slab_bends_as_in_3d_close_to_its_limit() -> None:
    """At 0.87 of its limit pressure; measured 0.03 %."""
    short = preset("slab-rectangle-low").design
    pitch = pitch_starts(short)[1]
    design = short.model_copy(
        update={"chamber_count": 9, "length": short.length + 3 * pitch}  # the same chambers
    )
    (angle, _), (there, _), _ = compare(design, 12e3)
    assert angle == pytest.approx(there, rel=2e-3)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["oblique-45", "oblique-90"])
def test_an_oblique_actuator_is_the_helix_of_3d(name: str) -> None:
    """At 20 kPa, neighbouring walls in contact; measured 0.016 %, and 0.006 % with seven chambers
    of oblique-90."""
    design = preset(name).design.model_copy(update={"chamber_count": 9})
    (angle, advance), (there, along), _ = compare(design, 20e3)
    assert angle == pytest.approx(there, rel=1e-3)
    assert abs(advance - along) < 1e-3 * pitch_starts(design)[1]
