"""How far answers lie apart, and what may be said about it."""

import pytest

from actuators.mechanics.ladder import Rung, difference
from actuators.mechanics.ladder.points import Typical, best_answer, measured_point
from tests.actuators.ladder.answers import made_up

ENERGY, FE5, FE2 = Rung("energy"), Rung("fe", 0.05), Rung("fe", 0.02)
USUAL = {ENERGY: Typical(0.1, 0.2, "measured")}


def test_a_tip_that_moves_a_tenth_too_far_is_ten_percent_off_wherever_the_paths_end() -> None:
    best = made_up(FE2, slope=-1.0, to=10.0, steps=7)
    for end in (4.0, 10.0, 25.0):
        apart = difference(made_up(ENERGY, slope=-1.1, to=end), best)
        assert apart is not None
        assert apart.tip == pytest.approx(0.1)
        assert apart.pressure == pytest.approx(1e3 * min(end, 10.0))


def test_turn_and_limit_pressure_are_compared_where_both_know_them() -> None:
    best = made_up(FE2, turn=2.0, limit=12.0)
    apart = difference(made_up(FE5, turn=2.2, limit=12.6), best)
    assert apart is not None
    assert apart.turn == pytest.approx(0.1)
    assert apart.limit_pressure == pytest.approx(0.05)
    without = difference(made_up(ENERGY), best)
    assert without is not None
    assert (without.turn, without.limit_pressure, without.force) == (None, None, None)


def test_an_answer_without_a_path_is_compared_with_nothing() -> None:
    nothing = made_up(FE5, to=0.0)
    assert difference(nothing, made_up(FE2)) is None


def test_the_best_answer_is_the_complete_one_with_the_smallest_estimate_of_its_own() -> None:
    coarse = made_up(FE5, estimates={"tip": 4.0})
    fine = made_up(FE2, estimates={"tip": 1.0})
    stalled = made_up(Rung("fe", 0.01), estimates={"tip": 0.5}, outcome="stalled")
    energy = made_up(ENERGY)
    assert best_answer([energy, coarse, fine, stalled], USUAL) is fine
    assert best_answer([energy, made_up(Rung("closed-form"))], USUAL) is energy
    assert best_answer([stalled], USUAL) is None


def test_a_measured_error_carries_the_best_answers_own_estimate_as_its_band() -> None:
    best = made_up(FE2, estimates={"tip": 3.0})
    point = measured_point(made_up(ENERGY, slope=-1.1), best, USUAL)
    assert point.error is not None
    assert (point.error.value, point.error.low, point.error.high) == pytest.approx(
        (0.1, 0.07, 0.13)
    )
    itself = measured_point(best, best, USUAL)
    assert itself.is_best
    assert itself.error is not None
    assert (itself.error.low, itself.error.high) == pytest.approx((0.0, 0.03))


def test_finite_elements_are_not_judged_by_an_instant_model() -> None:
    energy = made_up(ENERGY)
    coarse = made_up(Rung("fe", mesh="coarse"), slope=-2.0)
    point = measured_point(coarse, energy, USUAL)
    assert point.error is None


def test_an_answer_satisfies_an_accuracy_only_with_all_that_is_judged() -> None:
    answer = made_up(FE5, estimates={"tip": 0.8, "angle": 2.5, "volume": 9.0})
    assert answer.satisfies(0.03)
    assert not answer.satisfies(0.02)
    assert not made_up(ENERGY).satisfies(0.5)


def test_where_answers_differ_about_a_limit_point_the_highest_rung_decides() -> None:
    cell_rod = Rung("cell-rod")
    early = made_up(cell_rod, to=4.0, outcome="limit_point", limit=4.0, estimates={"tip": 3.0})
    whole = made_up(FE5, to=10.0, estimates={"tip": 4.0})
    assert best_answer([made_up(ENERGY), early], USUAL) is early
    assert best_answer([early, whole], USUAL) is whole
    beyond = measured_point(made_up(ENERGY, slope=-1.1), early, USUAL)
    assert beyond.is_contradicted
    assert beyond.apart is not None
    assert beyond.apart.pressure == pytest.approx(4e3)
    assert "goes on beyond 4 kPa" in (beyond.reason or "")
    short = measured_point(early, whole, USUAL)
    assert short.is_contradicted
    assert "limit point at 4 kPa" in (short.reason or "")
    assert not measured_point(made_up(ENERGY), whole, USUAL).is_contradicted


def test_finite_elements_on_one_mesh_decide_about_a_limit_point_without_an_estimate() -> None:
    cell_rod = made_up(Rung("cell-rod"), estimates={"tip": 9.0})
    coarse = made_up(Rung("fe", mesh="coarse"), to=4.0, outcome="limit_point", limit=4.0)
    assert best_answer([made_up(ENERGY), cell_rod, coarse], USUAL) is coarse
    beyond = measured_point(cell_rod, coarse, USUAL)
    assert beyond.is_contradicted
    assert "goes on beyond 4 kPa" in (beyond.reason or "")
    # what has no estimate of its own is no measure: the other's error stays its own estimate
    assert beyond.error_kind == "own estimate"
    itself = measured_point(coarse, coarse, USUAL)
    assert itself.is_best
    assert itself.error is None
    # alike in how they end, the one that knows its error is the best
    alike = made_up(Rung("fe", mesh="coarse"))
    assert best_answer([cell_rod, alike], USUAL) is cell_rod
    limited = made_up(FE5, to=4.1, outcome="limit_point", limit=4.1, estimates={"tip": 3.0})
    assert best_answer([cell_rod, coarse, limited], USUAL) is limited
    # one of another limit that may be anywhere, by its own words, is no better for its estimate
    lost = made_up(
        Rung("cell-rod"), to=4.6, outcome="limit_point", limit=4.6, estimates={"tip": 100.0}
    )
    assert best_answer([made_up(ENERGY), lost, coarse], USUAL) is coarse
