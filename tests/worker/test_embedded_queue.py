"""Jobs through a real worker process, SQLite and the filesystem broker."""

import os
import signal
import time
from collections.abc import Generator
from pathlib import Path

import pytest

from tests.worker.processes import SLAB, Queue, embedded_queue, kill_group


@pytest.fixture
def queue(tmp_path: Path) -> Generator[Queue]:
    with embedded_queue(tmp_path) as opened:
        yield opened


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Generator[Queue]:
    """A queue with one worker that no test kills."""
    with embedded_queue(tmp_path_factory.mktemp("studio")) as opened:
        opened.start_worker("w1")
        yield opened


def test_a_job_is_computed_told_about_and_stored(running: Queue) -> None:
    job = running.ask(1)
    row = running.wait(job)
    assert (row.state, row.outcome, row.attempt, row.error) == ("done", "converged", 1, None)
    result = running.store.get_result(row.digest)
    assert result.document["path"][-1]["pressure_kPa"] == 1
    told = [
        e.data["fraction"] for e in running.store.events_after(0)
        if e.subject == job.id and e.data["state"] == "running"
    ]  # fmt: skip
    assert told == sorted(told)
    assert len(told) > 4, "more than a second of work must show progress"


def test_doubled_messages_do_nothing(running: Queue) -> None:
    job = running.ask(2)
    for _ in range(5):
        running.send(job.id)
    assert running.wait(job).attempt == 1
    for _ in range(3):
        running.send(job.id)
    after = running.wait(running.ask(3))
    assert after.state == "done"
    assert running.store.get_job(job.id).attempt == 1


def test_a_running_job_is_cancelled_within_two_seconds(running: Queue) -> None:
    job = running.ask(4)
    running.wait_for_progress(job, 0.05)
    asked = time.monotonic()
    running.store.cancel(job.id)
    row = running.wait(job)
    assert row.state == "cancelled"
    assert row.fraction < 1
    assert time.monotonic() - asked < 2
    # what was found by then is kept, and answers nothing but this job
    assert row.has_answer
    assert row.advice is not None
    assert 1 < len(running.store.get_result(row.digest).document["path"]) < 41
    assert running.store.best_result(SLAB, row.scene, "energy") is None


def test_a_queued_job_is_cancelled_at_once_and_never_starts(running: Queue) -> None:
    # of two asked within a millisecond the broker may hand out either first
    first = running.ask(5)
    running.wait(first, "running")
    second = running.ask(6)
    assert running.store.cancel(second.id).state == "cancelled"
    assert running.wait(first).state == "done"
    assert running.store.get_job(second.id).started_at is None


def test_a_solver_that_does_not_listen_is_ended_and_the_worker_goes_on(running: Queue) -> None:
    deaf = running.ask(7, rung="closed-form")
    running.wait(deaf, "running")
    asked = time.monotonic()
    running.store.cancel(deaf.id)
    assert running.wait(deaf).state == "cancelled"
    assert time.monotonic() - asked < 6  # half a second to notice, three of patience
    assert running.wait(running.ask(8)).state == "done"


def test_a_solver_that_raises_fails_the_job_with_a_reason(running: Queue) -> None:
    row = running.wait(running.ask(9, rung="fe"))
    assert (row.state, row.outcome) == ("failed", "failed")
    assert row.advice is not None
    assert row.id in row.advice
    assert row.error is not None
    assert "an element has no volume" in row.error
    assert "Traceback" not in row.error
    assert 'raise ZeroDivisionError("an element has no volume")' in running.log("w1")


def test_a_spent_time_budget_keeps_the_part_that_was_found(running: Queue) -> None:
    row = running.wait(running.ask(10, budget_s=0.6))
    assert (row.state, row.outcome) == ("done", "budget_spent")
    assert row.advice is not None
    assert "time budget" in row.advice
    path = running.store.get_result(row.digest).document["path"]
    assert 1 < len(path) < 41


def test_the_worker_reports_that_it_is_there(running: Queue) -> None:
    running.wait(running.ask(11))
    assert running.store.worker_alive()
    assert [w.name for w in running.store.list_workers()] == ["w1@test"]


def test_a_job_whose_whole_worker_is_killed_finishes_anyway_once(queue: Queue) -> None:
    worker = queue.start_worker("w1")
    job, waiting = queue.ask(1), queue.ask(2)
    queue.wait_for_progress(job)
    kill_group(worker)
    queue.start_worker("w1")
    row = queue.wait(job)  # found by its lease, that nobody renews
    assert (row.state, row.attempt, row.lost) == ("done", 2, 1)
    assert queue.wait(waiting).state == "done"


def test_half_a_note_of_the_queues_keeps_no_worker_from_its_jobs(
    queue: Queue, tmp_path: Path
) -> None:
    """As a process leaves it that is killed while it writes: workers waited for ever."""
    worker = queue.start_worker("w1")
    job = queue.ask(1)
    queue.wait_for_progress(job)
    kill_group(worker)
    (note,) = tmp_path.rglob("*.exchange")
    note.write_bytes(note.read_bytes()[:-3])
    queue.start_worker("w1")
    assert queue.wait(job).state == "done"


def test_a_worker_that_is_told_to_end_hands_its_job_back(queue: Queue) -> None:
    worker = queue.start_worker("w1")
    job = queue.ask(1)
    queue.wait_for_progress(job)
    asked = time.monotonic()
    os.kill(worker.pid, signal.SIGTERM)
    assert worker.wait(10) == 0
    assert time.monotonic() - asked < 3
    assert queue.store.get_job(job.id).state == "queued"
    assert not queue.store.worker_alive()
    queue.start_worker("w2")
    row = queue.wait(job)
    assert (row.state, row.attempt, row.lost) == ("done", 2, 0)


@pytest.mark.slow
def test_thirty_jobs_and_eight_kills_lose_and_double_nothing(queue: Queue) -> None:
    jobs = [queue.ask(k) for k in range(1, 31)]
    for _ in range(8):
        worker = queue.start_worker("w1")
        time.sleep(5)
        kill_group(worker)
        queue.store.release("w1@test", lost=False)
    queue.start_worker("w1")
    rows = [queue.wait(job, timeout_s=200) for job in jobs]
    assert [row.state for row in rows] == ["done"] * 30
    done = [e.subject for e in queue.store.events_after(0, limit=100000)
            if e.kind == "job" and e.data["state"] == "done"]  # fmt: skip
    assert sorted(done) == sorted(job.id for job in jobs), "a job was closed twice"
