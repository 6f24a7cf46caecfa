"""Embedded sheets: consistency, objectivity, closed forms of stretching, and bending unhindered."""

import dataclasses

import numpy as np
import pytest
import scipy.sparse as sp

from actuators.geometry import Body, Membrane, Region
from actuators.materials import Material, NeoHooke
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.system import ContinuumSystem, State, clamped
from actuators.mechanics.direct_solver import open_solver
from actuators.meshing import HexMesh, mesh_body
from tests.actuators.continuum.boxes import LAWS, block, rubber, skewed, system_of

LENGTH, WIDTH, HEIGHT, MU = 120e-3, 8e-3, 4e-3, 4e5
YOUNG = 3 * MU
STIFF = 1000 * YOUNG * HEIGHT


def skewed_with_sheets(stiffness: float) -> HexMesh:
    """A skewed block with a cavity between two sheets."""
    plain = block(skewed)
    sheets = (Membrane("lower", 4e-3, stiffness), Membrane("upper", 8e-3, 2 * stiffness))
    return mesh_body(dataclasses.replace(plain, membranes=sheets))


def test_tangent_is_the_derivative_of_the_residual() -> None:
    law = LAWS["neo-hooke"]
    mesh = skewed_with_sheets(0.05 * law.initial_shear_modulus)
    system, _ = system_of(mesh, law)
    rng = np.random.default_rng(3)
    state = State(
        2e-4 * rng.standard_normal(mesh.nodes.shape),
        system.rest().pressure,
        0.02 * law.initial_shear_modulus * rng.standard_normal(system.rest().sheet.shape),
    )
    system.linearise(state, 0.0)
    upper = sp.csr_matrix((system.values, system.indices, system.indptr))
    direction = rng.standard_normal(system.unknowns)
    expected = upper @ direction + sp.triu(upper, 1).T @ direction
    step = system.expand(direction, None)
    h = 1e-7
    plus, minus = (system.balance(state.moved(s * h, step), 0.0) for s in (1, -1))
    kept = system.dof >= 0
    slope = np.zeros(system.unknowns)
    slope[system.dof[kept]] = (plus.residual - minus.residual)[kept] / (2 * h)
    # the sheets' forces follow so that what they answer for stays as it was
    assert np.abs(plus.sheet - minus.sheet).max() / (2 * h) < 1e-6 / 4e-3
    assert np.abs(slope - expected).max() < 1e-6 * np.abs(expected).max()
    bare, _ = system_of(mesh_body(block(skewed)), law)
    bare.linearise(State(state.displacement, state.pressure), 0.0)
    assert np.abs(bare.values - system.values).max() > 1e-2 * np.abs(system.values).max()


def test_rigid_motion_makes_no_force() -> None:
    mesh = skewed_with_sheets(1e5)
    system, _ = system_of(mesh, LAWS["neo-hooke"])
    turn = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])
    u = mesh.nodes @ turn.T + np.array([1.0, 2.0, 3.0]) - mesh.nodes
    balance = system.balance(State(u, system.rest().pressure), 0.0)
    assert np.abs(balance.residual).max() < 1e-9 * LAWS["neo-hooke"].initial_shear_modulus * 1e-5
    assert np.abs(balance.sheet).max() < 1e-12


def bar(*heights: float, stiffness: float = STIFF, mu: float = MU) -> Body:
    """A straight bar with one sheet at each of ``heights``; half of it is what is meshed."""
    lines = (
        np.array([0.0, LENGTH]), np.array([-WIDTH, 0.0, WIDTH]) / 2,
        np.unique(np.array([0.0, HEIGHT, *heights])),
    )  # fmt: skip
    sheets = tuple(Membrane("sheet", z, stiffness) for z in heights)
    fill = np.zeros((1, 2, len(lines[2]) - 1), dtype=np.int8)
    return Body(
        lines, fill, (Region("a", "a"),), lambda x: np.array(x, dtype=float), True,
        membranes=sheets,
    ).half()  # fmt: skip


@pytest.mark.parametrize("height", [0.0, 1e-3, HEIGHT])
@pytest.mark.parametrize("stretch", [0.8, 1.0, 1.6])
def test_stretched_strip_has_the_force_of_rubber_and_sheet(height: float, stretch: float) -> None:
    stiffness = 3.0 * YOUNG * HEIGHT
    mesh = mesh_body(bar(height, stiffness=stiffness))
    law = NeoHooke(MU)
    system = ContinuumSystem(mesh, [rubber(law)], free=np.ones_like(mesh.nodes, dtype=bool))
    u = mesh.nodes * (np.array([stretch, stretch**-0.5, stretch**-0.5]) - 1)
    q = system.rest().pressure
    q[:, 0] = MU * (stretch**2 / 3 + 2 / (3 * stretch) - 1 / stretch)  # no stress across
    force = np.full_like(system.rest().sheet, stiffness * (stretch - 1))
    balance = system.balance(State(u, q, force), 0.0)
    assert np.abs(balance.sheet).max() < 1e-12
    residual = balance.residual
    pulled = residual[mesh.node_index[:, 0] == mesh.node_index[:, 0].max()].sum(axis=0)
    area, width = WIDTH * HEIGHT / 2, WIDTH / 2
    rubber_force = area * float(law.nominal_uniaxial_stress(np.array([stretch]))[0])
    expected = rubber_force + stiffness * width * (stretch - 1)
    assert pulled[0] == pytest.approx(expected, rel=1e-10, abs=1e-10 * stiffness * width)
    # and nothing across it
    assert np.abs(residual[:, 1:]).max() < 1e-10 * stiffness * width


def test_strip_stretched_across_does_not_feel_its_sheet() -> None:
    u = np.array([0.0, 0.3, -0.2])
    forces: list[np.ndarray] = []
    for sheets in ((), (HEIGHT / 2,)):
        body = dataclasses.replace(bar(HEIGHT / 2), membranes=bar(*sheets).membranes)
        mesh = mesh_body(body)
        system = ContinuumSystem(mesh, [rubber(NeoHooke(MU))], free=clamped(mesh))
        balance = system.balance(State(mesh.nodes * u, system.rest().pressure), 0.0)
        assert np.abs(balance.sheet).max(initial=0.0) < 1e-12
        forces.append(balance.residual)
    assert forces[1] == pytest.approx(forces[0], abs=1e-10 * STIFF * WIDTH)


def drooped(*heights: float, gravity: float, elements: int) -> tuple[np.ndarray, int]:
    """Tip displacement of the clamped bar under its weight, and iterations."""
    body = bar(*heights)
    per_height = 2 if len(body.lines[2]) == 2 else 1
    mesh = mesh_body(body, uniform=(elements, 1, per_height), layers=(1, 0, 0))
    system = ContinuumSystem(
        mesh, [Material("a", "a", NeoHooke(MU), 1000.0, "test")], free=clamped(mesh),
        gravity=(0.0, 0.0, -gravity),
    )  # fmt: skip
    path = PathFollower(system, open_solver(system.indptr, system.indices)).follow(0.0, None)
    return path.points[0].state.displacement[mesh.underside_line[-1]], path.iterations


def droop(*heights: float, gravity: float, elements: int) -> np.ndarray:
    return drooped(*heights, gravity=gravity, elements=elements)[0]


def test_sheet_in_the_middle_leaves_bending_as_it_is() -> None:
    plain, sheet = (droop(*h, gravity=0.05, elements=24) for h in ((), (HEIGHT / 2,)))
    # the middle fibre of a bent bar keeps its length: found 1e-5
    assert sheet[2] == pytest.approx(plain[2], rel=1e-4)


def test_coarse_mesh_with_a_sheet_does_not_lock() -> None:
    # ten elements as long as three heights, then far beyond small rotations
    for gravity, least in ((0.05, 1e-4), (4.0, 20e-3)):
        fine = droop(HEIGHT / 2, gravity=gravity, elements=40)
        coarse = droop(HEIGHT / 2, gravity=gravity, elements=8)
        assert -fine[2] > least
        assert coarse == pytest.approx(fine, rel=0.02, abs=0.005 * abs(fine[2]))


def test_stiff_sheet_turns_far_at_no_more_iterations() -> None:
    plain, sheet = (drooped(*h, gravity=4.0, elements=12) for h in ((), (HEIGHT / 2,)))
    # the sheet holds back the bar's cross curvature, a few percent at this bend
    assert sheet[0] == pytest.approx(plain[0], rel=0.05, abs=1e-3)
    assert sheet[1] <= plain[1] + 4


def test_sheet_at_the_bottom_moves_the_neutral_axis_there() -> None:
    moved = -droop(0.0, gravity=0.05, elements=24)[2]
    stiffness = YOUNG * WIDTH * HEIGHT**3 / 3
    beam = 1000.0 * 0.05 * WIDTH * HEIGHT * LENGTH**4 / (8 * stiffness)
    # shear adds 0.4 %, the clamp takes about 1.5 %; a sheet that locked would bend several times
    # less, a bar without it four times as much
    assert moved == pytest.approx(beam, rel=0.02)
