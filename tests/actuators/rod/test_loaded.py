"""A rod under tip force, outside pressure and against obstacles, held to closed forms."""

import numpy as np
import pytest

from actuators.mechanics.rod import follow_pressures
from actuators.mechanics.rod.chain import Chain, Law, Obstacles, no_obstacles
from actuators.mechanics.rod.follow import Laws, LoadedPath, follow_laws
from actuators.mechanics.rod.kinematics import resultants, tangent
from tests.actuators.rod.test_weight import GRAVITY, uniform

LENGTH, PIECES, RIGIDITY = 0.1, 200, 1e-3
STIFF = 1e5


def chain(pieces: int = PIECES, **loads: object) -> Chain:
    bare = Chain(
        length=np.full(pieces, LENGTH / pieces), weight=np.zeros(pieces), height=np.zeros(pieces),
        gravity=np.array([0.0, 0.0, -1.0]), width=np.full(pieces, 0.02), outside=0.0,
        tip_force=np.zeros(3), tip_height=0.0,
    )  # fmt: skip
    return bare._replace(**loads)  # pyright: ignore[reportArgumentType]


def laws(curvature: float = 0.0, shear: float = STIFF, pieces: int = PIECES) -> Laws:
    free = np.zeros((1, pieces, 6))
    free[..., 2] = curvature
    stiffness = np.diag([STIFF, RIGIDITY, RIGIDITY, RIGIDITY, shear, shear])
    every = np.broadcast_to(stiffness, (1, pieces, 6, 6))
    return Laws(free, every, np.zeros((pieces, 2)))


def obstacle(kind: int, place: tuple[float, ...], direction: tuple[float, ...], radius: float,
             force: float) -> Obstacles:  # fmt: skip
    share = np.full((PIECES + 1, 1), LENGTH / PIECES)
    share[[0, -1]] /= 2
    zero = np.zeros_like(share)
    return Obstacles(
        zero, zero, share, np.array([kind]), np.array([place]), np.array([direction]),
        np.array([radius]), force / (LENGTH / 8) / (5e-5 * LENGTH), 2.5e-5 * LENGTH,
    )  # fmt: skip


def tip(path: LoadedPath) -> np.ndarray:
    assert len(path.positions) == 1
    return path.positions[0, -1]


@pytest.mark.parametrize(
    ("load", "down", "back"),
    [(1, 0.30172, 0.05643), (2, 0.49346, 0.16064), (5, 0.71379, 0.38763), (10, 0.81061, 0.55500)],
)
def test_a_tip_force_bends_a_cantilever_as_the_elastica(
    load: float, down: float, back: float
) -> None:
    """Elliptic integrals (shared reference table); 200 midpoint pieces leave 1e-4."""
    force = np.array([0.0, 0.0, -load * RIGIDITY / LENGTH**2])
    found = tip(follow_laws(laws(), chain(tip_force=force), no_obstacles(PIECES))) / LENGTH
    np.testing.assert_allclose(found[[0, 2]], [1 - back, -down], atol=2e-4)


def test_both_solvers_of_a_heavy_rod_agree() -> None:
    rod = uniform(8.0, 40, free=20.0, neutral=0.003, height=0.002)
    pressures = np.array([0.0, 1.0])
    plain = follow_pressures(rod, pressures, GRAVITY)
    stiffness = np.zeros((2, 40, 6, 6))
    stiffness[..., :4, :4] = np.linalg.inv(rod.compliance)
    stiffness[..., 4, 4] = stiffness[..., 5, 5] = 1e9  # no shear
    free = np.zeros((2, 40, 6))
    free[..., :4] = pressures[:, None, None] * rod.free
    heavy = chain(40)._replace(length=rod.length, weight=rod.mass * 9.81, height=rod.mass_height)
    other = follow_laws(Laws(free, stiffness, np.zeros((40, 2))), heavy, no_obstacles(40))
    np.testing.assert_allclose(other.positions, plain.positions, atol=1e-8)


def test_outside_pressure_stays_normal_to_the_underside() -> None:
    """What acts on any part of a curve under normal pressure q per length is q times its chord,
    turned by a right angle: the moment at s is q |x(L) - x(s)|^2 / 2, however it has curled."""
    pressure = 600.0
    line = pressure * 0.02
    path = follow_laws(
        laws(curvature=2 * np.pi / LENGTH), chain(outside=pressure), no_obstacles(PIECES)
    )
    x = path.positions[0]
    middle = (x[1:] + x[:-1]) / 2  # of the chord: off the arc by 1e-5 of the length
    moment = RIGIDITY * (path.strains[0, :, 2] - 2 * np.pi / LENGTH)
    expected = -line * ((x[-1] - middle) ** 2).sum(axis=1) / 2
    assert abs(expected).max() > 0.05 * RIGIDITY * 2 * np.pi / LENGTH  # the load does bend it
    np.testing.assert_allclose(moment, expected, atol=2e-3 * abs(expected).max())


def test_a_bending_rod_held_by_a_plate_presses_as_a_propped_cantilever() -> None:
    """A free curvature k lowers the tip by k L^2/2; the plate brings it back with 3 k EI / 2 L."""
    curvature = 0.2  # small, so that beam theory holds
    force = 1.5 * curvature * RIGIDITY / LENGTH
    plate = obstacle(0, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 0.0, force)
    path = follow_laws(laws(curvature), chain(), plate)
    # 5 %: the plate gives way, so that the last 3 % of the rod share the force
    assert path.obstacle_force[0, 0, 2] == pytest.approx(-force, rel=0.05)
    assert path.penetration[0, 0] < 0.03 * curvature * LENGTH**2 / 2


def test_a_heavy_rod_lies_on_a_plate_with_all_but_what_the_clamp_bears() -> None:
    weight = 2.0
    heavy = chain(weight=np.full(PIECES, weight / PIECES))
    gap = 0.005
    plate = obstacle(0, (0.0, 0.0, -gap), (0.0, 0.0, 1.0), 0.0, weight)
    path = follow_laws(laws(), heavy, plate)
    borne = -path.obstacle_force[0, 0, 2]
    # far from the clamp it lies flat; the part that hangs free is that of a clamped beam with a
    # built-in landing: w a^4 / (72 EI) = gap, of which the clamp bears 2/3 (w a)
    hanging = (72 * RIGIDITY * gap / (weight / LENGTH)) ** 0.25
    assert borne == pytest.approx(weight - 2 / 3 * weight / LENGTH * hanging, rel=0.03)
    assert abs(path.positions[0, 3 * PIECES // 4 :, 2] + gap).max() < 0.02 * gap


def test_a_rod_wraps_around_a_cylinder() -> None:
    radius = 0.02
    force = RIGIDITY / radius**2
    bar = obstacle(1, (0.0, 0.0, -radius), (0.0, 1.0, 0.0), radius, force)
    growing = laws(curvature=1.5 / radius)
    steps = np.linspace(0, 1, 16)[:, None, None]
    path = follow_laws(
        Laws(
            steps * growing.free, np.repeat(growing.stiffness, 16, axis=0), np.zeros((PIECES, 2))
        ),
        chain(), bar,
    )  # fmt: skip
    assert len(path.positions) == 16
    inside = path.strains[-1, PIECES // 8 : PIECES // 2, 2]  # its end stands off on the tip
    np.testing.assert_allclose(inside, 1 / radius, rtol=0.01)
    distance = np.hypot(path.positions[-1, :, 0], path.positions[-1, :, 2] + radius)
    assert abs(distance / radius - 1)[: PIECES // 2].max() < 0.01


def test_shear_adds_its_own_deflection() -> None:
    shear, force = 2.0, 1e-4
    load = chain(tip_force=np.array([0.0, 0.0, force]))
    found = tip(follow_laws(laws(shear=shear), load, no_obstacles(PIECES)))[2]
    expected = force * LENGTH**3 / 3 / RIGIDITY + force * LENGTH / shear
    assert found == pytest.approx(expected, rel=1e-4)


def test_a_rod_beyond_help_ends_with_what_was_found() -> None:
    """The shape under the largest share of the loads that it bears, at worst the unloaded one."""
    for size, most in ((1e6, 1.0), (1e40, 0.0)):
        load = chain(tip_force=np.array([0.0, 0.0, -size]))
        path = follow_laws(laws(), load, no_obstacles(PIECES))
        assert len(path.positions) == 1
        assert np.all(np.isfinite(path.positions))
        assert path.loads <= most


FURTHER = 0.004
"""How fast bending takes from the stiffness by its square; by the first power tests say."""


def bent_law(growth: float) -> Law:
    rng = np.random.default_rng(3)
    root = rng.normal(size=(6, 6))
    stiffness = (root @ root.T + 6 * np.eye(6))[None]
    none = np.zeros((1, 1, 6))
    return Laws(none, stiffness[None], np.array([[growth, FURTHER]]), none, none).at(0)


def more(law: Law, growth: float, moment: float) -> float:
    """By what the curvature exceeds the linear one: C_22 M = k - growth k^2/2 - FURTHER k^3."""
    linear = law.compliance[0, 2, 2] * moment
    roots = np.roots([-FURTHER, -growth / 2, 1.0, -linear])
    real = roots[np.abs(roots.imag) < 1e-9].real
    return float(real[np.abs(real - linear).argmin()] - linear)


def parting_law(growth: float, away: float) -> Law:
    """Walls that lie ``away`` times the resultants of a test's strain from parting."""
    parted = np.array([0.002, 0.03, 0.02, 0.0, 0.0, 0.0])
    whole = bent_law(growth)
    release = parted * 5.0 / away
    laws = Laws(
        whole.free[None], whole.stiffness[None], whole.bent[:, :2], parted[None, None],
        release[None, None],
    )  # fmt: skip
    return laws.at(0)


@pytest.mark.parametrize("moment", [0.7, -0.7, 3.0])
def test_the_stiffness_falls_as_a_moment_bends(moment: float) -> None:
    law = bent_law(0.05)
    strain = law.compliance[:, :, 2] * moment
    strain[0, 2] += more(law, 0.05, moment)
    assert law.bent[0, 2] < strain[0, 2] < law.bent[0, 3]
    held = np.zeros(6)
    resultants(0, law, strain, np.zeros(6), held)
    np.testing.assert_allclose(held, moment * np.eye(6)[2], atol=1e-12)


def test_bending_leaves_a_piece_some_stiffness_however_far_it_goes() -> None:
    """Beyond what was measured the moment goes on to grow with the curvature, both ways."""
    law = bent_law(0.5)
    d, held = np.zeros(6), np.zeros(6)
    found: list[float] = []
    for curvature in np.linspace(-50.0, 50.0, 201):
        strain = np.zeros((1, 6))
        strain[0, 2] = curvature
        resultants(0, law, strain, d, held)
        found.append(float(held[2]))
    assert np.all(np.diff(found) > 0.0)


@pytest.mark.parametrize("law", [bent_law(0.03), parting_law(0.03, 0.05), parting_law(0.03, 50.0)])
def test_the_laws_tangent_is_its_derivative(law: Law) -> None:
    strain = np.random.default_rng(4).normal(size=(1, 6)) * 0.1
    found, held, d = np.zeros((6, 6)), np.zeros((2, 6)), np.zeros(6)
    numeric = np.zeros((6, 6))
    for a in range(6):
        for n, sign in enumerate((1.0, -1.0)):
            moved = strain.copy()
            moved[0, a] += sign * 1e-6
            resultants(0, law, moved, d, held[n])
        numeric[:, a] = (held[0] - held[1]) / 2e-6
    resultants(0, law, strain, d, held[0])
    tangent(0, law, d, held[0], found)
    np.testing.assert_allclose(found, numeric, rtol=1e-6, atol=1e-7)


def test_walls_part_without_a_jump() -> None:
    """Towards the plane on which they come apart resultants are the same from both sides, and
    beyond it the strains are those of the law without the walls."""
    law = parting_law(0.03, 1.0)
    direction = law.release[0] / np.linalg.norm(law.release[0]) ** 2
    d, held = np.zeros(6), np.zeros((2, 6))
    moment = direction[2]
    strain = law.compliance[0] @ direction
    strain[2] += more(law, 0.03, moment)
    for n, side in enumerate((1 - 1e-9, 1 + 1e-9)):
        resultants(0, law, (strain * side)[None], d, held[n])
    np.testing.assert_allclose(held[0], held[1], rtol=1e-6, atol=1e-8)
    np.testing.assert_allclose(held[0], direction, rtol=1e-6, atol=1e-8)
    far = np.linalg.inv(law.apart[0]) @ (2 * direction) - law.parted[0]
    far[2] += more(law, 0.03, 2 * moment)
    resultants(0, law, far[None], d, held[0])
    np.testing.assert_allclose(held[0], 2 * direction, rtol=1e-9, atol=1e-12)


def test_scaled_loads_and_softer_obstacles_keep_the_rest() -> None:
    full = chain(outside=10.0, tip_force=np.array([0.0, 1.0, 2.0]))
    half = full.scaled(0.5)
    assert (half.outside, half.tip_force[2]) == (5.0, 1.0)
    assert half.length is full.length
