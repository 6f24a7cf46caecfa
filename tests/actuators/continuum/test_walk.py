"""Volume control, suction and arc length: past the limit points of pressure, then of volume."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from actuators.geometry import CAVITY, Body, Region
from actuators.materials import HyperelasticLaw, Material, MooneyRivlin, NeoHooke
from actuators.mechanics.continuum.findings import path_notes
from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.newton import (
    Equilibrium,
    Failure,
    Target,
    solve_equilibrium,
)
from actuators.mechanics.continuum.path import Path, PathFollower
from actuators.mechanics.continuum.state import State
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.continuum.walk import Walk
from actuators.mechanics.direct_solver import open_solver
from actuators.mechanics.response import Outcome
from actuators.meshing import HexMesh, mesh_body
from benchmarks.mini_pneu_net import GRAVITY, MATERIALS, mini_pneu_net

OUTER = 10e-3


def octant(inner: float, parts: int) -> HexMesh:
    """An eighth of a hollow sphere; its planes pass through the origin and close the cavity."""

    def place(lattice: np.ndarray) -> np.ndarray:
        polar, around, r = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
        return np.stack(
            [r * np.sin(polar) * np.cos(around), r * np.sin(polar) * np.sin(around),
             r * np.cos(polar)], axis=-1,
        )  # fmt: skip

    quarter = np.array([0.0, np.pi / 2])
    body = Body(
        (quarter, quarter, np.array([0.0, inner, OUTER])),
        np.array([[[CAVITY, 0]]], dtype=np.int8), (Region("rubber", "test"),), place, False,
    )  # fmt: skip
    return mesh_body(body, uniform=(parts, parts, 1 if inner > 0.9 * OUTER else parts))


def sphere(law: HyperelasticLaw, inner: float, parts: int = 3) -> ContinuumSystem:
    mesh = octant(inner, parts)
    free = np.ones_like(mesh.nodes, dtype=bool)
    free[np.abs(mesh.nodes) < 1e-12 * OUTER] = False
    material = Material("test", "test", law, 1000.0, "test", bulk_to_shear=1e6)
    return ContinuumSystem(mesh, [material], free=free)


def reach(system: ContinuumSystem, goal: Goal) -> Path:
    return PathFollower(system, open_solver(system.indptr, system.indices)).reach(goal)


def rest_volume(system: ContinuumSystem) -> float:
    return system.volume(system.rest())[0]


def test_a_thick_sphere_filled_to_a_volume_reports_the_limit_it_passed() -> None:
    system = sphere(NeoHooke(4e4), 5e-3)
    start = rest_volume(system)
    path = reach(system, Goal(8.0 * start, by_volume=True, steps=7))
    assert path.outcome is Outcome.CONVERGED
    volumes = [e.volume / start for e in path.points]
    assert volumes == pytest.approx(np.arange(1.0, 9.0), rel=1e-6)
    # reference/fe_benchmarks.csv, A/B = 0.5: p/mu = 0.806927 at an inner stretch of 2; the maximum
    # 0.816424 lies at 1.8281
    assert path.points[-1].pressure / 4e4 == pytest.approx(0.806927, rel=5e-3)
    assert path.limit is not None
    assert path.limit.pressure / 4e4 == pytest.approx(0.816424, rel=5e-3)
    assert (path.limit.volume / start) ** (1 / 3) == pytest.approx(1.8281, abs=0.02)
    assert path.by_arc == 0


def test_pressure_control_ends_at_the_same_limit() -> None:
    path = reach(sphere(NeoHooke(4e4), 5e-3), Goal.pressure(60e3))
    assert path.outcome is Outcome.LIMIT_POINT
    assert path.limit is path.points[-1]
    assert path.points[-1].pressure / 4e4 == pytest.approx(0.816424, rel=5e-3)


@pytest.mark.parametrize("by_arc", [False, True])
def test_a_mooney_balloon_passes_its_maximum_and_its_minimum(by_arc: bool) -> None:
    """Membrane: p = 4 (h/R) (1/L - 1/L^7) (c1 + c2 L^2), maximum at L = 1.476, minimum at 3.143
    for c2/c1 = 0.1 (reference/fe_benchmarks.csv); a wall of 2 % follows it closely."""
    c1, inner = 2e4, 9.8e-3
    system = sphere(MooneyRivlin(c1, 0.1 * c1), inner)
    solver = open_solver(system.indptr, system.indices)

    def solve(state, target):
        return solve_equilibrium(system, solver, state, target, tolerance=1e-6)

    first = PathFollower(system, solver).follow(0.0, None).points[0]
    walk = Walk(system, solve, [first], 0.05 * first.volume)
    states: list[Equilibrium] = [first]
    while states[-1].volume < 60 * first.volume:
        walk.by_arc = by_arc and len(states) > 2
        found = walk.advance()
        assert found is not None, walk.reason
        states.append(found)
    stretch = np.array([(e.volume / first.volume) ** (1 / 3) for e in states])
    # stretch of the wall's middle surface, from that of the incompressible wall's inside
    middle = ((stretch**3 - 1) * (inner / 9.9e-3) ** 3 + 1) ** (1 / 3)
    pressure = np.array([e.pressure for e in states])
    membrane = 4 * 0.2e-3 / 9.9e-3 * (1 / middle - middle**-7) * c1 * (1 + 0.1 * middle**2)
    assert pressure == pytest.approx(membrane, rel=0.02, abs=0.01 * membrane.max())
    rising = np.diff(pressure) > 0
    turns = stretch[1:-1][rising[1:] != rising[:-1]]
    assert turns == pytest.approx([1.476, 3.143], abs=0.35)


def test_a_walk_does_not_go_back_the_way_it_came() -> None:
    system = sphere(NeoHooke(4e4), 5e-3, parts=2)
    solver = open_solver(system.indptr, system.indices)
    first = PathFollower(system, solver).follow(0.0, None).points[0]
    walk = Walk(
        system, lambda state, target: solve_equilibrium(system, solver, state, target),
        [first], 0.2 * first.volume,
    )  # fmt: skip
    states = [first, *(walk.advance() for _ in range(7))]
    walk.by_arc = True
    ahead = walk.advance()
    assert ahead is not None
    assert states[-1] is not None
    assert ahead.volume > states[-1].volume
    walk.trail.states = [ahead, states[-1]]
    assert walk.advance() is None
    assert "already found" in walk.reason


def test_a_soft_pneu_net_is_followed_where_its_volume_turns_back() -> None:
    """One chamber balloons and drains the others: volume control stalls at V/V0 of about
    3.45, where an independent engine came to 3.46."""
    mesh = mesh_body(mini_pneu_net().half())
    system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh), gravity=GRAVITY)
    start = rest_volume(system)
    path = reach(system, Goal(5.0 * start, by_volume=True))
    assert path.outcome is Outcome.CONVERGED
    assert path.limit is not None
    assert path.limit.pressure == pytest.approx(17.04e3, abs=0.02e3)
    volumes = np.array([e.volume / start for e in path.points])
    assert volumes[-1] == pytest.approx(5.0, rel=1e-5)
    assert path.limit in path.points
    back = np.flatnonzero(np.diff(volumes) < 0)
    assert len(back) > 2
    assert volumes[back[0]] == pytest.approx(3.445, abs=0.03)
    assert path.by_arc > 10
    # every step is small: nothing was jumped over
    steps = np.diff([system.unknowns_of(e.state) for e in path.points], axis=0)
    assert np.abs(steps).max() < 0.2 * 80e-3


def test_suction_shrinks_the_cavity() -> None:
    system = sphere(NeoHooke(4e4), 5e-3)
    start = rest_volume(system)
    by_pressure = reach(system, Goal.pressure(-10e3, [-5e3, -10e3]))
    assert [e.pressure for e in by_pressure.points] == pytest.approx([0, -5e3, -10e3])
    volumes = [e.volume for e in by_pressure.points]
    assert volumes == sorted(volumes, reverse=True)
    by_volume = reach(system, Goal(volumes[-1], by_volume=True))
    assert by_volume.points[-1].pressure == pytest.approx(-10e3, rel=1e-3)
    # p/mu = 2/lb + 1/(2 lb^4) - 2/la - 1/(2 la^4), lb^3 - 1 = (la^3 - 1)/8
    la = (volumes[-1] / start) ** (1 / 3)
    lb = (1 + (la**3 - 1) / 8) ** (1 / 3)
    closed = 2 / lb + 1 / (2 * lb**4) - 2 / la - 1 / (2 * la**4)
    assert pytest.approx(closed, rel=5e-3) == -10e3 / 4e4


def test_a_goal_already_reached_adds_nothing() -> None:
    system = sphere(NeoHooke(4e4), 5e-3, parts=1)
    path = reach(system, Goal(rest_volume(system), by_volume=True))
    assert len(path.points) == 1
    assert path.outcome is Outcome.CONVERGED


class TwoBranches:
    """Volume v on a branch that ends at 1, and on one beyond it: one unknown, which is v, moved by
    0.5 on the other branch."""

    mesh = SimpleNamespace(nodes=np.array([[0.0, 0.0, 0.0], [10.0, 0.0, 0.0]]))
    jump = 0.5
    """Of the pressure, from one branch to the other."""

    @staticmethod
    def state(volume: float, aside: float) -> State:
        return State(np.array([[volume, aside, 0.0]]), np.zeros((0, 4)))

    def onward(self, before: State, last: State, ratio: float) -> State:
        change = last.displacement - before.displacement
        return State(last.displacement + ratio * change, last.pressure)

    def unknowns_of(self, state: State) -> np.ndarray:
        return state.displacement.ravel()

    def solve(self, start: State, target: Target) -> Equilibrium | Failure:
        """Volumes just beyond the end are not found; farther ones cost many tangents."""
        volume = target.volume
        if volume is None or 0.95 < volume < 1.0:
            return Failure("nothing there", 12)
        near = volume >= 1.0 and start.displacement[0, 1] < 0.25
        state = self.state(volume, 0.0 if near else 0.5)
        settled = near or start.displacement[0, 1] > 0.25
        pressure = volume - 2.0 + (0.0 if near else self.jump)
        return Equilibrium(state, pressure, volume, 2 if settled else 9, 0)


def test_where_a_branch_ends_a_walk_leaps_to_the_one_it_met(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    system = TwoBranches()
    trail = [Equilibrium(system.state(v, 0.0), v - 2.0, v, 2, 0) for v in (1.6, 1.5)]

    def walk(*, leaping: bool) -> list[tuple[Equilibrium | None, bool]]:
        walk = Walk(system, system.solve, trail, -0.1, leaping=leaping)  # type: ignore[arg-type]
        found: list[tuple[Equilibrium | None, bool]] = []
        while not found or (found[-1][0] is not None and found[-1][0].volume > 0.6):
            found.append((walk.advance(0.6), walk.leapt))
        return found

    *_, (end, _) = walk(leaping=False)
    assert end is None, "under given suction there is nothing with less of it to leap to"
    found = walk(leaping=True)
    leaps = [k for k, (_, leapt) in enumerate(found) if leapt]
    assert len(leaps) == 1
    before, after = found[leaps[0] - 1][0], found[leaps[0]][0]
    assert before is not None
    assert after is not None
    assert 1.0 <= before.volume < 1.01
    assert 0.8 < after.volume <= 0.95
    assert after.state.displacement[0, 1] == 0.5
    last = found[-1][0]
    assert last is not None
    assert last.volume == pytest.approx(0.6, abs=1e-12)
    monkeypatch.setattr(TwoBranches, "jump", -0.1)
    *_, (last, _) = walk(leaping=False)
    assert last is not None, "more suction than before is on the way"


def test_a_leap_is_told_with_the_states_on_either_side() -> None:
    system = TwoBranches()
    one, other = (
        Equilibrium(system.state(v, 0.0), p, v, 2, 0)
        for v, p in ((6.58e-6, -4.24e3), (6.557e-6, -4.098e3))
    )
    path = Path([one, other], by_volume=True, leaps=[(one, other)])
    (note,) = path_notes(path, 1.0)
    assert "At 6.58 ml (-4.24 kPa)" in note
    assert "6.557 ml (-4.1 kPa)" in note
    assert "another branch" in note
    assert path_notes(replace(path, leaps=[]), 1.0) == []


class Kinked(TwoBranches):
    """One branch with a short stretch where nothing is found, as where contact jumps."""

    def __init__(self, wide: float) -> None:
        self._end = 1.0 - wide

    def solve(self, start: State, target: Target) -> Equilibrium | Failure:
        volume = target.volume
        if volume is None or self._end < volume < 1.0:
            return Failure("the correction does not shrink", 12)
        return Equilibrium(self.state(volume, 0.0), volume - 2.0, volume, 2, 0)


@pytest.mark.parametrize(("wide", "passed"), [(0.015, True), (0.06, True), (0.2, False)])
def test_a_short_stretch_without_equilibrium_is_stepped_over(wide: float, passed: bool) -> None:
    system = Kinked(wide)
    trail = [Equilibrium(system.state(v, 0.0), v - 2.0, v, 2, 0) for v in (1.06, 1.03)]
    walk = Walk(system, system.solve, trail, -0.03)  # type: ignore[arg-type]
    found = [walk.advance(0.5)]
    while found[-1] is not None and not walk.arrived:
        found.append(walk.advance(0.5))
    end = found[-1]
    assert (end is not None) == passed
    assert not walk.leapt
    assert all(e is None or not 1.0 - wide < e.volume < 1.0 for e in found)
    if end is not None:
        assert end.volume == 0.5
