"""Asking a question: once computed, once under way."""

import pytest

from actuators.errors import QuestionError, SceneError
from storage import JobRow, NotFoundError, Store, VersionRow
from storage.question import science_version
from tests.storage.conftest import SCENE

ANSWER = {"outcome": "converged", "advice": None, "path": []}


def ask(store: Store, version: VersionRow, accuracy: float = 0.05) -> JobRow:
    return store.submit(version.id, SCENE, "fe", accuracy, "ada")


def compute(store: Store, job: JobRow) -> None:
    claim = store.claim(job.id, worker="w", science_version=science_version())
    assert claim is not None
    assert store.finish(job.id, claim.attempt, ANSWER, b"arrays")


def test_the_same_question_is_answered_from_the_store(store: Store, version: VersionRow) -> None:
    first = ask(store, version)
    compute(store, first)
    again = ask(store, version)
    assert (again.state, again.from_store, again.outcome) == ("done", True, "converged")
    assert again.digest == first.digest
    assert store.sweep() == []
    assert ask(store, version).id == again.id  # and no third row
    assert ask(store, version, accuracy=0.02).state == "queued"


def test_a_question_under_way_is_joined(store: Store, version: VersionRow) -> None:
    job = ask(store, version)
    assert ask(store, version).id == job.id
    store.claim(job.id, worker="w", science_version=science_version())
    assert ask(store, version).id == job.id
    assert len(store.list_jobs()) == 1


def test_a_fork_waits_for_the_answer_its_origin_computes(store: Store, version: VersionRow) -> None:
    _, copy = store.fork(version.id, "Copy", "bob")
    job, waiting = ask(store, version), ask(store, copy)
    assert (waiting.follows, waiting.id != job.id) == (job.id, True)
    assert store.sweep() == [job.id]
    claim = store.claim(job.id, worker="w", science_version=science_version())
    assert claim is not None
    assert store.claim(waiting.id, worker="w", science_version=science_version()) is None
    store.progress(job.id, claim.attempt, fraction=0.5, message="half", pressure=15e3)
    mirrored = store.get_job(waiting.id)
    assert (mirrored.state, mirrored.fraction, mirrored.pressure) == ("running", 0.5, 15e3)
    store.finish(job.id, claim.attempt, ANSWER, b"arrays")
    assert store.get_job(waiting.id).state == "done"
    assert store.get_result(waiting.digest).document == ANSWER


def test_cancelling_the_origin_hands_the_question_to_the_fork(
    store: Store, version: VersionRow
) -> None:
    _, copy = store.fork(version.id, "Copy", "bob")
    _, third = store.fork(version.id, "Third", "bob")
    job, heir, last = ask(store, version), ask(store, copy), ask(store, third)
    store.claim(job.id, worker="w", science_version=science_version())
    store.cancel(job.id)
    store.confirm_cancel(job.id, 1)
    assert store.get_job(job.id).state == "cancelled"
    assert (store.get_job(heir.id).state, store.get_job(heir.id).follows) == ("queued", None)
    assert store.get_job(last.id).follows == heir.id
    assert heir.id in store.sweep()
    compute(store, heir)
    assert store.get_job(last.id).state == "done"


def test_cancelling_the_fork_leaves_the_origin_alone(store: Store, version: VersionRow) -> None:
    _, copy = store.fork(version.id, "Copy", "bob")
    job, waiting = ask(store, version), ask(store, copy)
    assert store.cancel(waiting.id).state == "cancelled"
    assert store.get_job(job.id).state == "queued"


def test_an_answer_that_ran_out_of_time_does_not_settle_the_question(
    store: Store, version: VersionRow
) -> None:
    job = ask(store, version)
    store.claim(job.id, worker="w", science_version=science_version())
    store.finish(job.id, 1, {**ANSWER, "outcome": "budget_spent"}, b"part")
    assert store.get_job(job.id).outcome == "budget_spent"
    assert store.get_result(job.digest).outcome == "budget_spent"
    again = ask(store, version)
    assert again.state == "queued"
    compute(store, again)
    assert store.get_result(job.digest).outcome == "converged"


def test_a_changed_science_does_not_find_old_answers(
    store: Store, version: VersionRow, monkeypatch: pytest.MonkeyPatch
) -> None:
    compute(store, ask(store, version))
    monkeypatch.setattr("storage.submission.science_version", lambda: "f" * 64)
    assert ask(store, version).state == "queued"


@pytest.mark.parametrize("accuracy", [0.0, -1.0, float("nan"), 0.9, True, "fine"])
def test_an_accuracy_nobody_can_serve_is_refused(
    store: Store, version: VersionRow, accuracy: float
) -> None:
    with pytest.raises(QuestionError) as refusal:
        ask(store, version, accuracy)
    assert refusal.value.field == "accuracy"
    assert store.list_jobs() == []


def test_bad_questions_store_nothing(store: Store, version: VersionRow) -> None:
    with pytest.raises(QuestionError):
        store.submit(version.id, SCENE, "guess", 0.05, "ada")
    with pytest.raises(SceneError):
        store.submit(version.id, {"pressure_kPa": {"to": -500}}, "fe", 0.05, "ada")
    with pytest.raises(NotFoundError):
        store.submit("nowhere", SCENE, "fe", 0.05, "ada")
    assert store.list_jobs() == []


def test_jobs_are_listed_newest_first_and_by_state(store: Store, version: VersionRow) -> None:
    jobs = [ask(store, version, accuracy) for accuracy in (0.05, 0.02, 0.01)]
    store.cancel(jobs[1].id)
    assert [j.id for j in store.list_jobs()] == [j.id for j in reversed(jobs)]
    assert [j.id for j in store.list_jobs(states=["cancelled"])] == [jobs[1].id]
    assert len(store.list_jobs(design_id=version.design_id, limit=2)) == 2
    assert store.list_jobs(version_id="other") == []
    assert set(store.get_jobs([jobs[0].id, "unknown"])) == {jobs[0].id}
    assert store.list_jobs()[0].design_name == "Finger"
    assert store.list_jobs()[0].version_number == 1


def test_a_mesh_asked_for_is_a_question_of_its_own(store: Store, version: VersionRow) -> None:
    usual = ask(store, version)
    fine = store.submit(version.id, SCENE, "fe", 0.05, "ada", mesh="fine")
    assert fine.id != usual.id
    taken = store.claim(fine.id, worker="w", science_version=science_version())
    assert taken is not None
    assert taken.mesh == "fine"
    assert store.finish(fine.id, taken.attempt, ANSWER, b"")
    again = store.submit(version.id, SCENE, "fe", 0.05, "ada", mesh="fine")
    assert again.from_store
    assert store.get_result(again.digest).mesh == "fine"


@pytest.mark.parametrize(
    ("rung", "mesh"), [("fe", "very fine"), ("fe", "1,1,9"), ("energy", "fine")]
)
def test_a_mesh_nobody_can_make_is_refused(
    store: Store, version: VersionRow, rung: str, mesh: str
) -> None:
    with pytest.raises(QuestionError) as refusal:
        store.submit(version.id, SCENE, rung, 0.05, "ada", mesh=mesh)
    assert refusal.value.field == "mesh"
