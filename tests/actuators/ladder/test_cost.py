"""Predicted seconds: from the record, then from this machine's jobs."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from actuators.mechanics.ladder import (
    FEATURES,
    CostModel,
    Known,
    Outlook,
    PastJob,
    TimeEstimate,
    cost_record,
    job_document,
    job_of_document,
)
from actuators.mechanics.ladder.past import Spread
from actuators.mechanics.ladder.question import LevelErrors, work_by_level

OBLIQUE, STRAIN, COARSE = (FEATURES.index(name) for name in ("oblique", "strain", "coarse"))
LEVELS = {apart: LevelErrors((-2.0, -3.0, -4.0), (0.5, 0.5, 0.5)) for apart in (False, True)}


def question(
    *, sizes: tuple[int, ...] = (5000,), oblique: bool = False, strain: float = 0.0,
    coarse: float = 0.0, accuracy: float | None = None,
) -> Outlook:  # fmt: skip
    x = np.zeros(len(FEATURES))
    x[[0, OBLIQUE, STRAIN, COARSE]] = 1.0, float(oblique), strain, coarse
    work = tuple(np.log(work_by_level(sizes)).tolist())
    return Outlook(x, sizes, work, accuracy, stands_apart=False)


def jobs(rng: np.random.Generator, count: int, *, pace: float, noise: float = 0.1) -> list[PastJob]:
    """Jobs of a world where obliques take twice as long as their work says."""
    found = []
    for _ in range(count):
        asked = question(
            sizes=(int(rng.uniform(2e3, 5e4)),), oblique=bool(rng.integers(0, 2)),
            strain=float(rng.uniform(-5, 5)),
        )  # fmt: skip
        logs = asked.work[0] + np.log(2) * asked.features[OBLIQUE] + np.log(pace)
        found.append(PastJob(asked, float(np.exp(logs + noise * rng.standard_normal())), 0, {}))
    return found


def model(record: Sequence[PastJob], own: Sequence[PastJob], **more: float) -> CostModel:
    return CostModel(Known(record, LEVELS, Spread(**more)), own)


def share_within(costs: CostModel, asked: Sequence[PastJob], factor: float) -> float:
    found = np.array([costs.predict(job.outlook).seconds / job.seconds for job in asked])
    return float(np.mean(np.abs(np.log(found)) <= np.log(factor)))


def test_ten_jobs_teach_the_pace_of_a_machine() -> None:
    rng = np.random.default_rng(1)
    record = jobs(rng, 60, pace=1.0)
    asked = jobs(rng, 50, pace=3.0, noise=0.0)
    assert share_within(model(record, []), asked, 1.5) == 0.0
    taught = model(record, jobs(rng, 10, pace=3.0))
    assert share_within(taught, asked, 1.5) >= 0.9
    assert taught.learned_from == 10


def test_without_any_record_jobs_alone_teach() -> None:
    rng = np.random.default_rng(2)
    taught = model([], jobs(rng, 30, pace=0.5))
    assert share_within(taught, jobs(rng, 50, pace=0.5, noise=0.0), 1.5) >= 0.9
    nothing = model([], []).predict(question())
    assert 0.0 < nothing.low < nothing.seconds < nothing.high < np.inf


def test_the_range_holds_about_four_of_five() -> None:
    rng = np.random.default_rng(3)
    record, own = jobs(rng, 60, pace=1.0, noise=0.2), jobs(rng, 20, pace=2.0, noise=0.2)
    costs = model(record, own, noise=0.2)
    asked = jobs(rng, 300, pace=2.0, noise=0.2)
    found = [costs.predict(job.outlook) for job in asked]
    held = [each.low <= job.seconds <= each.high for each, job in zip(found, asked, strict=True)]
    assert 0.7 <= np.mean(held) <= 0.95


def test_one_job_on_a_machine_that_slept_spoils_little() -> None:
    rng = np.random.default_rng(4)
    record, own = jobs(rng, 60, pace=1.0), jobs(rng, 10, pace=1.0)
    own[4] = replace(own[4], seconds=200.0 * own[4].seconds)
    asked = jobs(rng, 50, pace=1.0, noise=0.0)
    assert share_within(model(record, own), asked, 1.5) >= 0.8


def test_a_question_timed_before_dominates_its_own_prediction() -> None:
    """Also where a slider has moved a little; less so to a body of another size."""
    rng = np.random.default_rng(5)
    record, own = jobs(rng, 60, pace=1.0), jobs(rng, 10, pace=1.0)
    asked = question(coarse=0.5, strain=1.0)
    usual = model(record, own).predict(asked)
    again = [*own, PastJob(asked, 3 * usual.seconds, 0, {})]
    found = model(record, again).predict(asked)
    assert found.seconds == pytest.approx(3 * usual.seconds, rel=0.25)
    assert found.high / found.low < usual.high / usual.low
    moved = question(coarse=0.5, strain=1.2)
    assert model(record, again).predict(moved).seconds > 2.4 * usual.seconds
    other = question(coarse=3.0, strain=1.0)
    assert model(record, again).predict(other).seconds < 0.85 * found.seconds


def test_a_job_is_expected_to_end_on_the_mesh_where_its_neighbours_did() -> None:
    """A question whose error stood at 1 % on the first finer mesh ends there at 2 %; one that was
    8 % off goes on."""
    rng = np.random.default_rng(6)
    record, sizes = jobs(rng, 60, pace=1.0), (5000, 15000, 40000)
    asked = question(sizes=sizes, accuracy=0.05)
    small = PastJob(replace(asked, accuracy=0.1), 2.0, 1, {1: 0.01})
    large = PastJob(replace(asked, accuracy=0.1), 2.0, 1, {1: 0.08})
    ends, goes_on = (
        model(record, [job], error_near=0.55).predict(asked).seconds for job in (small, large)
    )
    assert goes_on > 2 * ends


def test_between_two_ends_the_likelier_one_is_told_and_the_range_holds_both() -> None:
    """A compromise between the two would be wrong for either."""
    rng, sizes = np.random.default_rng(7), (5000, 15000, 90000)
    levels = {False: LevelErrors((float(np.log(0.05)) + 0.2, -9.0), (0.5, 0.5))}
    known = Known(jobs(rng, 60, pace=1.0), levels, Spread(noise=0.05))
    costs = CostModel(known, jobs(rng, 20, pace=1.0))
    asked = question(sizes=sizes, accuracy=0.05)
    found, first = costs.predict(asked), np.exp(asked.work[1])
    assert found.seconds == pytest.approx(np.exp(asked.work[2]), rel=0.3)
    assert found.low < 1.2 * first
    assert found.high > found.seconds


def test_an_answer_tells_its_mesh_and_its_largest_judged_error() -> None:
    asked = question(sizes=(5000, 15000, 40000), accuracy=0.05)
    job = PastJob.of(asked, 3.0, 15100, {"tip": 0.01, "angle": 0.03, "volume": 0.2})
    assert (job.level, dict(job.errors)) == (1, {1: 0.03})
    chosen = question(sizes=(5000, 40000))
    assert PastJob.of(chosen, 3.0, 40000, {}).level == 1
    kept = job_of_document(job_document(job))
    assert kept.outlook.work == pytest.approx(job.outlook.work)
    assert (kept.level, kept.seconds, dict(kept.errors)) == (1, 3.0, {1: 0.03})
    for wrong in ({"features": [1.0]}, {"level": 7}, {"seconds": float("nan")}):
        with pytest.raises(ValueError, match=r"features|no job"):
            job_of_document({**job_document(job), **wrong})


def test_an_estimate_moves_up_once_seconds_have_been_spent_in_vain() -> None:
    first = TimeEstimate(10.0, 5.0, 20.0, 0)
    assert first.longer_than(0.0) == first
    later = first.longer_than(20.0)
    assert 20.0 < later.low < later.seconds < later.high
    # 10 % lie above the upper end; their median is the 95 % point of the lognormal distribution
    deviation = np.log(2.0) / 1.2816
    assert later.seconds == pytest.approx(10.0 * np.exp(1.6449 * deviation), rel=1e-3)
    hopeless = first.longer_than(1e6)
    assert np.isfinite([hopeless.low, hopeless.high]).all()


def test_a_job_that_was_stopped_teaches_that_it_takes_longer() -> None:
    """As one that ended long after, for it and its neighbours; not where it was stopped sooner than
    such jobs end, and it is not among those that ended."""
    rng = np.random.default_rng(9)
    record, own = jobs(rng, 60, pace=1.0), jobs(rng, 10, pace=1.0)
    asked, away = question(coarse=0.5, strain=1.0), question(coarse=3.0, strain=-4.0)
    usual = model(record, own).predict(asked)
    stopped = PastJob.of(asked, 20 * usual.seconds, 5000, {"tip": 0.01}, stopped=True)
    taught = model(record, [*own, stopped])
    found = taught.predict(asked)
    assert found.seconds > 12 * usual.seconds
    assert found.high > 20 * usual.seconds
    assert taught.learned_from == 10
    there = model(record, own).predict(away).seconds
    assert taught.predict(away).seconds == pytest.approx(there, rel=0.3)
    soon = PastJob.of(asked, usual.seconds / 20, 5000, {}, stopped=True)
    assert model(record, [*own, soon]).predict(asked) == usual
    kept = job_of_document(job_document(stopped))
    assert kept.stopped
    assert not kept.errors
    assert kept.seconds == pytest.approx(stopped.seconds, abs=1e-4)


def test_only_stopped_jobs_teach_too() -> None:
    asked = question(sizes=(5000, 15000), accuracy=0.05)
    before = model([], []).predict(asked)
    stopped = PastJob.of(asked, 1e3 * before.seconds, 5000, {}, stopped=True)
    found = model([], [stopped]).predict(asked)
    assert before.high < found.seconds < found.high < np.inf
    assert found.learned_from == 0


def test_more_accuracy_is_more_time() -> None:
    record = jobs(np.random.default_rng(8), 60, pace=1.0)
    sizes = (5000, 15000, 40000, 100000)
    found = [
        model(record, []).predict(question(sizes=sizes, accuracy=a)).seconds
        for a in (0.5, 0.1, 0.03, 0.001)
    ]
    assert found == sorted(found)
    assert found[-1] > 3 * found[0]
    assert model(record, []).predict(question()).seconds < found[0]


def test_the_shipped_record_fits_this_version() -> None:
    record = cost_record()
    assert len(record.jobs) >= 50
    assert all(job.is_timed and job.level < len(job.outlook.sizes) for job in record.jobs)
    assert record.spread.noise >= 0.03
