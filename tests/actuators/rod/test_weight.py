"""A clamped rod under its own weight, against the elastica and linear beam theory."""

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from actuators.mechanics.rod import Rod, end_turn, follow_pressures

LENGTH, GRAVITY = 0.1, (0.0, 0.0, -9.81)


def uniform(
    droop: float, pieces: int, *, height: float = 0.0, free: float = 0.0, neutral: float = 0.0
) -> Rod:
    """Rod with w L^3 / EI = ``droop``, its neutral axis at height ``neutral``."""
    mass = 0.05
    bending = mass * 9.81 * LENGTH**2 / droop
    axial = 1e7
    stiffness = np.diag([axial, bending * 0.8, bending + axial * neutral**2, 2 * bending])
    stiffness[0, 2] = stiffness[2, 0] = axial * neutral
    compliance = np.tile(np.linalg.inv(stiffness), (pieces, 1, 1))
    strains = np.zeros((pieces, 4))
    strains[:, 2] = free
    strains[:, 0] = -neutral * free
    return Rod(
        length=np.full(pieces, LENGTH / pieces), free=strains, compliance=compliance,
        bending=np.linalg.inv(compliance[:, 1:, 1:]), mass=np.full(pieces, mass / pieces),
        mass_height=np.full(pieces, height), chambered=np.ones(pieces, dtype=bool),
    )  # fmt: skip


def elastica(droop: float) -> np.ndarray:
    """Tip (x, z)/L of the heavy cantilever: theta'' = -droop (1 - s) cos theta, s in 0..1."""

    def rate(s: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.stack([y[1], -droop * (1 - s) * np.cos(y[0]), np.cos(y[0]), -np.sin(y[0])])

    def ends(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.array([a[0], b[1], a[2], a[3]])

    s = np.linspace(0, 1, 200)
    guess = np.zeros((4, len(s)))
    for load in np.linspace(0.1, 1, 8) * droop:
        solution = solve_bvp(
            lambda s, y, load=load: rate(s, y) * [[1], [load / droop], [1], [1]], ends, s, guess,
            tol=1e-8, max_nodes=20000,
        )  # fmt: skip
        s, guess = solution.x, solution.y
    return guess[2:, -1]


@pytest.mark.parametrize("droop", [0.5, 3.0, 20.0, 100.0])
def test_heavy_cantilever_follows_the_elastica(droop: float) -> None:
    path = follow_pressures(uniform(droop, 200), np.zeros(1), GRAVITY)
    found = path.positions[0, -1, [0, 2]] / LENGTH
    # 200 midpoint pieces: error of order 1/200^2 times the droop
    np.testing.assert_allclose(found, elastica(droop), atol=2e-4)


def test_error_falls_with_the_square_of_the_pieces() -> None:
    exact = follow_pressures(uniform(3.0, 384), np.zeros(1), GRAVITY).positions[0, -1, 2]
    errors = [
        abs(follow_pressures(uniform(3.0, n), np.zeros(1), GRAVITY).positions[0, -1, 2] - exact)
        for n in (12, 24, 48)
    ]
    assert 3.5 < errors[0] / errors[1] < 4.8
    assert 3.5 < errors[1] / errors[2] < 4.8
    assert errors[1] < 1e-3 * abs(exact)  # the 24 pieces that predictions use


def test_a_small_droop_is_that_of_beam_theory() -> None:
    rod = uniform(1e-4, 400)
    path = follow_pressures(rod, np.zeros(1), GRAVITY)
    assert -path.positions[0, -1, 2] / LENGTH == pytest.approx(1e-4 / 8, rel=1e-4)
    assert end_turn(path.frames)[0] == pytest.approx(1e-4 / 6, rel=1e-4)


def test_the_line_that_is_followed_does_not_matter() -> None:
    """The same rod seen from its underside and from its neutral axis, 4 mm higher, both with the
    mass on the neutral axis: the neutral line lies in the same place."""
    high, pressures = 0.004, np.array([0.0, 1.0])
    inner = follow_pressures(uniform(3.0, 40, free=9.0), pressures, GRAVITY)
    under = follow_pressures(
        uniform(3.0, 40, free=9.0, neutral=high, height=high), pressures, GRAVITY
    )
    raised = under.positions + high * under.frames[..., 2]
    raised[..., 2] -= high
    np.testing.assert_allclose(raised, inner.positions, atol=2e-6)


def test_a_rod_hanging_down_hangs_straight() -> None:
    path = follow_pressures(uniform(5.0, 30), np.zeros(1), (9.81, 0.0, 0.0))
    np.testing.assert_allclose(path.positions[0, -1, 1:], 0, atol=1e-12)


def test_sideways_weight_bends_sideways_and_mirrors() -> None:
    one = follow_pressures(uniform(2.0, 30), np.zeros(1), (0.0, 9.81, 0.0)).positions[0, -1]
    other = follow_pressures(uniform(2.0, 30), np.zeros(1), (0.0, -9.81, 0.0)).positions[0, -1]
    assert one[1] > 0
    np.testing.assert_allclose(other, one * [1, -1, 1], atol=1e-12)


def test_without_weight_the_rod_takes_its_free_strains() -> None:
    rod = uniform(2.0, 30, free=40.0)
    path = follow_pressures(rod, np.array([0.0, 1.0, 3.0]), None)
    np.testing.assert_array_equal(path.strains[2], 3 * rod.free)
    # three times 40 /m over 0.1 m is 12 rad: almost two turns, counted
    np.testing.assert_allclose(end_turn(path.frames), [0.0, 4.0, 12.0], atol=1e-12)


def test_frames_stay_rotations() -> None:
    frames = follow_pressures(uniform(8.0, 60, free=30.0), np.linspace(0, 3, 9), GRAVITY).frames
    product = frames @ np.swapaxes(frames, -1, -2)
    np.testing.assert_allclose(product, np.broadcast_to(np.eye(3), product.shape), atol=1e-12)


def test_a_hopeless_rod_ends_with_what_was_found() -> None:
    """A rod a hundred thousand times too soft: whatever happens, no NaN and no endless loop."""
    path = follow_pressures(uniform(1e5, 24, free=50.0), np.linspace(0, 1, 5), GRAVITY)
    assert len(path.positions) <= 5
    assert np.all(np.isfinite(path.positions))
