"""The closed-form element against quadrature, rigid motion and uniform strain."""

import numpy as np
import pytest

from actuators.mechanics.cell.element import NODES, divergence, stiffness

JACOBIAN = np.array([[2.0, 0.7, 0.1], [0.2, 1.5, -0.3], [0.0, 0.4, 1.1]])  # a skew parallelepiped
SHEAR, BULK = 3.0, 40.0


def local_nodes() -> np.ndarray:
    k, j, i = np.meshgrid(*[np.arange(3) - 1.0] * 3, indexing="ij")
    return np.stack([i.ravel(), j.ravel(), k.ravel()], axis=-1)


def gradients_at(xi: np.ndarray) -> np.ndarray:
    """dN_a/dx (27, 3) from one-dimensional Lagrange polynomials at -1, 0, 1."""
    value = np.stack([xi * (xi - 1) / 2, 1 - xi**2, xi * (xi + 1) / 2])  # (3, axis)
    slope = np.stack([xi - 0.5, -2 * xi, xi + 0.5])
    node = (local_nodes() + 1).astype(int)
    table = np.empty((NODES, 3))
    for axis in range(3):
        factors = [slope if d == axis else value for d in range(3)]
        table[:, axis] = np.prod([factors[d][node[:, d], d] for d in range(3)], axis=0)
    return table @ np.linalg.inv(JACOBIAN)


def by_quadrature() -> np.ndarray:
    """Q2/P1 stiffness with condensed pressure, 4 x 4 x 4 Gauss points, written out."""
    points, weights = np.polynomial.legendre.leggauss(4)
    deviatoric, rows, mass = np.zeros((81, 81)), np.zeros((4, 81)), np.zeros((4, 4))
    volume = np.linalg.det(JACOBIAN)
    for i in range(4):
        for j in range(4):
            for k in range(4):
                xi = np.array([points[i], points[j], points[k]])
                w = weights[i] * weights[j] * weights[k] * volume
                g = gradients_at(xi)
                strain = np.zeros((3, 3, 81))
                for a in range(3):
                    for b in range(3):
                        strain[a, b, a::3] += g[:, b] / 2
                        strain[a, b, b::3] += g[:, a] / 2
                trace = strain[0, 0] + strain[1, 1] + strain[2, 2]
                dev = strain - np.eye(3)[:, :, None] * trace / 3
                deviatoric += w * 2 * SHEAR * np.einsum("abm,abn->mn", dev, dev)
                q = np.array([1.0, *xi])
                rows += w * np.outer(q, trace)
                mass += w * np.outer(q, q)
    return deviatoric + BULK * rows.T @ np.linalg.solve(mass, rows)


def test_closed_form_is_the_integral() -> None:
    found = stiffness(JACOBIAN[None], np.array([SHEAR]), np.array([BULK]))[0]
    np.testing.assert_allclose(found, by_quadrature(), atol=1e-11 * np.abs(found).max())


def test_rigid_motion_costs_nothing() -> None:
    matrix = stiffness(JACOBIAN[None], np.array([SHEAR]), np.array([BULK]))[0]
    x = local_nodes() @ JACOBIAN.T
    shift = np.tile([1.0, -2.0, 0.5], NODES)
    spin = np.cross([0.3, -0.2, 0.9], x).ravel()
    for motion in (shift, spin):
        assert np.abs(matrix @ motion).max() < 1e-12 * np.abs(matrix).max() * np.abs(motion).max()


def test_uniform_strain_has_its_exact_energy() -> None:
    rng = np.random.default_rng(3)
    strain = rng.normal(size=(3, 3))
    strain = strain + strain.T
    matrix = stiffness(JACOBIAN[None], np.array([SHEAR]), np.array([BULK]))[0]
    u = (local_nodes() @ JACOBIAN.T @ strain.T).ravel()
    trace = np.trace(strain)
    dev = strain - np.eye(3) * trace / 3
    volume = 8 * np.linalg.det(JACOBIAN)
    exact = volume * (SHEAR * (dev**2).sum() + BULK * trace**2 / 2)
    assert u @ matrix @ u / 2 == pytest.approx(exact, rel=1e-12)


def test_divergence_is_the_change_of_volume() -> None:
    x = local_nodes() @ JACOBIAN.T
    row = divergence(JACOBIAN[None])[0, 0]
    assert row @ (0.01 * x).ravel() == pytest.approx(0.03 * 8 * np.linalg.det(JACOBIAN), rel=1e-12)
    assert row @ np.cross([0.1, 0.2, 0.3], x).ravel() == pytest.approx(0.0, abs=1e-12)
