"""The part of the path that a job has found so far, and what becomes of it."""

from datetime import timedelta

import pytest
from sqlalchemy import text

from storage import Part, Store, VersionRow
from storage.claims import LEASE
from storage.losses import MAX_LOST
from storage.question import Failure, science_version
from storage.rows import ClaimedJob, JobRow
from tests.storage.conftest import SCENE, SLAB

RUN_OUT = timedelta(seconds=-1)
WHOLE = {"outcome": "converged", "advice": None, "scene": SCENE, "path": [{"pressure_kPa": 30.0}]}


def part(kPa: float) -> Part:
    path = [{"pressure_kPa": at, "cavity_volume_ml": at / 2} for at in (0.0, kPa)]
    document = {"outcome": "cancelled", "advice": None, "scene": SCENE, "path": path}
    return Part(document, f"arrays to {kPa}".encode(), kPa / 30)


def ask(store: Store, version: VersionRow) -> JobRow:
    return store.submit(version.id, SCENE, "fe", 0.05, "ada")


def claim(
    store: Store, job: JobRow, *, lease: timedelta = LEASE, version: str | None = None
) -> ClaimedJob:
    science = version or science_version()
    taken = store.claim(job.id, worker="w1", science_version=science, lease=lease)
    assert taken is not None
    return taken


def rows(store: Store) -> int:
    with store._read() as connection:  # pyright: ignore[reportPrivateUsage]
        return connection.execute(text("SELECT count(*) FROM part")).scalar_one()


def end_of(store: Store, row: JobRow) -> float:
    return store.get_result(row.digest).document["path"][-1]["pressure_kPa"]


def test_a_part_is_replaced_and_nobody_but_its_job_sees_it(
    store: Store, version: VersionRow
) -> None:
    job = ask(store, version)
    taken = claim(store, job)
    for kPa in (3.0, 12.0):
        assert store.keep_part(job.id, taken.attempt, part(kPa))
        assert rows(store) == 1
    assert not store.get_job(job.id).has_answer
    assert store.best_result(SLAB, SCENE, "fe") is None
    assert store.results_of(SLAB, SCENE) == []


def test_a_job_lost_for_good_has_the_part_as_its_result(store: Store, version: VersionRow) -> None:
    job = ask(store, version)
    for kPa in (3.0, 12.0, 6.0):
        taken = claim(store, job, lease=RUN_OUT)
        store.keep_part(job.id, taken.attempt, part(kPa))
        store.sweep()
    row = store.get_job(job.id)
    assert (row.state, row.outcome, row.lost) == ("failed", "worker_lost", MAX_LOST)
    assert row.has_answer
    assert row.advice is not None
    assert "up to 12 of 30 kPa, is kept" in row.advice, "the farthest of all attempts"
    assert "coarser accuracy" in row.advice
    result = store.get_result(row.digest)
    assert result.outcome == result.document["outcome"] == "worker_lost"
    assert "lost 3 times" in result.document["advice"]
    assert result.document["path"][-1]["pressure_kPa"] == 12.0
    assert result.artifact_sha256 is not None
    assert store.get_artifact(result.artifact_sha256) == b"arrays to 12.0"
    assert rows(store) == 0


@pytest.mark.parametrize("why", ["failed", "budget_spent"])
def test_a_solver_that_breaks_down_leaves_what_it_had_found(
    store: Store, version: VersionRow, why: Failure
) -> None:
    job = ask(store, version)
    taken = claim(store, job)
    store.keep_part(job.id, taken.attempt, part(3.0))
    assert store.fail(job.id, taken.attempt, "It broke.", why=why, advice="Again.", part=part(9.0))
    row = store.get_job(job.id)
    assert (row.state, row.outcome, row.has_answer) == ("failed", why, True)
    assert row.advice == "The part of the path found by then, up to 9 of 30 kPa, is kept. Again."
    assert store.get_result(row.digest).document["advice"] == f"It broke. {row.advice}"
    assert end_of(store, row) == 9.0
    assert rows(store) == 0


def test_a_part_that_only_lacks_accuracy_is_called_so(store: Store, version: VersionRow) -> None:
    job = ask(store, version)
    taken = claim(store, job)
    store.fail(job.id, taken.attempt, "It broke.", part=part(30.0))
    advice = store.get_job(job.id).advice
    assert advice == "The path found on a coarser mesh than asked for is kept."


def test_without_a_part_or_refused_there_is_no_result(store: Store, version: VersionRow) -> None:
    job = ask(store, version)
    taken = claim(store, job)
    store.fail(job.id, taken.attempt, "It broke.", advice="Again.")
    assert not store.get_job(job.id).has_answer
    assert store.get_job(job.id).advice == "Again."
    again = ask(store, version)
    taken = claim(store, again)
    store.keep_part(again.id, taken.attempt, part(3.0))
    store.fail(again.id, taken.attempt, "Too thin.", why="refused")
    assert not store.get_job(again.id).has_answer
    assert rows(store) == 0


def test_a_whole_answer_takes_the_place_of_every_part(store: Store, version: VersionRow) -> None:
    job = ask(store, version)
    taken = claim(store, job)
    store.keep_part(job.id, taken.attempt, part(3.0))
    store.fail(job.id, taken.attempt, "It broke.")
    again = ask(store, version)
    assert again.id != job.id, "a part leaves the question open"
    assert store.best_result(SLAB, SCENE, "fe") is None
    taken = claim(store, again)
    store.keep_part(again.id, taken.attempt, part(6.0))
    store.finish(again.id, taken.attempt, WHOLE, b"arrays")
    row = store.get_job(again.id)
    assert (row.state, row.outcome) == ("done", "converged")
    assert end_of(store, row) == 30.0
    assert rows(store) == 0
    assert ask(store, version).from_store


def test_cancelled_jobs_keep_a_part_where_their_worker_tells_nothing(
    store: Store, version: VersionRow
) -> None:
    job = ask(store, version)
    taken = claim(store, job)
    store.keep_part(job.id, taken.attempt, part(3.0))
    store.cancel(job.id)
    assert store.confirm_cancel(job.id, taken.attempt)
    row = store.get_job(job.id)
    assert (row.state, row.outcome, row.has_answer) == ("cancelled", "cancelled", True)
    assert row.advice == "Run it again for the rest of the path; it starts from the beginning."
    assert end_of(store, row) == 3.0
    again = ask(store, version)
    taken = claim(store, again)
    store.keep_part(again.id, taken.attempt, part(6.0))
    store.cancel(again.id)
    told = {**part(9.0).document, "advice": "As the worker says."}
    store.confirm_cancel(again.id, taken.attempt, told, b"arrays")
    row = store.get_job(again.id)
    assert row.advice == "As the worker says."
    assert end_of(store, row) == 9.0
    assert rows(store) == 0


def test_a_job_cancelled_while_it_waits_for_another_worker_keeps_what_was_found(
    store: Store, version: VersionRow
) -> None:
    job = ask(store, version)
    taken = claim(store, job, lease=RUN_OUT)
    store.keep_part(job.id, taken.attempt, part(3.0))
    store.sweep()
    assert store.get_job(job.id).state == "queued"
    row = store.cancel(job.id)
    assert (row.state, row.has_answer) == ("cancelled", True)
    assert end_of(store, row) == 3.0


def test_a_worker_that_was_given_up_keeps_no_part(store: Store, version: VersionRow) -> None:
    job = ask(store, version)
    old = claim(store, job, lease=RUN_OUT)
    store.sweep()
    claim(store, job)
    assert not store.keep_part(job.id, old.attempt, part(3.0))
    assert rows(store) == 0


def test_a_part_of_an_older_science_is_no_part_of_the_newer_answer(
    store: Store, version: VersionRow
) -> None:
    job = ask(store, version)
    taken = claim(store, job, lease=RUN_OUT)
    store.keep_part(job.id, taken.attempt, part(3.0))
    store.sweep()
    claim(store, job, version="b" * 64)
    assert rows(store) == 0


def test_a_job_of_another_version_that_waited_for_the_same_answer_has_the_part_too(
    store: Store, version: VersionRow
) -> None:
    other = store.create_design("Fork", "ada", SLAB, SCENE, "")[1]
    job = ask(store, version)
    taken = claim(store, job)
    follower = ask(store, other)
    assert follower.follows == job.id
    store.fail(job.id, taken.attempt, "It broke.", part=part(3.0))
    row = store.get_job(follower.id)
    assert (row.state, row.has_answer) == ("failed", True)
    assert end_of(store, row) == 3.0
