"""The periodic cell at finite strain: its small-strain limit, its tangent, its path."""

import numpy as np
import pytest
import scipy.sparse as sp

from actuators.design import preset
from actuators.geometry import Body, Region, build_cell
from actuators.materials import Material, NeoHooke, material
from actuators.mechanics.cell.helical.domain import Image, half_pitch
from actuators.mechanics.cell.helical.follow import Follower
from actuators.mechanics.cell.helical.newton import Found, Solver
from actuators.mechanics.cell.helical.numbering import Numbering
from actuators.mechanics.cell.helical.screw import screw
from actuators.mechanics.cell.helical.step import step_of
from actuators.mechanics.cell.helical.system import CellState, CellSystem, Reduced
from actuators.mechanics.cell.helical.tangent import Tangent, Target
from actuators.mechanics.cell.inflated import inflate_cell
from actuators.mechanics.cell.periodic import CellMesh, coarse_mesh, solve_cell
from actuators.mechanics.response import Outcome
from actuators.mechanics.rod.rotation import segment

FAMILIES = ("slab-rectangle-low", "oblique-45", "printed-14", "bellows-9-2.0")


def cell_of(name: str) -> tuple[Body, tuple[Material, ...]]:
    body = build_cell(preset(name).design, 0)
    return body, tuple(material(region.material) for region in body.regions)


def test_the_screw_motion_is_the_rods_piece_of_helix() -> None:
    strain = np.array([0.03, 40.0, 55.0, -20.0])
    found = screw(strain, 0.02)
    rotation, shift = segment(strain, 0.02)
    np.testing.assert_allclose(found.rotation, rotation, atol=1e-14)
    np.testing.assert_allclose(found.shift, shift, atol=1e-16)


def test_the_screw_motions_derivatives_are_those_of_differences() -> None:
    strain, h = np.array([0.03, 40.0, 55.0, -20.0]), 1e-4
    exact = screw(strain, 0.02)
    for k in range(4):
        unit = h * np.eye(4)[k]
        more, less = screw(strain + unit, 0.02), screw(strain - unit, 0.02)
        for value, rate in (
            (more.rotation - less.rotation, exact.turn_rate[k]),
            (more.shift - less.shift, exact.shift_rate[k]),
            (more.turn_rate - less.turn_rate, exact.turn_second[k]),
            (more.shift_rate - less.shift_rate, exact.shift_second[k]),
        ):
            scale = max(np.abs(rate).max(), 1e-9)
            np.testing.assert_allclose(value / (2 * h), rate, atol=1e-6 * scale)


@pytest.mark.parametrize("name", FAMILIES)
def test_at_rest_every_node_is_the_image_of_its_site(name: str) -> None:
    body, _ = cell_of(name)
    domain = half_pitch(body, coarse_mesh(body))
    motions = domain.motions(np.zeros(4))
    for image in Image:
        mine = domain.image == image
        at = domain.place[domain.site[mine]] @ motions[image].rotation.T + motions[image].shift
        np.testing.assert_allclose(at, domain.mesh.nodes[mine], atol=1e-15)


@pytest.mark.parametrize("name", FAMILIES)
def test_small_pressure_gives_the_linear_cell(name: str) -> None:
    body, materials = cell_of(name)
    even = coarse_mesh(body).even
    mesh = CellMesh(even, even)
    linear = solve_cell(body, materials, mesh)
    found = inflate_cell(body, materials, pressure_to=0.1, mesh=mesh)
    assert found.outcome is Outcome.CONVERGED
    scale = np.abs(linear.free).max()
    np.testing.assert_allclose(found.strain_rate[0], linear.free, rtol=1e-5, atol=1e-5 * scale)
    size = np.sqrt(np.outer(np.diag(linear.stiffness), np.diag(linear.stiffness)))
    np.testing.assert_allclose(found.stiffness[0], linear.stiffness, atol=1e-5 * size.min())
    np.testing.assert_allclose(found.strain[-1] / 0.1, linear.free, rtol=1e-3, atol=1e-3 * scale)
    assert found.volume[0] == pytest.approx(linear.cavity_volume, rel=1e-9)
    assert found.compliance[0] == pytest.approx(linear.cavity_compliance, rel=1e-5)


def product(numbering: Numbering, reduced: Reduced, step: np.ndarray) -> np.ndarray:
    """The bordered symmetric matrix times a vector."""
    count = numbering.count
    upper = sp.csr_matrix((reduced.values, numbering.indices, numbering.indptr), (count, count))
    y, z = step[:count], step[count:]
    inner = upper @ y + sp.triu(upper, 1).T @ y + reduced.border @ z
    return np.concatenate([inner, reduced.border.T @ y + reduced.corner @ z])


def test_the_tangent_is_the_change_of_the_forces() -> None:
    """Inflated, bent and twisted; strains, and the body held by a point, among the unknowns."""
    pressure = 8e3
    body, materials = cell_of("oblique-45")
    system = CellSystem(half_pitch(body, coarse_mesh(body)), materials)
    state = Follower(Solver(system), pressure).run().points[-1].state
    numbering = system.numbering("even")
    balance = system.linearise(state, pressure)
    reduced = system.reduced(state, balance, pressure, numbering)
    step = 1e-4 * np.random.default_rng(3).normal(size=numbering.count + numbering.border)
    step[numbering.count : numbering.count + 3] *= [1e2, 1e4, 1e4]
    expected = product(numbering, reduced, step)
    nodes, place, strain = system.expand(state, step, None, numbering)

    def moved(share: float) -> CellState:
        return system.placed(
            state.nodes.moved(share, nodes), state.place + share * place,
            state.strain + share * strain, state.hold,
        )  # fmt: skip

    h = 1e-3
    ahead, back = moved(h), moved(-h)
    forces = [system.forces(s, system.balance(s, pressure), pressure, numbering)
              for s in (ahead, back)]  # fmt: skip
    found = (forces[0] - forces[1]) / (2 * h)
    np.testing.assert_allclose(found, expected, atol=1e-6 * np.abs(expected).max())
    growth = (system.volume(ahead) - system.volume(back)) / (2 * h)
    assert growth == pytest.approx(system.volume_gradient(state, numbering) @ step, rel=1e-6)


@pytest.mark.parametrize("bulk", ["@nu=0.49", "@incompressible"])
def test_an_old_tangent_serves_whatever_the_bulk_modulus(bulk: str) -> None:
    """Its corrections obey the volume along its own motions: folded by the new state's they were
    wrong by bulk times what was missed, and grew tenfold each."""
    both = dict.fromkeys(("top_material", "bottom_material"), "elastosil-m4601" + bulk)
    body = build_cell(preset("oblique-90").design.changed(**both), 0)
    system = CellSystem(
        half_pitch(body, coarse_mesh(body)), tuple(material(r.material) for r in body.regions)
    )
    solver, pressure, state = Solver(system), 1250.0, system.rest()
    factor = solver.factor(state, pressure)
    assert factor is not None
    tangent, balance, lengths = Tangent(factor, Target(pressure)), factor.balance, []
    for _ in range(5):
        solution, hold, rise = tangent.correction(state, balance, pressure)
        step = step_of(system, state, solution, balance, hold, rise)
        lengths.append(step.length / system.size)
        state = step.taken(system, state, 1.0)
        balance = system.balance(state, pressure)
    ratios = np.divide(lengths[1:], lengths[:-1])
    assert max(ratios) < 0.4


def test_a_slab_has_a_limit_pressure_where_its_bending_stiffness_vanishes() -> None:
    body, materials = cell_of("slab-rectangle-low")
    found = inflate_cell(body, materials, pressure_to=30e3)
    assert found.outcome is Outcome.LIMIT_POINT
    assert found.limit_pressure == pytest.approx(found.pressure[-1])
    law = found.stiffness[:, :3, :3]
    least = np.linalg.eigvalsh(law / np.sqrt(np.einsum("kii,kjj->kij", law[:1], law[:1])))[:, 0]
    assert least[0] > 0.01
    assert abs(least[-1]) < 0.01 * least[0]
    assert np.all(np.diff(found.pressure) > 0)


def test_a_layer_that_would_wrinkle_is_no_limit() -> None:
    """A thick layer is pressed together under the bottom's bulges: without stiffness against
    bending it would wrinkle from 28 to 39 kPa on, depending on the mesh."""
    design = preset("printed-14").design.changed(chamber_count=2, length=16.0, layer_thickness=5.0)
    body = build_cell(design, 0)
    materials = tuple(material(region.material) for region in body.regions)
    found = inflate_cell(body, materials, pressure_to=44e3)
    assert found.outcome is Outcome.CONVERGED
    assert found.wrinkles_from is not None
    assert 20e3 < found.wrinkles_from < 44e3
    bending = found.strain[:, 2] / found.pressure.clip(1.0)
    np.testing.assert_allclose(bending[1:], bending[1], rtol=0.05)


def test_suction_bends_the_other_way() -> None:
    body, materials = cell_of("slab-rectangle-low")
    found = inflate_cell(body, materials, pressure_to=-3e3)
    assert found.outcome is Outcome.CONVERGED
    assert np.all(np.diff(found.strain[:, 2]) < 0)
    assert np.all(np.diff(found.volume) < 0)


def test_a_solid_bar_under_a_force_stretches_as_the_closed_form_says() -> None:
    """Neo-Hooke: F = mu A (l - 1/l^2). The force of the line X3 = 0 is moved to the middle height
    by its moment about X2; kappa/mu = 1000 leaves 1e-3."""
    side, height, modulus, stretch = 4e-3, 6e-3, 1e5, 1.5
    lines = (np.array([0.0, 2e-3, 6e-3, 8e-3]), np.array([-side / 2, 0.0, side / 2]),
             np.array([0.0, height]))  # fmt: skip
    body = Body(lines, np.zeros((3, 2, 1), np.int8), (Region("bar", "bar"),), lambda x: x, True,
                period=8e-3)  # fmt: skip
    rubber = Material("bar", "bar", NeoHooke(modulus), 1e3, "test")
    force = modulus * side * height * (stretch - stretch**-2)
    solver = Solver(CellSystem(half_pitch(body, CellMesh(((2, 1), (1,), (2,)), ((),))), (rubber,)))
    state = solver.system.rest()
    for share in (0.25, 0.5, 0.75, 1.0):
        load = share * force * np.array([1.0, 0.0, height / 2, 0.0])
        found = solver.solve(state, Target(0.0, resultants=load, held=True))
        assert isinstance(found, Found)
        state = found.state
    assert state.strain[0] == pytest.approx(stretch - 1, rel=2e-3)
    np.testing.assert_allclose(state.strain[1:] * height, 0.0, atol=1e-4)
