"""Which rung is taken for an error, and which for a time."""

from dataclasses import replace

from actuators.mechanics.ladder import (
    Limit,
    Point,
    Rung,
    Span,
    as_it_went,
    at_most_error,
    at_most_seconds,
)
from actuators.mechanics.response import Outcome


def measured(rung: Rung, error: float, band: float = 0.0) -> Point:
    span = Span(error, max(error - band, 0.0), error + band)
    return Point(rung, "measured", Span(1, 1, 1), span, "against best", outcome=Outcome.CONVERGED)


def predicted(rung: Rung, error: float, seconds: float) -> Point:
    span = Span(seconds, seconds / 2, seconds * 2)
    return Point(rung, "predicted", span, Span(error, 0.0, error), "asked for")


ENERGY, FE = Rung("energy"), [Rung("fe", a) for a in (0.1, 0.05, 0.02)]
LADDER = [
    measured(ENERGY, 0.12, 0.02), predicted(FE[0], 0.1, 2), predicted(FE[1], 0.05, 5),
    predicted(FE[2], 0.02, 20),
]  # fmt: skip


def test_the_cheapest_rung_within_an_error_is_taken() -> None:
    assert [_name(at_most_error(LADDER, a).point) for a in (0.2, 0.13, 0.07, 0.02)] == [
        "energy", "fe 10 %", "fe 5 %", "fe 2 %"
    ]  # fmt: skip
    none = at_most_error(LADDER, 0.001)
    assert none.point is None
    assert "fe 2 %" in none.why


def test_the_most_accurate_rung_within_a_time_is_taken() -> None:
    assert [_name(at_most_seconds(LADDER, t).point) for t in (0.5, 3, 10, 60)] == [
        "energy", "fe 10 %", "fe 5 %", "fe 2 %"
    ]  # fmt: skip
    none = at_most_seconds([predicted(FE[2], 0.02, 20)], 3)
    assert none.point is None
    assert "quickest" in none.why


def test_an_answer_that_is_there_costs_nothing_more() -> None:
    there = [*LADDER[:2], measured(FE[2], 0.01)]
    quick = at_most_seconds(there, 0.1)
    assert _name(quick.point) == "fe 2 %"
    assert quick.why == (
        "at most 0.1 s: fe 2 %, whose answer is there already and costs nothing more "
        "(took 1 s, error up to 1 %)."
    )
    told = as_it_went(Limit(seconds=0.1), there[2], there, 30)
    assert "costs nothing more" in told.why
    assert "more than 0.1 s" not in told.why
    assert _name(at_most_error(there, 0.5).point) == "fe 2 %"


def test_a_path_that_stalled_is_no_answer() -> None:
    stalled = Point(FE[2], "measured", Span(1, 1, 1), Span(0.0, 0.0, 0.0), "against best",
                    outcome=Outcome.STALLED)  # fmt: skip
    assert _name(at_most_error([*LADDER[:3], stalled], 0.05).point) == "fe 5 %"


def _name(point: Point | None) -> str | None:
    return None if point is None else point.rung.label


def test_of_answers_that_are_accurate_enough_the_one_that_took_least_is_taken() -> None:
    slow = replace(measured(FE[2], 0.01), seconds=Span(16, 16, 16))
    assert _name(at_most_error([measured(ENERGY, 0.12), slow], 5.0).point) == "energy"
    assert _name(at_most_error([measured(ENERGY, 0.12), slow], 0.05).point) == "fe 2 %"


def test_a_rung_that_ran_is_reported_with_the_seconds_that_were_expected() -> None:
    ran = replace(measured(FE[1], 0.03), seconds=Span(2, 2, 2))
    now = [LADDER[0], LADDER[1], ran, predicted(FE[2], 0.02, 6)]
    choice = as_it_went(Limit(seconds=10), LADDER[2], now, 30)
    assert _name(choice.point) == "fe 5 %"
    assert "took 2 s where about 5 s (2.5 to 10) were expected" in choice.why
    wide = replace(LADDER[2], seconds=Span(53, 8, 340))
    after = as_it_went(Limit(seconds=10), wide, now, 30)
    assert "took 2 s where about 53 s (8 to 340) were expected" in after.why
    assert "by now it would be fe 2 %" in choice.why
    slow = replace(ran, seconds=Span(16, 16, 16))
    late = as_it_went(Limit(seconds=10), LADDER[2], [LADDER[0], slow], 30)
    assert "more than 10 s" in late.why
    off = as_it_went(Limit(accuracy=0.02), LADDER[2], [LADDER[0], ran, LADDER[3]], 30)
    assert "not within 2 %" in off.why
    as_expected = as_it_went(Limit(accuracy=0.05), LADDER[2], [LADDER[0], replace(
        ran, seconds=Span(5.5, 5.5, 5.5))], 30)  # fmt: skip
    assert "expected" not in as_expected.why


def test_a_rung_that_was_stopped_gives_way_to_one_that_fits() -> None:
    stopped = replace(predicted(FE[1], 0.05, 45), stopped_after=31.0)
    now = [LADDER[0], LADDER[1], stopped]
    choice = as_it_went(Limit(accuracy=0.05), LADDER[2], now, 30)
    assert _name(choice.point) == "fe 10 %"
    assert "fe 5 % was chosen and stopped after 31 s" in choice.why
    assert [_name(at_most_seconds(now, t).point) for t in (50, 100)] == ["fe 10 %", "fe 5 %"]


def test_a_path_beyond_a_limit_point_is_not_chosen() -> None:
    beyond = replace(measured(ENERGY, 0.02), is_contradicted=True)
    assert _name(at_most_error([beyond, LADDER[2]], 0.05).point) == "fe 5 %"


def test_an_answer_goes_before_the_rungs_that_would_repeat_it() -> None:
    ran = replace(measured(FE[2], 0.004), seconds=Span(9, 9, 9))
    own = Span(0.004, 0.0, 0.004)
    same = replace(predicted(FE[0], 0.1, 9), same_as=FE[2], error=own)
    ran = replace(ran, error=own)
    assert _name(at_most_error([same, ran], 0.02).point) == "fe 2 %"
    assert _name(at_most_seconds([same, ran], 10).point) == "fe 2 %"
    told = as_it_went(Limit(accuracy=0.02), LADDER[3], [same, ran], 30)
    assert "by now" not in told.why
    assert (
        "fe 10 %, for which the answer of fe 2 % is there already"
        in at_most_error([same], 0.02).why
    )
