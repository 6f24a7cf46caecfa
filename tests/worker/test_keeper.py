"""The thread beside the solver, without any worker process."""

import time
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import pytest

from actuators.design import Design, preset
from actuators.errors import DesignError
from actuators.mechanics.scene import Scene
from storage import Store, open_store
from storage.claims import LEASE
from storage.question import JOB_RUNGS
from worker.rungs import RUNGS, Solved
from worker.solving import solve_job


@dataclass(frozen=True)
class Step:
    fraction: float
    message: str
    pressure: float | None


@pytest.fixture
def store(tmp_path: Path) -> Store:
    opened = open_store(f"sqlite:///{tmp_path / 'studio.sqlite'}")
    opened.migrate()
    return opened


def ask(store: Store, rung: str) -> str:
    scene = {"pressure_kPa": {"to": 20, "steps": 4}}
    slab = preset("slab-rectangle-low").design.to_document()
    _, version = store.create_design("Finger", "ada", slab, scene, "")
    return store.submit(version.id, scene, rung, 0.05, "ada").id


def test_every_rung_that_can_be_asked_for_has_a_solver() -> None:
    assert set(RUNGS) == set(JOB_RUNGS)


def test_the_energy_model_answers_as_a_job(store: Store) -> None:
    job_id = ask(store, "energy")
    solve_job(store, job_id, worker="w")
    row = store.get_job(job_id)
    assert (row.state, row.outcome, row.error) == ("done", "converged", None)
    path = store.get_result(row.digest).document["path"]
    assert path[-1]["pressure_kPa"] == pytest.approx(20)
    assert path[-1]["bending_angle_deg"] > 1


def test_a_flood_of_progress_becomes_a_few_events(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    def chatty(design: Design, scene: Scene, **seam: object) -> Solved:
        progress = seam["progress"]
        assert callable(progress)
        for i in range(1000):
            progress(Step(i / 1000, f"step {i}", None))
            time.sleep(0.001)
        raise DesignError("The roof is too thin.", field="roof")

    monkeypatch.setitem(RUNGS, "fe", chatty)
    job_id = ask(store, "fe")
    solve_job(store, job_id, worker="w")
    told = [e for e in store.events_after(0) if e.data.get("state") == "running"]
    assert 3 <= len(told) <= 15
    row = store.get_job(job_id)
    assert (row.outcome, row.error) == ("refused", "The roof is too thin.")


def test_the_lease_of_a_silent_solver_is_renewed(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    beats: list[float] = []
    renew = store.heartbeat

    def counted(job_id: str, attempt: int) -> object:
        beats.append(time.monotonic())
        return renew(job_id, attempt)

    def silent(design: Design, scene: Scene, **_: object) -> Solved:
        time.sleep(4)
        raise DesignError("Enough.", field="x")

    monkeypatch.setattr(store, "heartbeat", counted)
    monkeypatch.setitem(RUNGS, "fe", silent)
    solve_job(store, ask(store, "fe"), worker="w")
    assert len(beats) >= 2
    gaps = [b - a for a, b in pairwise(beats)]
    assert max(gaps) < LEASE.total_seconds() / 3


def test_a_solver_whose_claim_is_gone_stores_nothing(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    def overtaken(design: Design, scene: Scene, **seam: object) -> Solved:
        cancelled = seam["cancelled"]
        assert callable(cancelled)
        store.release("w", lost=True)
        taken = store.claim(job_id, worker="w2", science_version="b" * 64)
        assert taken is not None
        deadline = time.monotonic() + 5
        while not cancelled() and time.monotonic() < deadline:
            time.sleep(0.05)
        assert cancelled()
        raise DesignError("Given up.", field="x")

    monkeypatch.setitem(RUNGS, "fe", overtaken)
    job_id = ask(store, "fe")
    solve_job(store, job_id, worker="w")
    row = store.get_job(job_id)
    assert (row.state, row.worker, row.attempt, row.error) == ("running", "w2", 2, None)
