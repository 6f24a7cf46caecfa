"""Fields in the whole body: kept with their answer, as long as there is room."""

import pytest

from storage import BodyFiles, NotFoundError, ResultRow, Store, VersionRow
from storage.question import science_version
from tests.storage.conftest import SCENE

ANSWER = {"outcome": "converged", "advice": None, "path": []}


def answered(
    store: Store, version: VersionRow, accuracy: float, files: BodyFiles | None,
    outcome: str = "converged",
) -> ResultRow:  # fmt: skip
    job = store.submit(version.id, SCENE, "fe", accuracy, "ada")
    taken = store.claim(job.id, worker="w", science_version=science_version())
    assert taken is not None
    assert store.finish(job.id, taken.attempt, {**ANSWER, "outcome": outcome}, b"a", files)
    return store.get_result(store.get_job(job.id).digest)


def test_they_come_back_as_they_were_stored(store: Store, version: VersionRow) -> None:
    result = answered(store, version, 0.1, BodyFiles(b"zip", 12))
    assert result.body_files_points == 12
    assert result.body_files_sha256 is not None
    assert store.get_artifact(result.body_files_sha256) == b"zip"
    assert store.artifact_size(result.body_files_sha256) == 3
    without = answered(store, version, 0.05, None)
    assert (without.body_files_sha256, without.body_files_points) == (None, None)


def test_the_oldest_leave_where_all_take_too_much(
    store: Store, version: VersionRow, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(store, "body_files_in_all", 100)
    first = answered(store, version, 0.1, BodyFiles(b"1" * 40, 1))
    second = answered(store, version, 0.05, BodyFiles(b"2" * 40, 1))
    assert store.get_result(first.digest) == first, "both fit"
    third = answered(store, version, 0.02, BodyFiles(b"3" * 30, 1))
    assert store.get_result(first.digest).body_files_sha256 is None
    assert first.body_files_sha256 is not None
    with pytest.raises(NotFoundError):
        store.get_artifact(first.body_files_sha256)
    assert store.get_result(first.digest).artifact_sha256 == first.artifact_sha256
    assert store.get_result(second.digest) == second
    # what does not fit beside any other stands alone
    fourth = answered(store, version, 0.01, BodyFiles(b"4" * 99, 1))
    for older in (second, third):
        assert store.get_result(older.digest).body_files_sha256 is None
    assert store.get_result(fourth.digest) == fourth


def test_equal_files_of_two_answers_stay_as_long_as_one_has_them(
    store: Store, version: VersionRow, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(store, "body_files_in_all", 100)
    answered(store, version, 0.1, BodyFiles(b"same" * 20, 1))
    later = answered(store, version, 0.05, BodyFiles(b"same" * 20, 1))
    assert later.body_files_sha256 is not None
    assert store.get_artifact(later.body_files_sha256) == b"same" * 20


def test_a_complete_answer_replaces_those_of_one_cut_short(
    store: Store, version: VersionRow
) -> None:
    part = answered(store, version, 0.1, BodyFiles(b"part", 3), outcome="budget_spent")
    whole = answered(store, version, 0.1, BodyFiles(b"whole", 12))
    assert whole.digest == part.digest
    assert whole.body_files_points == 12
    assert part.body_files_sha256 is not None
    with pytest.raises(NotFoundError):
        store.get_artifact(part.body_files_sha256)
