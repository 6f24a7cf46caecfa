"""The linear system against a blind minimisation of all seven unknowns."""

import dataclasses

import numpy as np
import pytest
from scipy.optimize import minimize

from actuators.mechanics.energy_model import (
    Layers,
    oblique_layers,
    plate_strains,
    plate_strains_compressible,
    rod_strains,
)

MU = 161e3


def some_layers(theta: float = 0.9, top_shear: float = 40e3) -> Layers:
    mm = {"half_gap": 1.5, "wall_thickness": 1.415, "half_chamber": 1.085, "width": 15.0,
          "chamber_width": 11.0, "bottom_thickness": 3.5, "foot_height": 2.0, "wall_height": 7.0,
          "roof_thickness": 2.0}  # fmt: skip
    return oblique_layers(
        theta=np.array(theta), bottom_shear=np.array(MU), top_shear=np.array(top_shear),
        **{name: np.array(value * 1e-3) for name, value in mm.items()},
    )  # fmt: skip


def potential(layers: Layers, poisson: float, unknowns: np.ndarray) -> float:
    """Energy minus work at unit pressure by quadrature over the height, written from the physics
    notes and not from the code under test. Unknowns e1 e2 e3 k1 k2 k3 phi."""
    e, k, phi = unknowns[:3], unknowns[3:6], unknowns[6]
    points, weights = np.polynomial.legendre.leggauss(3)
    total = 0.0
    for i in range(len(layers.rubber)):
        lower, upper = layers.height[i], layers.height[i + 1]
        for point, weight in zip(points, weights, strict=True):
            z = (lower + upper) / 2 + point * (upper - lower) / 2
            dz = weight * (upper - lower) / 2
            strain = e + k * z
            j1, j2 = strain.sum(), (strain**2).sum()
            youngs = 2 * layers.shear_modulus[i] * (1 + poisson)
            energy = youngs / (2 * (1 + poisson)) * (j2 + poisson / (1 - 2 * poisson) * j1**2)
            across = (
                strain[0] * np.sin(layers.theta - phi) ** 2
                + strain[1] * np.cos(layers.theta - phi) ** 2
            )
            total += (energy * layers.rubber[i] - across * layers.air[i]) * dz
    return float(total)


@pytest.mark.parametrize(("theta", "top_shear"), [(0.9, 40e3), (1.5707963, MU), (0.4, 15.7e3)])
def test_phi_equals_theta_is_the_minimum_over_all_seven_unknowns(
    theta: float, top_shear: float
) -> None:
    layers, poisson = some_layers(theta, top_shear), 0.45
    linear = plate_strains_compressible(layers, poisson)
    scale = np.append(np.abs(linear), 1.0)
    size = abs(potential(layers, poisson, np.append(linear, theta)))

    def objective(scaled: np.ndarray) -> float:
        return potential(layers, poisson, scaled * scale) / size

    rng = np.random.default_rng(11)
    for start_angle in (theta + 0.6, theta - 0.5):
        start = np.append(rng.normal(size=6) * 0.3, start_angle)
        found = minimize(objective, start, method="BFGS", options={"gtol": 1e-9}).x * scale
        # 1e-3: the energy is flat at its minimum and the gradient is taken by differences
        assert found[6] == pytest.approx(theta, abs=1e-3)
        np.testing.assert_allclose(found[:6], linear, rtol=1e-3)


def test_rubber_that_keeps_its_volume_is_the_limit_of_the_six_by_six_system() -> None:
    layers = some_layers()
    exact = plate_strains(layers)
    errors = [
        np.abs(plate_strains_compressible(layers, nu)[[0, 1, 3, 4]] / exact - 1).max()
        for nu in (0.49, 0.499, 0.4999)
    ]
    # the distance from nu = 1/2 shrinks tenfold each time, and with it the difference
    assert errors[1] < errors[0] / 8
    assert errors[2] < errors[1] / 8
    assert errors[2] < 1e-3


def test_curvature_along_the_chambers_is_minus_half_the_one_across() -> None:
    plate = plate_strains(some_layers())
    assert plate[2] / plate[3] == pytest.approx(-0.5, rel=1e-12)


def test_bending_vanishes_where_the_tangent_of_theta_is_one_over_root_two() -> None:
    critical = np.arctan(1 / np.sqrt(2))  # 35.26 degrees; its complement is not special
    bending = [rod_strains(some_layers(t))[2] for t in (critical - 0.01, critical, critical + 0.01)]
    assert bending[0] < 0 < bending[2]
    assert abs(bending[1]) < 1e-12 * bending[2] / 0.01
    assert rod_strains(some_layers(np.pi / 2 - critical))[2] > 0


def test_at_ninety_degrees_nothing_twists() -> None:
    strains = rod_strains(some_layers(np.pi / 2))
    assert abs(strains[1]) < 1e-12 * strains[2]


def test_a_batch_of_designs_answers_as_one_by_one() -> None:
    angles = np.linspace(0.3, 1.5, 7)
    single = np.array([rod_strains(some_layers(t)) for t in angles])
    mm = 1e-3
    batch = rod_strains(
        oblique_layers(
            theta=angles, half_gap=np.array(1.5 * mm), wall_thickness=np.array(1.415 * mm),
            half_chamber=np.array(1.085 * mm), width=np.array(15 * mm),
            chamber_width=np.array(11 * mm), bottom_thickness=np.array(3.5 * mm),
            foot_height=np.array(2 * mm), wall_height=np.array(7 * mm),
            roof_thickness=np.array(2 * mm), bottom_shear=np.array(MU), top_shear=np.array(40e3),
        )
    )  # fmt: skip
    np.testing.assert_allclose(batch, single, rtol=1e-12)


def test_a_sheet_moves_the_neutral_plane_into_itself() -> None:
    """A stiff sheet holds the axis where it lies; a feather-light one changes nothing."""
    plain = some_layers(np.pi / 2)
    height = np.array(1.2e-3)
    stiff = plate_strains(dataclasses.replace(plain, sheet=np.array(1e6), sheet_height=height))
    light = plate_strains(dataclasses.replace(plain, sheet=np.array(1e-9), sheet_height=height))
    assert stiff[1] + stiff[3] * 1.2e-3 == pytest.approx(0.0, abs=1e-6 * abs(stiff[1]))
    assert stiff[3] > 0
    np.testing.assert_allclose(light, plate_strains(plain), rtol=1e-6)
