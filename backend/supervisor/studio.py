"""The embedded studio: its children, from the first to the last."""

import os
import shutil
import signal
import socket
import sys
import threading
import time
from collections.abc import Callable

from backend.supervisor.address import answers
from backend.supervisor.child import Child
from backend.supervisor.folder import DataFolder
from storage import Store, StoreAway, open_store
from storage.deployment import Deployment

_WEB_GRACE_S, _WORKER_GRACE_S = 4.0, 6.0
_WORKER_NICE = 5  # the page stays quick while a job takes every core
_START_S = 90.0


class Studio:
    """Web process and workers of one data folder."""

    def __init__(
        self, places: Deployment, folder: DataFolder, *, host: str, port: int, workers: int,
        address: str, say: Callable[[str], None],
    ) -> None:  # fmt: skip
        self._places = places
        self._folder = folder
        self._address = address
        self._say = say
        self._store: Store = open_store(places.database)
        self._stop = threading.Event()
        self._kill = False
        self._lock = folder.lock()
        folder.sign(address)
        self._children = [
            self._web(host, port),
            *(self._worker(number, workers) for number in range(1, workers + 1)),
        ]

    def run(self) -> None:
        """Run until SIGINT or SIGTERM; a second one ends everything at once."""
        for each in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(each, self._asked_to_stop)
        self._prepare()
        try:
            for child in self._children:
                child.start()
            if answers(self._address, timeout_s=_START_S, meanwhile=self._tend):
                self._say(f"Pneustudio is ready: {self._address}   (Ctrl-C ends it)")
            elif not self._stop.is_set():
                self._say(f"The page does not answer yet; see {self._folder.logs / 'web.log'}")
            while not self._stop.wait(0.1):
                self._tend()
        finally:
            self._end()

    def _prepare(self) -> None:
        if self._places.embedded:
            # old messages; the job table knows every job that still wants one
            shutil.rmtree(self._folder.queue, ignore_errors=True)
        self._store.migrate()
        if self._places.embedded:
            # what a crash of the whole machine left running: this folder is ours alone
            self._store.release(None, lost=True)
        self._store.close()

    def _tend(self) -> bool:
        for child in self._children:
            child.tend()
        return not self._stop.is_set()

    def _end(self) -> None:
        self._say("Stopping ...")
        for child in self._children:
            child.ask_to_end()
        waiting = list(self._children)
        deadline = time.monotonic() + max(_WEB_GRACE_S, _WORKER_GRACE_S) + 2
        while waiting and time.monotonic() < deadline:
            waiting = [child for child in waiting if not child.wait(0.05)]
            if self._kill:
                for child in waiting:
                    child.kill()
        if self._places.embedded:
            self._store.release(None, lost=False)
        self._store.close()
        self._say("Stopped.")

    def _asked_to_stop(self, _number: int, _frame: object) -> None:
        self._kill = self._stop.is_set()
        self._stop.set()

    def _web(self, host: str, port: int) -> Child:
        command = [
            sys.executable, "-m", "uvicorn", "backend.app:create_app", "--factory",
            "--host", host, "--port", str(port), "--ws-per-message-deflate", "false",
            "--timeout-graceful-shutdown", "2", "--no-access-log", "--no-server-header",
        ]  # fmt: skip
        return Child(
            "web", command, self._places.environment, self._folder.logs / "web.log",
            _WEB_GRACE_S, inherit=(self._lock,), say=self._say,
        )  # fmt: skip

    def _worker(self, number: int, count: int) -> Child:
        label = f"worker-{number}"
        name = f"{label}@{socket.gethostname()}"
        threads = str(max(1, (os.cpu_count() or 1) // count))
        variables = ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
        limits = {each: os.environ.get(each, threads) for each in variables}

        def ended() -> None:
            try:
                for job_id in self._store.release(name, lost=True):
                    again = self._store.get_job(job_id).active
                    told = "it is queued again" if again else "it is given up"
                    self._say(f"{label} was computing job {job_id}; {told}")
            except StoreAway:
                self._say(f"{label}: the database does not answer; its lease will run out")
            self._store.close()

        return Child(
            label, [sys.executable, "-m", "worker", "--name", name],
            {**self._places.environment, **limits}, self._folder.logs / f"{label}.log",
            _WORKER_GRACE_S, nice=_WORKER_NICE, inherit=(self._lock,), ended=ended, say=self._say,
        )  # fmt: skip
