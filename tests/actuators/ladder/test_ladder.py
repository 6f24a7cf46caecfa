"""The whole ladder of a design in a scene."""

import pytest

from actuators.design import preset
from actuators.errors import QuestionError
from actuators.mechanics.ladder import (
    Answer,
    Ladder,
    Rung,
    ask_instant,
    build_ladder,
    cost_record,
    ladder_rungs,
    read_rung,
    typical_at,
    typical_error,
)
from actuators.mechanics.ladder.typical import ErrorCurve, ErrorMap
from actuators.mechanics.obstacles import Plate
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene
from tests.actuators.ladder.answers import made_up

SLAB = preset("slab-rectangle-low").design
COSTS = cost_record().model([])


def instant_ladder(scene: Scene, *more: Answer, spent: dict[Rung, float] | None = None) -> Ladder:
    answers, refusals = list(more), {}
    for rung in (Rung("closed-form"), Rung("energy")):
        found = ask_instant(SLAB, scene, rung)
        if isinstance(found, Answer):
            answers.append(found)
        else:
            refusals[rung] = found
    return build_ladder(SLAB, scene, answers, refusals, COSTS, spent)


def test_every_rung_has_its_place_and_more_accuracy_takes_longer() -> None:
    built = instant_ladder(Scene(4e3))
    assert [p.rung for p in built.points] == list(ladder_rungs())
    fe = [p for p in built.points if p.rung.name == "fe"]
    seconds = [p.seconds.value for p in fe if p.seconds is not None]
    assert len(seconds) == 4
    assert seconds == sorted(seconds)
    assert [p.error.high for p in fe if p.error is not None] == [0.1, 0.05, 0.02, 0.01]
    assert built.best is not None
    document = built.to_document()
    assert document["points"][0]["state"] == "measured"
    assert document["points"][-1]["seconds"]["high"] > document["points"][-1]["seconds"]["low"]


def test_a_rung_that_cannot_carry_a_load_is_refused_in_its_own_words() -> None:
    built = instant_ladder(Scene(4e3, plate=Plate(3e-3)))
    refused = {p.rung.name: p.reason for p in built.points if p.state == "refused"}
    assert "closed-form" in refused
    assert "plate is 3 mm away" in (refused["closed-form"] or "")


def test_an_answer_more_accurate_than_asked_for_stands_for_the_finer_rungs_too() -> None:
    answer = made_up(Rung("fe", 0.1), estimates={"tip": 1.5, "angle": 1.0}, seconds=3.0, to=4.0)
    points = {p.rung: p for p in instant_ladder(Scene(4e3), answer).points}
    assert points[Rung("fe", 0.02)].same_as == Rung("fe", 0.1)
    assert points[Rung("fe", 0.01)].same_as is None
    assert points[Rung("fe", 0.1)].is_best
    energy = points[Rung("energy")]
    assert energy.error_kind == "against best"


def test_seconds_spent_in_vain_raise_what_is_expected() -> None:
    rung = Rung("fe", 0.05)
    before = {p.rung: p for p in instant_ladder(Scene(4e3)).points}
    after = {p.rung: p for p in instant_ladder(Scene(4e3), spent={rung: 1e3}).points}
    for accuracy in (0.05, 0.02):
        was, now = before[Rung("fe", accuracy)].seconds, after[Rung("fe", accuracy)].seconds
        assert was is not None
        assert now is not None
        assert was.value < 1e3 < now.value
    assert "stopped after" in (after[rung].reason or "")
    assert before[Rung("fe", 0.1)].seconds == after[Rung("fe", 0.1)].seconds


def test_rungs_are_read_by_name_and_accuracy() -> None:
    assert read_rung("fe:5%", lambda text: float(text[:-1]) / 100) == Rung("fe", 0.05)
    assert read_rung(" energy ", float) == Rung("energy")
    for wrong in ("fe", "magic", "energy:5%"):
        with pytest.raises(QuestionError, match="must be one of"):
            read_rung(wrong, float)


def test_typical_errors_are_interpolated_between_levels_and_end_where_nobody_measured() -> None:
    curve = ErrorCurve((0.01, 0.1), (0.02, 0.2), (0.04, 0.4), "here")
    middle = curve.at(0.01 * 10**0.5)
    assert middle is not None
    assert (middle.half, middle.most) == pytest.approx((0.02 * 10**0.5, 0.04 * 10**0.5))
    assert curve.at(1e-4) == curve.at(0.01)
    assert curve.at(0.2) is None


def test_between_groups_of_designs_typical_errors_are_interpolated() -> None:
    soft = ErrorCurve((0.01, 0.1), (0.02, 0.02), (0.4, 0.4), "here")
    stiff = ErrorCurve((0.01, 0.1), (0.02, 0.02), (0.1, 0.1), "here")
    both = ErrorMap("pressure_per_strain_kPa", (1e4, 1e6), (soft, stiff))
    between = both.at(0.05, 1e5)
    assert between is not None
    assert (between.half, between.most) == pytest.approx((0.02, 0.2))
    assert both.at(0.05, 1.0) == soft.at(0.05)
    assert both.at(0.05, 1e9) == stiff.at(0.05)
    assert both.at(0.5, 1e5) is None


def test_typical_errors_tell_designs_of_a_family_apart() -> None:
    """Soft bellows from stiff ones, slender slabs from thick ones, at the same strain."""
    pairs = [
        (preset("bellows-9-2.4").design, preset("bellows-9-1.6").design, 0.04),
        (SLAB, SLAB.changed(chamber_count=3, length=45.0), 0.1),
    ]
    for better, worse, strain in pairs:
        found = [typical_at("energy", design, strain) for design in (better, worse)]
        assert found[0] is not None
        assert found[1] is not None
        assert found[0].most < found[1].most


def test_typical_errors_of_the_energy_rung_grow_along_its_path() -> None:
    bellows = preset("bellows-9-1.6").design
    response = predict(bellows, Scene(60e3, steps=6))
    found = typical_error(bellows, response)
    assert len(found) == len(response.path)
    most = [each.most for each in found if each is not None]
    assert len(most) > 3
    assert most[-1] > most[0]
    assert typical_at("fe", SLAB, 0.1) is None


def test_typical_errors_grow_where_chambers_are_few_and_are_not_told_of_suction() -> None:
    one = SLAB.changed(chamber_count=1, length=30.0)
    typical = typical_at("cell-rod", SLAB, 0.05)
    wider = typical_at("cell-rod", one, 0.05)
    assert typical is not None
    assert wider is not None
    assert wider.half == pytest.approx(5 * typical.half)
    assert typical_at("cell-rod", SLAB, 0.05, suction=True) is None
    assert typical_at("cell-rod", SLAB, 0.05, obstacle=True) is None
    sucked = typical_error(SLAB, predict(SLAB, Scene(-2e3, steps=2), rung="cell-rod"))
    assert [each is None for each in sucked] == [False, True, True]
