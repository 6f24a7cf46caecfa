"""A real finite-element job through the whole studio, with its worker killed in the middle."""

import os
import signal
import time
from collections.abc import Generator
from pathlib import Path

import pytest

from actuators.design import preset
from storage import JobRow, Store, open_store
from storage.response_arrays import unpack
from tests.worker.processes import processes_of
from tests.worker.test_supervisor import Run

SCENE = {"pressure_kPa": {"to": 10}}


@pytest.fixture
def data(tmp_path: Path) -> Generator[Path]:
    folder = tmp_path / "studio"
    yield folder
    for line in processes_of(folder):
        os.kill(int(line.split()[0]), signal.SIGKILL)


def until(store: Store, job: JobRow, fraction: float, timeout_s: float) -> JobRow:
    deadline = time.monotonic() + timeout_s
    row = store.get_job(job.id)
    while row.active and row.fraction < fraction:
        assert time.monotonic() < deadline, row
        time.sleep(0.02)
        row = store.get_job(job.id)
    return row


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_an_fe_job_whose_worker_is_killed_finishes_anyway_once(data: Path) -> None:
    run = Run(data, "--port", "0")
    run.address()
    store = open_store(f"sqlite:///{data / 'pneustudio.sqlite'}")
    slab = preset("slab-rectangle-low").design.to_document()
    _, version = store.create_design("Finger", "ada", slab, SCENE, "")
    job = store.submit(version.id, SCENE, "fe", 0.2, "ada")
    assert until(store, job, 0.3, 300).state == "running"
    for line in processes_of(data):
        if " -m worker " in line and "guard.py" not in line:
            os.kill(int(line.split()[0]), signal.SIGKILL)
    killed_at = time.monotonic()
    while store.get_job(job.id).attempt < 2:
        assert time.monotonic() - killed_at < 20, store.get_job(job.id)
        time.sleep(0.02)
    recovered_s = time.monotonic() - killed_at
    row = until(store, job, 2.0, 600)
    assert (row.state, row.attempt, row.lost, row.error) == ("done", 2, 1, None)
    closings = [e for e in store.events_after(0, limit=100_000)
                if e.subject == job.id and e.data["state"] == "done"]  # fmt: skip
    assert len(closings) == 1
    result = store.get_result(row.digest)
    assert result.document["path"][-1]["pressure_kPa"] == pytest.approx(10)
    assert result.artifact_sha256 is not None
    arrays = unpack(store.get_artifact(result.artifact_sha256))
    assert arrays.surface is not None
    assert len(arrays.surface.displacement) == len(result.document["path"])
    store.close()
    run.process.send_signal(signal.SIGINT)
    assert run.process.wait(15) == 0
    print(f"computing again {recovered_s:.1f} s after the kill; {row.elapsed_s():.1f} s in all")
