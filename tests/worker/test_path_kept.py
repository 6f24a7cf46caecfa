"""The part of the path found so far is kept while a job runs, at little cost, and outlives it."""

import math
import time
from collections.abc import Generator
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from actuators.design import preset
from actuators.mechanics.response import Outcome
from actuators.mechanics.scene import Scene
from storage import JobRow, Part, Store, open_store
from storage.response_arrays import unpack
from tests.worker.processes import Queue, embedded_queue, kill_group
from tests.worker.slow_worker import STEPS, straight
from worker import keeper, path_kept
from worker.path_kept import SHARE, PathKept
from worker.rungs import RUNGS, Solved
from worker.solving import solve_job

DESIGN = preset("slab-rectangle-low").design
SCENE = Scene(20e3)


@pytest.fixture
def queue(tmp_path: Path) -> Generator[Queue]:
    with embedded_queue(tmp_path) as opened:
        yield opened


@pytest.fixture
def store(tmp_path: Path) -> Store:
    opened = open_store(f"sqlite:///{tmp_path / 'studio.sqlite'}")
    opened.migrate()
    return opened


def kept(store: Store, row: JobRow) -> list[float]:
    """Pressures [kPa] of the part that is a job's result."""
    assert row.has_answer
    result = store.get_result(row.digest)
    assert result.document["outcome"] == row.outcome
    assert result.artifact_sha256 is not None
    pressures = [point["pressure_kPa"] for point in result.document["path"]]
    for point in result.document["path"]:
        assert all(math.isfinite(x) for x in point["tip_mm"])
    arrays = unpack(store.get_artifact(result.artifact_sha256))
    assert (arrays.pressures / 1e3).tolist() == pytest.approx(pressures)
    return pressures


def test_a_job_whose_workers_are_killed_shows_what_they_had_found(queue: Queue) -> None:
    job = queue.ask(20)
    row = job
    for _ in range(3):
        worker = queue.start_worker("w1")
        queue.wait_for_progress(job, 0.5)
        kill_group(worker)
        queue.store.release("w1@test", lost=True)
        row = queue.store.get_job(job.id)
    assert (row.state, row.outcome, row.lost) == ("failed", "worker_lost", 3)
    pressures = kept(queue.store, row)
    assert pressures[0] == 0
    assert 0 < pressures[-1] < 20
    assert row.advice is not None
    assert f"up to {pressures[-1]:.3g} of 20 kPa, is kept" in row.advice
    again = queue.ask(20)
    queue.start_worker("w1")
    row = queue.wait(again)
    assert (row.state, row.outcome) == ("done", "converged")
    assert kept(queue.store, row)[-1] == pytest.approx(20)


def test_a_solver_that_raises_leaves_all_that_it_had_found(queue: Queue) -> None:
    queue.start_worker("w1")
    row = queue.wait(queue.ask(20, rung="fe"))
    assert (row.state, row.outcome) == ("failed", "failed")
    assert kept(queue.store, row)[-1] == pytest.approx(20 * 9 / STEPS)
    assert row.advice is not None
    assert "up to 4.5 of 20 kPa, is kept" in row.advice
    assert row.id in row.advice


def test_a_solver_ended_with_its_process_leaves_what_was_kept_by_then(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A step that goes on and on after the budget is spent."""

    class Ended(BaseException):
        pass

    ended: list[int] = []

    def endless(design: Any, scene: Scene, **seam: Any) -> Solved:
        for step in range(1, 10):
            seam["found"](partial(straight, design, scene, Outcome.CANCELLED, step))
            time.sleep(0.05)
        while not ended:
            seam["cancelled"]()
            time.sleep(0.01)
        raise Ended

    monkeypatch.setattr(path_kept, "FIRST_S", 0.0)
    monkeypatch.setitem(keeper.GRACE_S, "budget", 0.1)
    monkeypatch.setattr(keeper.Keeper.__init__, "__defaults__", (ended.append,))
    monkeypatch.setitem(RUNGS, "fe", endless)
    scene = SCENE.to_document()
    _, version = store.create_design("Finger", "ada", DESIGN.to_document(), scene, "")
    job = store.submit(version.id, scene, "fe", 0.05, "ada", budget_s=0.8)
    with pytest.raises(Ended):
        solve_job(store, job.id, worker="w")
    row = store.get_job(job.id)
    assert (row.state, row.outcome) == ("failed", "budget_spent")
    assert kept(store, row)[-1] > 0


def test_what_cannot_be_made_or_stored_does_not_hurt_the_job(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[int] = []

    def no_part() -> Any:
        made.append(1)
        raise MemoryError

    def solve(design: Any, scene: Scene, **seam: Any) -> Solved:
        seam["found"](no_part)
        for step in range(1, 4):
            seam["found"](partial(straight, design, scene, Outcome.CANCELLED, step))
            time.sleep(0.4)
        return Solved(straight(design, scene, Outcome.CONVERGED, STEPS))

    def away(job_id: str, attempt: int, part: Part) -> bool:
        made.append(len(part.document["path"]))
        raise OSError("the store is away")

    monkeypatch.setattr(path_kept, "FIRST_S", 0.0)
    monkeypatch.setattr(path_kept, "SHARE", 1.0)
    monkeypatch.setattr(store, "keep_part", away)
    monkeypatch.setitem(RUNGS, "fe", solve)
    scene = SCENE.to_document()
    _, version = store.create_design("Finger", "ada", DESIGN.to_document(), scene, "")
    job = store.submit(version.id, scene, "fe", 0.05, "ada")
    solve_job(store, job.id, worker="w")
    row = store.get_job(job.id)
    assert (row.state, row.outcome) == ("done", "converged")
    assert len(made) > 1
    assert kept(store, row)[-1] == pytest.approx(20)


@pytest.mark.parametrize(("state_s", "make_s"), [(0.1, 0.01), (1.0, 0.1), (40.0, 1.0)])
def test_it_takes_a_small_share_of_the_time_and_is_never_far_behind(
    monkeypatch: pytest.MonkeyPatch, state_s: float, make_s: float
) -> None:
    now = 0.0
    monkeypatch.setattr("time.process_time", lambda: now)
    monkeypatch.setattr("time.thread_time", lambda: now)
    path = PathKept()
    spent, behind, waited = 0.0, 0.0, 0.0

    def make(steps: int) -> Any:
        nonlocal now, spent
        now += make_s
        spent += make_s
        return straight(DESIGN, SCENE, Outcome.CANCELLED, steps)

    for _ in range(500):
        now += state_s
        path.offer(partial(make, 1))
        if path.take() is not None:
            now += 0.3 * make_s
            spent += 0.3 * make_s
            path.spend(0.3 * make_s)
            waited = now
        behind = max(behind, now - waited)
    assert spent <= SHARE * now + 1.3 * make_s
    assert behind <= 5 + 2 * state_s + 2 * 1.3 * make_s / SHARE
