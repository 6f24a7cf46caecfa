"""The element and the system: patch test, consistency, objectivity, the cavity."""

import numpy as np
import pytest
import scipy.sparse as sp

from actuators.materials import NeoHooke
from actuators.mechanics.continuum.assembly import linear_system
from actuators.mechanics.continuum.kernel.laws import (
    add_i1_law,
    add_mooney_rivlin_law,
    add_ogden_law,
    inverse_transpose,
)
from actuators.mechanics.continuum.newton import Equilibrium, Target, solve_equilibrium
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.meshing import CENTRE, mesh_body
from tests.actuators.continuum.boxes import LAWS, block, rubber, skewed, skewed_mesh, system_of


def stress_and_tangent(law, f: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    p, a, h = np.zeros((3, 3)), np.zeros((9, 9)), np.empty((3, 3))
    c = np.array(law.coefficients)
    if law.code == 1:
        add_ogden_law(c, len(c), f, True, p, a)
    elif law.code == 2:
        add_mooney_rivlin_law(c, f, inverse_transpose(f, h), h, True, p, a)
    else:
        det = inverse_transpose(f, h)
        add_i1_law(c, float((f * f).sum()), det, f, h, np.eye(3), True, p, a)
    for i in range(3):  # only i <= k is filled
        for k in range(i):
            a[3 * i : 3 * i + 3, 3 * k : 3 * k + 3] = a[3 * k : 3 * k + 3, 3 * i : 3 * i + 3].T
    return p, a


def isochoric_energy(law, f: np.ndarray) -> float:
    stretch = np.linalg.svd(f, compute_uv=False)
    return float(law.energy(stretch / np.prod(stretch) ** (1 / 3)))


GRADIENTS = {
    "general": np.array([[1.3, 0.2, -0.1], [0.05, 0.8, 0.3], [-0.2, 0.1, 1.1]]),
    "rest": np.eye(3),
    "two equal stretches": np.diag([1.5, 0.8, 0.8]),
    "nearly equal stretches": np.diag([1.2, 1.2 + 1e-7, 0.7]),
    "stretched": np.array([[2.6, 0.3, 0.1], [-0.2, 0.6, 0.05], [0.4, -0.1, 0.7]]),
    "compressed": np.array([[0.35, 0.1, 0.05], [0.1, 1.6, -0.2], [0.0, 0.2, 1.5]]),
}


@pytest.mark.parametrize("gradient", GRADIENTS)
@pytest.mark.parametrize("name", LAWS)
def test_stress_and_tangent_are_derivatives_of_the_energy(name: str, gradient: str) -> None:
    law, f = LAWS[name], GRADIENTS[gradient]
    mu = law.initial_shear_modulus
    p, a = stress_and_tangent(law, f)
    scale = max(mu, np.abs(a).max())  # Mooney-Rivlin 5 stiffens a hundredfold
    h = 1e-5
    for i in range(3):
        for j in range(3):
            e = np.zeros((3, 3))
            e[i, j] = h
            slope = (isochoric_energy(law, f + e) - isochoric_energy(law, f - e)) / (2 * h)
            # h^2 truncation 1e-10, rounding of W over h 1e-11 (tiny exponent: 1e-6, W cancels)
            assert p[i, j] == pytest.approx(slope, abs=2e-5 * scale)
            plus, minus = stress_and_tangent(law, f + e)[0], stress_and_tangent(law, f - e)[0]
            assert a[:, 3 * i + j] == pytest.approx(
                ((plus - minus) / (2 * h)).ravel(), abs=1e-6 * scale
            )
    assert a == pytest.approx(a.T, abs=1e-9 * scale)


@pytest.mark.parametrize("name", LAWS)
def test_stress_turns_with_the_body(name: str) -> None:
    law, f = LAWS[name], GRADIENTS["general"]
    axis = np.array([0.3, -0.5, 0.9])
    skew = np.cross(np.eye(3), axis)
    turn = (
        np.eye(3)
        + np.sin(1.0) * skew / np.linalg.norm(axis)
        + (1 - np.cos(1.0)) * (skew @ skew / (axis @ axis))
    )
    p, turned = stress_and_tangent(law, f)[0], stress_and_tangent(law, turn @ f)[0]
    assert turned == pytest.approx(turn @ p, abs=1e-9 * law.initial_shear_modulus)


def test_patch_test_homogeneous_deformation_leaves_no_force_inside() -> None:
    """A linear displacement on a distorted mesh: forces only on the surface, J and q uniform."""
    mesh = mesh_body(block(skewed, cavity=False))
    law = LAWS["yeoh"]
    system, _ = system_of(mesh, law)
    gradient = np.array([[0.2, 0.1, 0.0], [-0.05, -0.1, 0.2], [0.1, 0.0, 0.05]])
    u = mesh.nodes @ gradient.T
    q = np.zeros((len(mesh.elements), 4))
    q[:, 0] = system.kappa[0] * (np.linalg.det(np.eye(3) + gradient) - 1)
    balance = system.balance(State(u, q), 0.0)
    inner = np.setdiff1d(np.arange(len(mesh.nodes)), mesh.outer_faces.nodes)
    scale = np.abs(balance.residual).max()
    assert len(inner) > 50
    # the quadratic map leaves J of the map inside the integrals: all polynomials, exact quadrature
    assert np.abs(balance.residual[inner]).max() < 1e-10 * scale
    assert np.abs(balance.inner).max() < 1e-12 * np.ptp(mesh.nodes) ** 3


@pytest.mark.parametrize("name", LAWS)
def test_tangent_is_the_derivative_of_the_residual(name: str) -> None:
    mesh = skewed_mesh()
    system, _ = system_of(mesh, LAWS[name], gravity=(1.0, 2.0, -9.0))
    rng = np.random.default_rng(3)
    mu = LAWS[name].initial_shear_modulus
    state = State(2e-4 * rng.standard_normal(mesh.nodes.shape),
                  mu * rng.standard_normal((len(mesh.elements), 4)))  # fmt: skip
    pressure = 0.1 * mu
    system.linearise(state, pressure)
    upper = sp.csr_matrix((system.values, system.indices, system.indptr))
    tangent = upper + sp.triu(upper, 1).T
    direction = rng.standard_normal(system.unknowns)
    step = system.expand(direction, None)  # the inner unknowns follow, so that theirs stay balanced
    h = 1e-7
    plus = system.balance(state.moved(h, step), pressure)
    minus = system.balance(state.moved(-h, step), pressure)
    kept = system.dof >= 0
    slope = np.zeros(system.unknowns)
    slope[system.dof[kept]] = (plus.residual - minus.residual)[kept] / (2 * h)
    expected = tangent @ direction
    assert np.abs(slope - expected).max() < 1e-6 * np.abs(expected).max()
    inner = (plus.inner - minus.inner) / (2 * h)
    assert np.abs(inner).max() < 1e-6 * (4e-3) ** 2  # volume over displacement: an area
    centre = (plus.residual - minus.residual)[mesh.elements[:, CENTRE]] / (2 * h)
    assert np.abs(centre).max() < 1e-6 * np.abs(expected).max()


def test_rigid_motion_makes_no_force() -> None:
    mesh = skewed_mesh()
    system, _ = system_of(mesh, LAWS["ogden-2"])
    turn = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])
    u = mesh.nodes @ turn.T + np.array([1.0, 2.0, 3.0]) - mesh.nodes
    balance = system.balance(State(u, np.zeros((len(mesh.elements), 4))), 0.0)
    assert np.abs(balance.residual).max() < 1e-9 * LAWS["ogden-2"].initial_shear_modulus * 1e-5
    assert np.abs(balance.inner).max() < 1e-20


def test_linear_operator_has_exactly_the_six_rigid_motions_for_null_space() -> None:
    mesh = skewed_mesh()
    linear = linear_system(mesh, [rubber(NeoHooke(1e5))])
    values = np.linalg.eigvalsh(linear.stiffness.toarray())
    assert np.abs(values[:6]).max() < 1e-9 * values[-1]
    assert values[6] > 1e-7 * values[-1]
    total = linear.pressure_load.reshape(-1, 3).sum(axis=0)  # a closed cavity pushes nowhere
    assert np.abs(total).max() < 1e-12 * np.abs(linear.pressure_load).max()


def test_cavity_volume_and_its_derivative() -> None:
    mesh = skewed_mesh()
    system, _ = system_of(mesh, LAWS["neo-hooke"])
    straight, _ = system_of(mesh_body(block()), LAWS["neo-hooke"])
    assert straight.volume(straight.rest())[0] == pytest.approx((4e-3) ** 3, rel=1e-12)
    rng = np.random.default_rng(5)
    state = State(3e-4 * rng.standard_normal(mesh.nodes.shape), system.rest().pressure)
    _, gradient = system.volume(state)
    direction = rng.standard_normal(mesh.nodes.shape) * (system.dof >= 0)
    step = State(direction, system.rest().pressure)
    h = 1e-6
    slope = (system.volume(state.moved(h, step))[0] - system.volume(state.moved(-h, step))[0]) / (
        2 * h
    )
    kept = system.dof >= 0
    expected = gradient[system.dof[kept]] @ direction[kept]
    # V is a cubic of the nodes: central differences leave h^2, 1e-12 / 1e-7 here
    assert slope == pytest.approx(expected, rel=1e-6)


def test_pressure_load_of_the_linear_operator_is_the_volume_gradient_of_a_closed_cavity() -> None:
    mesh = skewed_mesh()
    linear = linear_system(mesh, [rubber(NeoHooke(1e5))])
    everywhere = ContinuumSystem(
        mesh, [rubber(NeoHooke(1e5))], free=np.ones_like(mesh.nodes, dtype=bool)
    )
    _, gradient = everywhere.volume(everywhere.rest())
    assert linear.pressure_load == pytest.approx(gradient, abs=1e-12 * np.abs(gradient).max())


def test_half_and_whole_give_the_same_answer() -> None:
    body = block()
    body = type(body)(
        (body.lines[0], np.array([-6.0, -2.0, 0.0, 2.0, 6.0]) * 1e-3, body.lines[2]),
        np.repeat(body.fill, [1, 2, 1], axis=1), body.regions, body.place, True,
    )  # fmt: skip
    law, tips, volumes = LAWS["neo-hooke"], [], []
    for mesh in (mesh_body(body), mesh_body(body.half())):
        system, solver = system_of(mesh, law, gravity=(0.0, 0.0, -9.81))
        found = solve_equilibrium(system, solver, system.rest(), Target(8e3), tolerance=1e-10)
        assert isinstance(found, Equilibrium)
        tips.append(found.state.displacement[mesh.underside_line[-1]])
        volumes.append(found.volume)
    assert np.abs(tips[0]).max() > 1e-5
    assert tips[1] == pytest.approx(tips[0], abs=1e-9 * 12e-3)
    assert 2 * volumes[1] == pytest.approx(volumes[0], rel=1e-9)


def test_superlu_gives_what_pardiso_gives() -> None:
    from actuators.mechanics.direct_solver import FactorizationError, SuperLuSolver

    system, solver = system_of(mesh_body(block()), LAWS["neo-hooke"])
    system.linearise(system.rest(), 0.0)
    other = SuperLuSolver(system.indptr, system.indices)
    side = np.random.default_rng(1).standard_normal(system.unknowns)
    for each in (solver, other):
        assert not each.factorised
        with pytest.raises(FactorizationError):  # the library would end the process
            each.solve(side)
        each.factorize(system.values)
        assert each.factorised
    assert other.solve(side) == pytest.approx(solver.solve(side), rel=1e-6, abs=1e-9)
