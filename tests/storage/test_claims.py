"""Leases, fences and what happens to the jobs of a dead worker."""

from datetime import timedelta

import pytest

from storage import ClaimedJob, Hold, JobRow, Store, VersionRow
from storage.question import science_version
from tests.storage.conftest import SCENE, SLAB

ANSWER = {"outcome": "limit_point", "advice": "Stay below 20 kPa.", "path": []}
RUN_OUT = timedelta(seconds=-1)


@pytest.fixture
def job(store: Store, version: VersionRow) -> JobRow:
    return store.submit(version.id, SCENE, "fe", 0.05, "ada")


def claim(store: Store, job: JobRow, lease: timedelta | None = None) -> ClaimedJob:
    more = {} if lease is None else {"lease": lease}
    taken = store.claim(job.id, worker="w1", science_version=science_version(), **more)
    assert taken is not None
    return taken


def test_a_claim_holds_what_the_worker_needs(store: Store, job: JobRow) -> None:
    taken = claim(store, job)
    assert (taken.design, taken.rung, taken.accuracy) == (SLAB, "fe", 0.05)
    assert taken.scene["pressure_kPa"]["to"] == 30
    row = store.get_job(job.id)
    assert (row.state, row.attempt, row.worker) == ("running", 1, "w1")
    assert row.started_at is not None


def test_a_doubled_message_claims_nothing(store: Store, job: JobRow) -> None:
    taken = claim(store, job)
    assert store.claim(job.id, worker="w2", science_version=science_version()) is None
    store.finish(job.id, taken.attempt, ANSWER, b"arrays")
    assert store.claim(job.id, worker="w2", science_version=science_version()) is None
    assert store.claim("nowhere", worker="w2", science_version=science_version()) is None
    assert store.get_job(job.id).worker == "w1"


def test_finishing_stores_the_answer_and_closes_the_job(store: Store, job: JobRow) -> None:
    taken = claim(store, job)
    assert store.finish(job.id, taken.attempt, ANSWER, b"arrays")
    row = store.get_job(job.id)
    assert (row.state, row.outcome, row.advice) == ("done", "limit_point", "Stay below 20 kPa.")
    assert (row.fraction, row.from_store) == (1.0, False)
    result = store.get_result(row.digest)
    assert result.document == ANSWER
    assert result.artifact_sha256 is not None
    assert store.get_artifact(result.artifact_sha256) == b"arrays"
    best = store.best_result(SLAB, SCENE, "fe")
    assert best is not None
    assert best.digest == row.digest
    assert store.best_result(SLAB, SCENE, "energy") is None


def test_a_worker_that_was_given_up_can_write_nothing(store: Store, job: JobRow) -> None:
    old = claim(store, job, RUN_OUT)
    assert store.sweep() == [job.id]
    new = claim(store, job)
    assert (old.attempt, new.attempt) == (1, 2)
    assert store.heartbeat(job.id, old.attempt) is Hold.GONE
    assert store.progress(job.id, old.attempt, fraction=0.9, message="late") is Hold.GONE
    assert not store.finish(job.id, old.attempt, {**ANSWER, "advice": "late"}, b"late")
    assert not store.fail(job.id, old.attempt, "late")
    assert not store.confirm_cancel(job.id, old.attempt)
    row = store.get_job(job.id)
    assert (row.state, row.attempt, row.fraction, row.error) == ("running", 2, 0.0, None)
    assert store.finish(job.id, new.attempt, ANSWER, b"arrays")
    assert store.get_result(row.digest).document == ANSWER


def test_a_heartbeat_keeps_the_lease(store: Store, job: JobRow) -> None:
    taken = claim(store, job, RUN_OUT)
    assert store.heartbeat(job.id, taken.attempt) is Hold.HELD
    store.sweep()
    assert store.get_job(job.id).state == "running"
    assert store.heartbeat(job.id, taken.attempt, lease=RUN_OUT) is Hold.HELD
    store.sweep()
    assert store.get_job(job.id).state == "queued"


def test_progress_is_told_as_events_in_order(store: Store, job: JobRow) -> None:
    taken = claim(store, job)
    start = store.last_event_seq()
    for step in range(1, 4):
        store.progress(
            job.id, taken.attempt, fraction=step / 4, message=f"step {step}", pressure=1e3 * step
        )
    events = store.events_after(start)
    assert [e.data["message"] for e in events] == ["step 1", "step 2", "step 3"]
    assert [e.seq for e in events] == sorted(e.seq for e in events)
    assert {(e.kind, e.subject) for e in events} == {("job", job.id)}
    assert store.events_after(events[-1].seq) == []
    assert store.get_job(job.id).pressure == 3e3


def test_a_lost_worker_is_counted_apart_and_ends_the_job_at_the_third_time(
    store: Store, job: JobRow
) -> None:
    for lost in (1, 2):
        claim(store, job, RUN_OUT)
        store.sweep()
        row = store.get_job(job.id)
        assert (row.state, row.lost, row.error) == ("queued", lost, None)
    taken = claim(store, job)
    store.progress(job.id, taken.attempt, fraction=0.4, message="", pressure=12e3, lease=RUN_OUT)
    assert store.sweep() == []
    row = store.get_job(job.id)
    assert (row.state, row.lost, row.attempt) == ("failed", 3, 3)
    assert row.error is not None
    assert "lost 3 times" in row.error
    assert "12 kPa" in row.error
    assert row.outcome == "worker_lost"
    assert row.advice is not None
    assert not row.has_answer


def test_a_worker_that_leaves_in_order_is_not_counted(store: Store, job: JobRow) -> None:
    claim(store, job)
    assert store.release("someone else", lost=False) == []
    assert store.release("w1", lost=False) == [job.id]
    row = store.get_job(job.id)
    assert (row.state, row.lost) == ("queued", 0)
    assert store.sweep() == [job.id]


def test_a_failure_is_final_and_says_why(store: Store, job: JobRow) -> None:
    taken = claim(store, job)
    mend = "Thicken the wall."
    error = "An element has no volume."
    assert store.fail(job.id, taken.attempt, error, why="refused", advice=mend)
    row = store.get_job(job.id)
    assert (row.state, row.error, row.lost) == ("failed", error, 0)
    assert (row.outcome, row.advice, row.has_answer) == ("refused", mend, False)
    assert store.sweep() == []


def test_a_queued_job_is_cancelled_at_once(store: Store, job: JobRow) -> None:
    assert store.cancel(job.id).state == "cancelled"
    assert store.claim(job.id, worker="w", science_version=science_version()) is None
    assert store.sweep() == []


def test_a_running_job_is_cancelled_when_its_worker_has_noticed(store: Store, job: JobRow) -> None:
    taken = claim(store, job)
    assert store.cancel(job.id).state == "running"
    assert store.hold(job.id, taken.attempt) is Hold.CANCEL
    assert store.heartbeat(job.id, taken.attempt) is Hold.CANCEL
    assert store.confirm_cancel(job.id, taken.attempt)
    assert store.get_job(job.id).state == "cancelled"
    assert store.cancel(job.id).state == "cancelled"


def test_a_worker_that_dies_with_a_cancel_pending_leaves_a_cancelled_job(
    store: Store, job: JobRow
) -> None:
    claim(store, job, RUN_OUT)
    store.cancel(job.id)
    assert store.sweep() == []
    assert store.get_job(job.id).state == "cancelled"


def test_an_answer_that_beats_the_cancel_is_kept(store: Store, job: JobRow) -> None:
    taken = claim(store, job)
    store.cancel(job.id)
    assert store.finish(job.id, taken.attempt, ANSWER, b"arrays")
    assert store.get_job(job.id).state == "done"
    assert store.cancel(job.id).state == "done"


def test_the_answer_is_filed_under_the_science_that_gave_it(store: Store, job: JobRow) -> None:
    newer = "e" * 64
    taken = store.claim(job.id, worker="w", science_version=newer)
    assert taken is not None
    store.finish(job.id, taken.attempt, ANSWER, b"arrays")
    row = store.get_job(job.id)
    assert (row.science_version, row.digest != job.digest) == (newer, True)
    assert store.get_result(row.digest).science_version == newer


def test_a_lost_message_is_sent_again(
    store: Store, job: JobRow, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert store.sweep() == [job.id]
    assert store.sweep() == []
    monkeypatch.setattr("storage.losses._RESEND_IDLE", timedelta(0))
    assert store.sweep() == [job.id]


def test_waiting_jobs_are_announced_again_when_a_worker_dies(
    store: Store, version: VersionRow, job: JobRow
) -> None:
    other = store.submit(version.id, SCENE, "fe", 0.01, "ada")
    assert store.sweep() == [job.id, other.id]
    claim(store, job, RUN_OUT)
    assert store.sweep() == [job.id, other.id]
