"""Constant-strain segments and helices, also where the angle or the bending vanishes."""

from fractions import Fraction
from math import factorial

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from actuators.mechanics.rod.rotation import helix, segment, sinc_family, skew


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-4, 0.09999, 0.10001, 0.5, 3.0])
def test_sinc_family_is_its_taylor_series(angle: float) -> None:
    a = Fraction(angle)
    for found, first in zip(sinc_family(np.array(angle)), (1, 2, 3), strict=True):
        exact = sum(Fraction((-1) ** n, factorial(2 * n + first)) * a ** (2 * n) for n in range(25))
        # a - sin a loses four digits just above the border
        assert float(found) == pytest.approx(float(exact), rel=1e-12)


def test_segment_follows_the_frames_differential_equation() -> None:
    strain, length = np.array([0.1, 5.0, -20.0, 9.0]), 0.15

    def rate(_: float, state: np.ndarray) -> np.ndarray:
        frame = state[3:].reshape(3, 3)
        return np.concatenate([frame[:, 0] * (1 + strain[0]), (frame @ skew(strain[1:])).ravel()])

    start = np.concatenate([np.zeros(3), np.eye(3).ravel()])
    end = solve_ivp(rate, (0, length), start, rtol=1e-11, atol=1e-13).y[:, -1]
    turn, advance = segment(strain, length)
    np.testing.assert_allclose(advance, end[:3], atol=1e-10)
    np.testing.assert_allclose(turn.ravel(), end[3:], atol=1e-9)


def test_straight_segment_only_stretches() -> None:
    turn, advance = segment(np.array([0.25, 0.0, 0.0, 0.0]), 0.08)
    np.testing.assert_array_equal(turn, np.eye(3))
    np.testing.assert_allclose(advance, [0.1, 0, 0], rtol=1e-15)


def test_positive_bending_curls_towards_the_bottom_layer() -> None:
    _, advance = segment(np.array([0.0, 0.0, 3.0, 0.0]), 0.1)
    assert advance[2] < 0
    assert advance[1] == 0


def test_helix_winds_through_the_points_of_its_segment() -> None:
    bending, torsion = 30.0, 12.0
    radius, pitch = helix(np.array(bending), np.array(torsion))
    alpha = np.hypot(bending, torsion)
    # one turn of the helix is 2 pi / alpha of rod and advances by the pitch
    _, once = segment(np.array([0.0, torsion, bending, 0.0]), 2 * np.pi / alpha)
    assert np.linalg.norm(once) == pytest.approx(float(pitch), rel=1e-12)
    # half a turn is half the pitch along and a diameter across
    _, half = segment(np.array([0.0, torsion, bending, 0.0]), np.pi / alpha)
    assert np.linalg.norm(half) == pytest.approx(np.hypot(pitch / 2, 2 * radius), rel=1e-12)


@pytest.mark.parametrize("theta_deg", [35.26438968, 54.73561032])
def test_helix_at_the_critical_angle_and_its_complement(theta_deg: float) -> None:
    """Chamber curvatures k1 = -k2/2: the bending vanishes at 35.26 degrees, where the rod twists
    about itself (R = 0, so 1/R is infinite and the curvature is not), and not at 54.74."""
    t, k2 = np.radians(theta_deg), 20.0
    bending = -k2 / 2 * np.cos(t) ** 2 + k2 * np.sin(t) ** 2
    torsion = 1.5 * k2 * np.sin(t) * np.cos(t)
    radius, pitch = helix(np.array(bending), np.array(torsion))
    assert np.isfinite(radius)
    assert np.isfinite(pitch)
    if theta_deg < 45:
        assert radius < 1e-9
        assert pitch == pytest.approx(2 * np.pi / torsion, rel=1e-6)
    else:
        assert radius == pytest.approx(bending / (bending**2 + torsion**2))


def test_a_straight_rod_has_an_infinite_helix() -> None:
    radius, pitch = helix(np.zeros(1), np.zeros(1))
    assert np.isinf(radius[0])
    assert np.isinf(pitch[0])
