"""Rigid plate and cylinder: Hertz' contact, force balance, no contact where nothing is near."""

import numpy as np
import pytest
import scipy.sparse as sp

from actuators.mechanics.continuum.contact import Obstacle, Tangent, contact_law, outside
from actuators.mechanics.continuum.contact.build import obstacles
from actuators.mechanics.continuum.contact.surface import TOLERANCE, ContactSurface
from actuators.mechanics.continuum.system import ContinuumSystem
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh, mesh_body
from tests.actuators.contact.pressed import MU, RUBBER, Place, box, press, reaction, straight

WIDE, HIGH, THICK, RADIUS = 24e-3, 12e-3, 1e-3, 20e-3


def underside(mesh: HexMesh) -> ContactSurface:
    """Without the sides, whose lower edges carry a share of their own where they touch."""
    surface = outside(mesh)
    kept = np.isin(surface.faces, mesh.on_first_plane(2)).all(axis=1)
    return ContactSurface(surface.nodes, surface.faces[kept], surface.areas[kept], surface.points)


def pressed_in_plane_strain(mesh: HexMesh, obstacle: Plate | Cylinder, depth: float):
    """Push the block's far side by ``depth`` towards the obstacle below it. Its sides are planes of
    symmetry, no outside that could press with its lower edge."""
    surface = underside(mesh)
    contact = Obstacle(surface, contact_law(mesh, [RUBBER]), obstacle)
    free = np.ones((len(mesh.nodes), 3), dtype=bool)
    free[:, 1] = False
    top = mesh.on_last_plane(2)
    free[top] = False
    moved = np.zeros_like(mesh.nodes)
    moved[top, 2] = -depth
    system, state = press(mesh, free, moved, [contact], steps=2)
    return contact, mesh.nodes + state.displacement, reaction(system, state, top)


def fine_below(place: Place = straight) -> HexMesh:
    """A block with small elements at the middle of its underside."""
    lines = [0.0, 8e-3, 10e-3, 14e-3, 16e-3, WIDE]
    body = box((WIDE, THICK, HIGH), place)
    body = type(body)(
        (np.array(lines), body.lines[1], np.array([0.0, 2e-3, 5e-3, HIGH])),
        np.zeros((5, 1, 3), np.int8), body.regions, body.place, False,
    )  # fmt: skip
    return mesh_body(body, uniform=((2, 2, 16, 2, 2), 1, (6, 3, 2)))


def bulging(lattice: np.ndarray) -> np.ndarray:
    """Underside of radius RADIUS, lowest in the middle."""
    x, y, z = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
    sag = RADIUS - np.sqrt(RADIUS**2 - (x - WIDE / 2) ** 2)
    return np.stack([x, y, z + sag * (1 - z / HIGH)], axis=-1)


@pytest.mark.parametrize("shape", ["round block on a plate", "block on a cylinder"])
def test_line_contact_is_that_of_hertz(shape: str) -> None:
    if shape == "block on a cylinder":
        mesh = fine_below()
        obstacle = Cylinder(RADIUS, (WIDE / 2, 0.0, -RADIUS - 1e-6), (0.0, 1.0, 0.0))
    else:
        mesh, obstacle = fine_below(bulging), Plate(1e-6)
    contact, positions, pushed = pressed_in_plane_strain(mesh, obstacle, 0.12e-3)
    force = contact.force(positions)
    assert force == pytest.approx(pushed, abs=1e-5 * np.abs(force).max())
    line_load = -force[2] / THICK
    # Johnson, Contact Mechanics, eq. 4.45: p0^2 = P' E* / (pi R), E* = E / (1 - nu^2) = 4 mu
    expected = np.sqrt(line_load * 4 * MU / (np.pi * RADIUS))
    half_width = np.sqrt(4 * line_load * RADIUS / (np.pi * 4 * MU))
    assert 1e-3 < half_width < 2e-3
    assert contact.largest_pressure(positions) == pytest.approx(expected, rel=0.03)
    assert contact.gaps(positions).min() > -1e-4 * WIDE


def test_an_obstacle_out_of_reach_changes_nothing() -> None:
    mesh = mesh_body(box((10e-3, 10e-3, 10e-3)))
    contact = Obstacle(outside(mesh), contact_law(mesh, [RUBBER]), Plate(5e-3))
    residual = np.zeros_like(mesh.nodes)
    assert contact.add(mesh.nodes, residual, None).points == b""
    assert not residual.any()
    assert contact.contact_pressure(mesh.nodes).max() == 0.0


@pytest.mark.parametrize("obstacle", [Plate(0.0), Plate(1e-7), Cylinder(5e-3, (5e-3, 0.0, -5e-3))])
def test_what_only_touches_is_not_pressed(obstacle: Plate | Cylinder) -> None:
    """Contact pressure begins at its onset above a surface: not for a body that rests on it."""
    mesh = mesh_body(box((10e-3, 10e-3, 10e-3)))
    contact = Obstacle(outside(mesh), contact_law(mesh, [RUBBER]), obstacle)
    assert np.abs(contact.force(mesh.nodes)).max() < 1e-12
    assert contact.force(mesh.nodes - [0.0, 0.0, 1e-6])[2] < 0.0


def test_a_needle_between_the_points_of_contact_is_seen() -> None:
    mesh = mesh_body(box((10e-3, 10e-3, 10e-3)))
    contact = Obstacle(outside(mesh), contact_law(mesh, [RUBBER]), Cylinder(3e-4, (3e-3, 0, -1e-3)))
    sunk = mesh.nodes - [0.0, 0.0, 0.9e-3]
    assert contact.gaps(sunk).min() > 0.0  # no point of contact lies in it
    assert 1e-4 < contact.depth(sunk) <= 2e-4  # its top lies 0.2 mm inside


@pytest.mark.parametrize("radius", [1e-4, 3e-4, 1e-3])
def test_a_needle_of_a_scene_is_pressed_wherever_it_lies(radius: float) -> None:
    """As many points as it takes: between them it may enter by a thousandth of the body."""
    mesh = mesh_body(box((10e-3, 10e-3, 10e-3)), uniform=(4, 4, 1))
    law = contact_law(mesh, [RUBBER])
    for place in np.linspace(3e-3, 4e-3, 7):
        scene = Scene(1e3, cylinder=Cylinder(radius, (place, 0, -radius - 1e-4)))
        (needle,) = obstacles(mesh, law, scene)
        assert needle.force(mesh.nodes - [0.0, 0.0, 1.2e-4])[2] < 0.0
        assert np.abs(needle.force(mesh.nodes)).max() < 1e-12


def test_uniform_pressure_at_the_nodes() -> None:
    mesh = mesh_body(box((10e-3, 10e-3, 10e-3)), uniform=(3, 2, 2))
    law = contact_law(mesh, [RUBBER])
    contact = Obstacle(underside(mesh), law, Plate(0.0))
    sunk = mesh.nodes - [0.0, 0.0, 3 * law.onset]  # contact begins with the first
    pressure = contact.contact_pressure(sunk)
    below = np.isclose(mesh.nodes[:, 2], 0.0) & (mesh.nodes[:, 0] > 0)
    inside = below & (mesh.nodes[:, 0] < 10e-3) & (abs(mesh.nodes[:, 1]) < 4.9e-3)
    assert pressure[inside] == pytest.approx(2 * law.onset * law.stiffness)
    assert contact.force(sunk)[2] == pytest.approx(-2 * law.onset * law.stiffness * 1e-4, rel=1e-9)


@pytest.mark.parametrize("obstacle", [Plate(1e-7), Cylinder(8e-3, (5e-3, 0.0, -8e-3))])
def test_tangent_is_the_derivative_of_the_force(obstacle: Plate | Cylinder) -> None:
    mesh = mesh_body(box((10e-3, 10e-3, 10e-3)), uniform=(2, 1, 1))
    law = contact_law(mesh, [RUBBER])
    contact = Obstacle(outside(mesh), law, obstacle)
    rng = np.random.default_rng(1)
    sunk = mesh.nodes + 0.5 * law.onset * rng.standard_normal(mesh.nodes.shape)
    sunk[:, 2] -= law.onset
    free = np.ones_like(mesh.nodes, dtype=bool)
    system = ContinuumSystem(mesh, [RUBBER], free=free, interactions=[contact])
    values = np.zeros(len(system.indices))
    into = Tangent(system.dof, system.indptr, system.indices, values)
    contact.add(sunk, np.zeros_like(sunk), into)
    way = rng.standard_normal(sunk.shape)
    way[mesh.centre_nodes] = 0.0
    slope, h = np.zeros_like(sunk), 1e-5 * law.onset
    for sign in (1, -1):
        residual = np.zeros_like(sunk)
        contact.add(sunk + sign * h * way, residual, None)
        slope += sign * residual / (2 * h)
    size = system.unknowns
    upper = sp.csr_matrix((values, system.indices, system.indptr), shape=(size, size))
    expected = (upper + sp.triu(upper, 1).T) @ way[system.dof >= 0]
    assert np.abs(expected).max() > 0
    assert slope[system.dof >= 0] == pytest.approx(expected, abs=1e-5 * np.abs(expected).max())


def test_a_tilted_block_enters_a_plate_nowhere_by_more_than_the_tolerance() -> None:
    """Pressed with one edge first, on one coarse face: edges and what lies between nodes count."""
    mesh = mesh_body(box((10e-3, 10e-3, 10e-3)), uniform=(2, 1, 2))
    contact = Obstacle(outside(mesh), contact_law(mesh, [RUBBER]), Plate(1e-6))
    free = np.ones((len(mesh.nodes), 3), dtype=bool)
    top = mesh.on_last_plane(2)
    free[top] = False
    moved = np.zeros_like(mesh.nodes)
    moved[top, 2] = -0.1e-3 - 0.05 * mesh.nodes[top, 0]
    _, state = press(mesh, free, moved, [contact], steps=3)
    positions = mesh.nodes + state.displacement
    assert (contact.gaps(positions) < 0).any()
    assert contact.depth(positions) < TOLERANCE * 10e-3
