"""Predicted seconds: from the record, then from this machine's jobs."""

import numpy as np
import pytest

from actuators.mechanics.ladder import FEATURES, CostModel, TimeEstimate, Timings, cost_record
from actuators.mechanics.ladder.cost import Spread
from actuators.mechanics.ladder.question import LevelErrors, MeshSizes, expected_work

WORK, OBLIQUE = FEATURES.index("work"), FEATURES.index("oblique")


def jobs(rng: np.random.Generator, count: int, *, pace: float, noise: float = 0.1) -> Timings:
    """Jobs of a world where obliques take twice as long as their work says."""
    x = np.zeros((count, len(FEATURES)))
    x[:, 0] = 1.0
    x[:, WORK] = rng.uniform(-1, 2, count)
    x[:, OBLIQUE] = rng.integers(0, 2, count)
    logs = x[:, WORK] + np.log(2) * x[:, OBLIQUE] + np.log(pace)
    return Timings(x, np.exp(logs + noise * rng.standard_normal(count)))


def share_within(model: CostModel, asked: Timings, factor: float) -> float:
    found = np.array([model.predict(x).seconds for x in asked.features])
    return float(np.mean(np.abs(np.log(found / asked.seconds)) <= np.log(factor)))


def test_ten_jobs_teach_the_pace_of_a_machine() -> None:
    rng = np.random.default_rng(1)
    record = jobs(rng, 60, pace=1.0)
    asked = jobs(rng, 50, pace=3.0, noise=0.0)
    assert share_within(CostModel(record, Timings.of([])), asked, 1.5) == 0.0
    taught = CostModel(record, jobs(rng, 10, pace=3.0))
    assert share_within(taught, asked, 1.5) >= 0.9
    assert taught.learned_from == 10


def test_without_any_record_jobs_alone_teach() -> None:
    rng = np.random.default_rng(2)
    model = CostModel(Timings.of([]), jobs(rng, 30, pace=0.5))
    assert share_within(model, jobs(rng, 50, pace=0.5, noise=0.0), 1.5) >= 0.9
    nothing = CostModel(Timings.of([]), Timings.of([])).predict(np.ones(len(FEATURES)))
    assert 0.0 < nothing.low < nothing.seconds < nothing.high < np.inf


def test_the_range_holds_about_four_of_five() -> None:
    rng = np.random.default_rng(3)
    record, own = jobs(rng, 60, pace=1.0, noise=0.2), jobs(rng, 20, pace=2.0, noise=0.2)
    model = CostModel(record, own, Spread(noise=0.2))
    asked = jobs(rng, 300, pace=2.0, noise=0.2)
    held = [
        found.low <= t <= found.high
        for x, t in zip(asked.features, asked.seconds, strict=True)
        for found in [model.predict(x)]
    ]
    assert 0.7 <= np.mean(held) <= 0.95


def test_one_job_on_a_machine_that_slept_spoils_little() -> None:
    rng = np.random.default_rng(4)
    record, own = jobs(rng, 60, pace=1.0), jobs(rng, 10, pace=1.0)
    slept = Timings(own.features, own.seconds * np.where(np.arange(10) == 4, 200.0, 1.0))
    asked = jobs(rng, 50, pace=1.0, noise=0.0)
    assert share_within(CostModel(record, slept), asked, 1.5) >= 0.8


def test_a_question_timed_before_dominates_its_own_prediction() -> None:
    """Also where only accuracy or pressure differ; a body of another size is another question."""
    rng = np.random.default_rng(5)
    record, own = jobs(rng, 60, pace=1.0), jobs(rng, 10, pace=1.0)
    x = own.features[3].copy()
    x[FEATURES.index("coarse")] = 0.5
    usual = CostModel(record, own).predict(x)
    again = Timings(np.vstack([own.features, x]), np.append(own.seconds, 3 * usual.seconds))
    model = CostModel(record, again)
    found = model.predict(x)
    assert found.seconds == pytest.approx(3 * usual.seconds, rel=0.25)
    assert found.high / found.low < usual.high / usual.low
    finer, other = x.copy(), x.copy()
    finer[WORK] += 0.7
    assert model.predict(finer).seconds > 2 * CostModel(record, own).predict(finer).seconds
    other[FEATURES.index("coarse")] = 0.8
    assert model.predict(other).seconds < 2 * usual.seconds


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


def test_more_accuracy_is_more_work() -> None:
    sizes = MeshSizes(5000, (15000, 40000, 100000), False)
    errors = LevelErrors((-3.0, -4.0, -5.0), (0.5, 0.5, 0.5))
    work = [expected_work(sizes, a, errors) for a in (0.5, 0.1, 0.03, 0.01, 0.001)]
    assert work == sorted(work)
    assert work[-1] > 3 * work[0]
    alone = MeshSizes(5000, (), False)
    assert expected_work(alone, None, errors) < work[0]


def test_the_shipped_record_fits_this_version() -> None:
    record = cost_record()
    assert record.timings.features.shape[1] == len(FEATURES)
    assert (record.timings.seconds > 0).all()
    assert record.spread.noise >= 0.03
    assert isinstance(record.spread, Spread)
