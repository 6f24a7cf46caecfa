"""Real processes for the tests: a dispatcher as the web process runs it, and workers."""

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager
from pathlib import Path

from celery import Celery

from actuators.design import preset
from storage import JobRow, Store, open_store
from storage.deployment import TASK, celery_settings

ROOT = Path(__file__).resolve().parents[2]
SLAB = preset("slab-rectangle-low").design.to_document()
ENDED = ("done", "failed", "cancelled")


class Queue:
    """A store, the sweep that sends messages for it, and workers on the same broker."""

    def __init__(self, environment: Mapping[str, str], logs: Path) -> None:
        self.environment = dict(environment)
        self.store: Store = open_store(environment["PNEUSTUDIO_DATABASE"])
        self.store.migrate()
        self.logs = logs
        self._celery = Celery("pneustudio")
        self._celery.conf.update(celery_settings(environment["PNEUSTUDIO_BROKER"]))
        queue = environment.get("PNEUSTUDIO_QUEUE")
        if queue:
            self._celery.conf.task_default_queue = queue
        self._workers: list[subprocess.Popen[bytes]] = []
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._sweep, daemon=True)
        self._thread.start()
        design = self.store.create_design("Finger", "ada", SLAB, {"pressure_kPa": {"to": 30}}, "")
        self.version = design[1]

    def send(self, job_id: str) -> None:
        self._celery.send_task(TASK, args=[job_id])

    def _sweep(self) -> None:
        while not self._stop.wait(0.2):
            for job_id in self.store.sweep():
                self.send(job_id)

    def start_worker(
        self, name: str, module: str = "tests.worker.slow_worker"
    ) -> subprocess.Popen[bytes]:
        with (self.logs / f"{name}.log").open("ab") as log:
            worker = subprocess.Popen(
                [sys.executable, "-m", module, "--name", f"{name}@test"],
                env={**os.environ, **self.environment}, cwd=ROOT, start_new_session=True,
                stdout=log, stderr=log,
            )  # fmt: skip
        self._workers.append(worker)
        return worker

    def log(self, name: str) -> str:
        return (self.logs / f"{name}.log").read_text()

    def ask(self, pressure_kPa: float, rung: str = "energy", **more: float) -> JobRow:
        """A question of its own for every pressure."""
        scene = {"pressure_kPa": {"to": pressure_kPa}}
        return self.store.submit(self.version.id, scene, rung, 0.05, "ada", **more)

    def wait(self, job: JobRow, *states: str, timeout_s: float = 60) -> JobRow:
        """The row once it is in one of the states (ended, if none is named)."""
        return self._until(job, lambda row: row.state in (states or ENDED), timeout_s)

    def wait_for_progress(self, job: JobRow, fraction: float = 0.2) -> JobRow:
        """The row once the solver has come so far."""
        return self._until(job, lambda r: r.state == "running" and r.fraction >= fraction, 60)

    def _until(self, job: JobRow, fine: Callable[[JobRow], bool], timeout_s: float) -> JobRow:
        deadline = time.monotonic() + timeout_s
        row = self.store.get_job(job.id)
        while not fine(row):
            if time.monotonic() > deadline:
                raise TimeoutError(f"after {timeout_s} s still {row}; logs in {self.logs}")
            time.sleep(0.02)
            row = self.store.get_job(job.id)
        return row

    def close(self) -> None:
        self._stop.set()
        self._thread.join()
        for worker in self._workers:
            kill_group(worker)
        self._celery.close()
        self.store.close()


def kill_group(process: subprocess.Popen[bytes]) -> None:
    """``kill -9`` of a process and everything it started."""
    if process.poll() is None:
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


@contextmanager
def embedded_queue(folder: Path) -> Generator[Queue]:
    """SQLite and the filesystem broker in one folder."""
    environment = {
        "PNEUSTUDIO_DATA": str(folder),
        "PNEUSTUDIO_DATABASE": f"sqlite:///{folder / 'pneustudio.sqlite'}",
        "PNEUSTUDIO_BROKER": f"filesystem://{folder / 'queue'}",
    }
    queue = Queue(environment, folder)
    try:
        yield queue
    finally:
        queue.close()


def processes_of(data: Path) -> list[str]:
    """Command lines of all living processes that were started for a data folder."""
    mark = f"PNEUSTUDIO_DATA={data}".encode()
    found: list[str] = []
    for entry in Path("/proc").iterdir():
        try:
            if entry.name.isdigit() and mark in (entry / "environ").read_bytes().split(b"\0"):
                command = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode()
                found.append(f"{entry.name} {command}")
        except (FileNotFoundError, ProcessLookupError, PermissionError):
            continue  # it ended meanwhile
    return found
