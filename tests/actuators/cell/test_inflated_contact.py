"""Walls of neighbouring chambers in the periodic cell: they hold each other apart."""

import numpy as np
import pytest
import scipy.sparse as sp

from actuators.design import preset
from actuators.geometry import Body, build_cell
from actuators.materials import Material, material
from actuators.mechanics.cell.helical.contact import WallContact, wall_contact
from actuators.mechanics.cell.helical.domain import half_pitch
from actuators.mechanics.cell.helical.follow import Follower, Point
from actuators.mechanics.cell.helical.newton import Solver
from actuators.mechanics.cell.helical.overlap import WallGap
from actuators.mechanics.cell.helical.system import CellState, CellSystem
from actuators.mechanics.cell.inflated import inflate_cell
from actuators.mechanics.cell.periodic import coarse_mesh


def cell_of(name: str) -> tuple[Body, tuple[Material, ...]]:
    body = build_cell(preset(name).design, 0)
    return body, tuple(material(region.material) for region in body.regions)


def inflated(name: str, pressure: float, *, contact: bool) -> tuple[CellSystem, Point]:
    body, materials = cell_of(name)
    domain = half_pitch(body, coarse_mesh(body))
    walls = wall_contact(domain, materials, pressure) if contact else None
    system = CellSystem(domain, materials, walls)
    point = Follower(Solver(system), pressure).run().points[-1]
    assert point.pressure == pressure
    return system, point


@pytest.fixture(scope="module")
def pressed() -> tuple[CellSystem, Point]:
    """Oblique walls, pressed together."""
    return inflated("oblique-45", 13e3, contact=True)


def walls_of(system: CellSystem) -> WallContact:
    assert system.walls is not None
    return system.walls


@pytest.mark.parametrize("name", ["oblique-45", "printed-14", "bellows-9-2.0"])
def test_half_a_turn_about_the_midway_axis_exchanges_the_sides_of_the_gap(name: str) -> None:
    body, materials = cell_of(name)
    domain = half_pitch(body, coarse_mesh(body))
    walls = wall_contact(domain, materials, 1e4)
    assert walls is not None
    strain = np.array([0.02, 15.0, 10.0, 0.0])
    system = CellSystem(domain, materials, walls)
    still = system.placed(system.rest().nodes, domain.place.copy(), strain, np.zeros(1))
    motion = domain.motions(strain)[4]  # of the frame midway
    at = (system.wall_positions(still) - motion.shift) @ motion.rotation
    turned = at * [-1.0, -1.0, 1.0]
    # every node of either side is met by one of the other
    apart = np.linalg.norm(at[:, None] - turned[None], axis=2).min(axis=1)
    assert apart.max() < 1e-12


def test_walls_that_would_overlap_press_on_each_other(pressed: tuple[CellSystem, Point]) -> None:
    free, alone = inflated("oblique-45", 13e3, contact=False)
    system, point = pressed
    assert WallGap(free).least(alone.state) < -0.1e-3
    walls = walls_of(system)
    at = system.wall_positions(point.state)
    assert walls.largest_pressure(at) > 2e3
    assert walls.depth(at) < 0.01e-3
    # pressed apart, chambers bend more
    assert point.state.strain[2] > 1.02 * alone.state.strain[2]


def test_the_tangent_is_the_change_of_the_forces_in_contact(
    pressed: tuple[CellSystem, Point],
) -> None:
    system, point = pressed
    state, pressure = point.state, point.pressure
    numbering = system.numbering("even")
    balance = system.linearise(state, pressure)
    reduced = system.reduced(state, balance, pressure, numbering)
    count = numbering.count
    step = 1e-4 * np.random.default_rng(3).normal(size=count + numbering.border)
    step[count : count + 3] *= [1e2, 1e4, 1e4]
    shape = (count, count)
    upper = sp.csr_matrix((reduced.values, numbering.indices, numbering.indptr), shape)
    inner = upper @ step[:count] + sp.triu(upper, 1).T @ step[:count]
    expected = np.concatenate([
        inner + reduced.border @ step[count:],
        reduced.border.T @ step[:count] + reduced.corner @ step[count:],
    ])  # fmt: skip
    nodes, place, strain = system.expand(state, step, None, numbering)

    def moved(share: float) -> CellState:
        return system.placed(
            state.nodes.moved(share, nodes), state.place + share * place,
            state.strain + share * strain, state.hold,
        )  # fmt: skip

    h = 1e-5  # a nanometre: the contact law's curvature jumps within some micrometres
    forces = [system.forces(s, system.balance(s, pressure), pressure, numbering)
              for s in (moved(h), moved(-h))]  # fmt: skip
    found = (forces[0] - forces[1]) / (2 * h)
    np.testing.assert_allclose(found, expected, atol=1e-4 * np.abs(expected).max())


def test_the_path_says_from_which_pressure_walls_touch() -> None:
    body, materials = cell_of("oblique-45")
    assert not inflate_cell(body, materials, pressure_to=2e3).notes
    path = inflate_cell(body, materials, pressure_to=11e3)
    assert path.contact_pressure is not None
    assert path.contact_pressure[0] == 0.0
    assert path.contact_pressure[-1] > 1e3
    assert any("touch from about" in note for note in path.notes)


def test_a_slab_has_no_walls_that_meet() -> None:
    body, materials = cell_of("slab-rectangle-low")
    assert inflate_cell(body, materials, pressure_to=1e3).contact_pressure is None
