"""The body against itself: consistency, uniform pressure, what may touch and what may not."""

import numpy as np
import pytest
import scipy.sparse as sp

from actuators.mechanics.continuum.contact import SelfContact, Tangent, contact_law, outside
from actuators.mechanics.continuum.contact.points import WALL_POINTS, contact_areas
from actuators.mechanics.continuum.contact.search import PairSearch
from actuators.mechanics.continuum.contact.surface import ContactLaw, ContactSurface
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.meshing import HexMesh, mesh_body
from tests.actuators.contact.pressed import (
    MU,
    RUBBER,
    Place,
    box,
    press,
    reaction,
    straight,
    two_blocks,
)

GAP = 0.2e-3


def contact_of(mesh: HexMesh) -> SelfContact:
    height = float(np.ptp(mesh.nodes[:, 2]))
    return SelfContact(outside(mesh, WALL_POINTS), contact_law(mesh, [RUBBER]), height)


def shifted_above(lattice: np.ndarray) -> np.ndarray:
    """Mesh lines of the upper block moved against those of the lower, its outline kept."""
    x, y, z = np.moveaxis(np.array(lattice, dtype=float), -1, 0)
    upper = z > 5e-3 + GAP / 2
    shift = 1.1e-3 * np.sin(np.pi * x / 10e-3) ** 2
    return np.stack([np.where(upper, x + shift, x), y, z], axis=-1)


@pytest.mark.parametrize(("place", "scatter"), [(straight, 0.01), (shifted_above, 0.3)])
def test_two_blocks_press_each_other_uniformly(place: Place, scatter: float) -> None:
    """Node by node within 1 % where nodes are opposite to nodes; elsewhere in the mean."""
    body = two_blocks(GAP, place)
    mesh = mesh_body(body, uniform=(3, 2, 1))
    contact = contact_of(mesh)
    free = np.ones((len(mesh.nodes), 3), dtype=bool)
    bottom, top = mesh.on_first_plane(2), mesh.on_last_plane(2)
    free[np.concatenate([bottom, top]), 2] = False
    free[mesh.on_first_plane(0), 0] = False
    free[mesh.on_first_plane(1), 1] = False
    moved = np.zeros_like(mesh.nodes)
    moved[top, 2] = -GAP - 1e-3
    system, state = press(mesh, free, moved, [contact], steps=3)
    positions = mesh.nodes + state.displacement
    pushed = reaction(system, state, top)
    assert reaction(system, state, bottom)[2] == pytest.approx(-pushed[2], rel=1e-6)
    # incompressible neo-Hooke, pressed to a stretch l: Cauchy stress mu (l^2 - 1/l)
    heights = mesh.nodes[:, 2] + state.displacement[:, 2]
    low = np.isclose(mesh.nodes[:, 2], 5e-3)
    stretch = heights[low].mean() / 5e-3
    expected = MU * (1 / stretch - stretch**2)
    area = (10e-3) ** 2 / stretch
    assert -pushed[2] / area == pytest.approx(expected, rel=5e-3)
    pressure = contact.contact_pressure(positions)
    inner = low & (np.abs(mesh.nodes[:, :2] - [5e-3, 0.0]) < 4.9e-3).all(axis=1)
    assert pressure[inner] == pytest.approx(expected, rel=scatter)
    assert pressure[inner].mean() == pytest.approx(expected, rel=0.02)
    assert contact.gaps(positions).min() > -1e-4 * 10.2e-3


def test_tangent_is_the_derivative_of_the_force_and_the_force_that_of_nothing_else() -> None:
    """Two bent faces in each other, moved at random: central differences."""
    mesh = mesh_body(two_blocks(GAP, shifted_above), uniform=(2, 1, 1))
    contact = contact_of(mesh)
    rng = np.random.default_rng(3)
    sunk = mesh.nodes[:, 2] > 5.1e-3
    positions = mesh.nodes + 2e-7 * rng.standard_normal(mesh.nodes.shape)
    positions[sunk, 2] -= GAP
    positions[:, 2] += 30.0 * positions[:, 0] ** 2
    system = ContinuumSystem(
        mesh, [RUBBER], free=np.ones_like(mesh.nodes, dtype=bool), interactions=[contact]
    )
    system.linearise(State(positions - mesh.nodes, system.rest().pressure), 0.0)
    values = np.zeros(len(system.indices))
    into = Tangent(system.dof, system.indptr, system.indices, values)
    contact.add(positions, np.zeros_like(positions), into)
    direction = rng.standard_normal(positions.shape)
    direction[mesh.centre_nodes] = 0.0
    expected = upper_times(system, values, direction)
    slope = np.zeros_like(positions)
    h = 1e-10
    for sign in (1, -1):
        residual = np.zeros_like(positions)
        contact.add(positions + sign * h * direction, residual, None)
        slope += sign * residual / (2 * h)
    assert slope[system.dof >= 0] == pytest.approx(expected, abs=1e-5 * np.abs(expected).max())
    residual = np.zeros_like(positions)
    contact.add(positions, residual, None)
    assert np.abs(residual).max() > 0
    assert residual.sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-9 * np.abs(residual).max())


def upper_times(system: ContinuumSystem, values: np.ndarray, direction: np.ndarray) -> np.ndarray:
    size = system.unknowns
    upper = sp.csr_matrix((values, system.indices, system.indptr), shape=(size, size))
    full = upper + sp.triu(upper, 1).T
    return full @ direction[system.dof >= 0]


def test_two_sides_of_a_wall_never_touch() -> None:
    """A thin plate: its upper and lower side face away from each other, however near."""
    mesh = mesh_body(two_blocks(GAP), uniform=(4, 4, 1))
    flat = mesh.nodes * [1.0, 1.0, 0.02]
    surface = outside(mesh)
    pairs = PairSearch(flat, surface.faces, 10e-3).near(flat, 1e-3)
    middle = flat[surface.faces[:, 4], 2]
    # only the two sides of the gap
    assert len(pairs) > 0
    assert np.unique(np.round(middle[pairs] * 1e6)).tolist() == [100.0, 104.0]


def test_far_apart_it_costs_no_entry_and_no_force() -> None:
    mesh = mesh_body(two_blocks(2e-3))
    contact = contact_of(mesh)
    assert contact.couples(mesh.nodes).shape == (0, 18)
    residual = np.zeros_like(mesh.nodes)
    contact.add(mesh.nodes, residual, None)
    assert not residual.any()


def test_areas_of_the_points_add_up() -> None:
    mesh = mesh_body(two_blocks(GAP, shifted_above), uniform=(2, 2, 1))
    faces = mesh.outer_faces.nodes.astype(np.int64)
    expected = 2 * (2 * 10e-3**2 + 4 * 10e-3 * 5e-3)
    assert contact_areas(mesh.nodes, faces, WALL_POINTS).sum() == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("gap", [0.1e-3, -2e-6])
def test_a_strip_curled_up_more_than_a_turn_meets_itself(gap: float) -> None:
    """Rolled into a spiral: beyond a full turn the upper side passes inside the underside."""
    length, thick, turns = 200e-3, 2e-3, 1.25
    mesh = mesh_body(box((length, 10e-3, thick)), uniform=(100, 1, 1))
    pitch = (thick + gap) / (2 * np.pi)
    radius = length / (2 * np.pi * turns)
    angle = mesh.nodes[:, 0] / length * 2 * np.pi * turns
    r = radius - pitch * angle + mesh.nodes[:, 2]
    curled = np.stack([r * np.sin(angle), mesh.nodes[:, 1], r * np.cos(angle)], axis=-1)
    contact = contact_of(mesh)
    found = contact.gaps(curled)
    # radial distance of the faces between their nodes: quadratic faces follow the circle closely
    assert found.min() == pytest.approx(gap, abs=2e-6)
    facing = found < 0.2e-3
    middle = mesh.nodes[outside(mesh).faces[facing.any(axis=1)][:, 4]]
    assert middle[:, 0].min() < 0.05 * length
    assert middle[:, 0].max() > 0.95 * length
    # nothing but the last quarter of a turn and what it lies under
    assert ((middle[:, 0] < 0.22 * length) | (middle[:, 0] > 0.78 * length)).all()
    residual = np.zeros_like(curled)
    contact.add(curled, residual, None)
    assert residual.any() == (gap < 0)
    assert residual.sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-9)


@pytest.mark.parametrize("slope", [0.12, -0.12])
def test_the_distance_does_not_jump_where_two_faces_meet_at_an_angle(slope: float) -> None:
    """A point that slides through a valley or over a ridge, inside and outside of the surface."""
    along, across = np.meshgrid(np.linspace(-1, 1, 3), np.linspace(-1, 1, 3))
    square = np.stack([along, across, np.zeros_like(along)], axis=-1).reshape(9, 3)
    side = np.array([1.0, 0.0, 0.0])
    left, right = square - side, square + side
    probe = 0.01 * square[:, [1, 0, 2]]
    nodes = np.concatenate([left, right, probe])
    nodes[:, 2] = np.where(np.arange(27) < 18, slope * np.abs(nodes[:, 0]), 0.5)
    surface = ContactSurface(nodes, np.arange(27).reshape(3, 9), np.ones((3, 9)))
    contact = SelfContact(surface, ContactLaw(1.0, 1e-3), 2.0)
    for height in (-0.004, 0.001):
        for x in np.linspace(-0.05, 0.05, 41):
            moved = nodes.copy()
            moved[18:] = probe + np.array([x, 0.0, height + slope * abs(x)])
            distance = height / np.hypot(1.0, slope)
            assert contact.gaps(moved)[2, 4] == pytest.approx(distance, rel=0.02)
