"""Keeps a claimed job alive while it is computed: lease, progress, cancel, time budget."""

import logging
import os
import threading
import time
from collections.abc import Callable
from types import TracebackType
from typing import Literal

from storage import ClaimedJob, Hold, Part, Store
from storage.claims import LEASE
from worker.path_kept import Make, PathKept, as_part
from worker.rungs import Report

Stop = Literal["cancel", "gone", "budget"]

_logger = logging.getLogger(__name__)
_LOOK_S = 0.5  # how often the job's row is looked at
_TELL_S = 0.2  # progress is told at most this often
GRACE_S = {"cancel": 3.0, "gone": 3.0, "budget": 60.0}  # then the process ends


class Keeper:
    """A thread beside the solver, which does the talking to the store.

    The solver calls :meth:`report`, :meth:`found` and :meth:`cancelled`, none of which waits for
    the store.
    A solver that does not stop when it should is ended with its process: ``end_process``.
    """

    def __init__(
        self, store: Store, job: ClaimedJob, end_process: Callable[[int], object] = os._exit
    ) -> None:
        self.stop: Stop | None = None
        self._store = store
        self._job = job
        self._end_process = end_process
        self._deadline = time.monotonic() + job.budget_s
        self._beat_at = time.monotonic()
        self._stop_at = 0.0
        self._latest: Report | None = None
        self._fraction = 0.0
        self._path = PathKept()
        self._news = threading.Event()
        self._solved = False
        self._left = False
        self._thread = threading.Thread(target=self._run, name=f"keeper-{job.id}", daemon=True)

    def __enter__(self) -> "Keeper":
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:  # fmt: skip
        self._left = True
        self._news.set()
        self._thread.join()

    def report(self, progress: Report) -> None:
        """Progress callback of the solver."""
        self._latest = progress
        self._fraction = progress.fraction
        self._news.set()

    def found(self, make: Make) -> None:
        """Callback of the solver, with every state of its path."""
        self._path.offer(make)

    def part(self) -> Part | None:
        """All that the solver had found when it broke down."""
        try:
            newest = self._path.newest()
            return None if newest is None else as_part(newest, self._fraction)
        except Exception:
            _logger.exception("job %s: no part of the path", self._job.id)
            return None

    def cancelled(self) -> bool:
        """Cancel callback of the solver."""
        self._path.look()
        if self.stop is None and time.monotonic() > self._deadline:
            self._order("budget")
        return self.stop is not None

    def solved(self) -> None:
        """The solver has returned: keep the lease until the answer is stored, and nothing else."""
        self._solved = True

    def _run(self) -> None:
        told_at = 0.0
        while not self._left:
            if self._news.wait(_LOOK_S):
                time.sleep(max(0.0, told_at + _TELL_S - time.monotonic()))
                told_at = time.monotonic()
            self._news.clear()
            if self._left:
                return
            try:
                self._look()
            except Exception:
                # the store is away: the lease may hold until it is back, and if not, the fence does
                _logger.exception("job %s: the store does not answer", self._job.id)
            self._enforce()

    def _look(self) -> None:
        job_id, attempt = self._job.id, self._job.attempt
        latest, self._latest = self._latest, None
        now = time.monotonic()
        if latest is not None:
            hold = self._store.progress(
                job_id, attempt, fraction=latest.fraction, message=latest.message,
                pressure=latest.pressure,
            )  # fmt: skip
            self._beat_at = now
        elif now - self._beat_at >= LEASE.total_seconds() / 6 - _LOOK_S / 2:
            hold = self._store.heartbeat(job_id, attempt)
            self._beat_at = now
        else:
            hold = self._store.hold(job_id, attempt)
        if not self._solved and self.stop is None and hold is not Hold.HELD:
            self._order("cancel" if hold is Hold.CANCEL else "gone")
        if not self._solved and hold is not Hold.GONE:
            self._keep_part()

    def _keep_part(self) -> None:
        made = self._path.take()
        if made is None:
            return
        started, worked = time.perf_counter(), time.thread_time()
        part = as_part(made, self._fraction)
        self._store.keep_part(self._job.id, self._job.attempt, part)
        self._path.spend(time.thread_time() - worked)
        _logger.info(
            "job %s: %d points kept, %.2f MB, %.2f s", self._job.id, len(made.path),
            len(part.arrays) / 1e6, time.perf_counter() - started,
        )  # fmt: skip

    def _order(self, why: Stop) -> None:
        _logger.info("job %s: stopping (%s)", self._job.id, why)
        self._stop_at = time.monotonic()
        self.stop = why

    def _enforce(self) -> None:
        late = time.monotonic() - self._stop_at
        if self._solved or self.stop is None or late < GRACE_S[self.stop]:
            return
        _logger.warning(
            "job %s: did not stop within %.0f s, ending the process", self._job.id, late
        )
        if self.stop == "cancel":
            self._store.confirm_cancel(self._job.id, self._job.attempt)
        elif self.stop == "budget":
            self._store.fail(
                self._job.id, self._job.attempt,
                f"The time budget of {budget(self._job)} was spent within one step.",
                why="budget_spent", advice="Ask for a coarser accuracy or mesh.",
            )  # fmt: skip
        self._end_process(1)


def budget(job: ClaimedJob) -> str:
    """The job's time budget to read."""
    return f"{job.budget_s:.0f} s" if job.budget_s < 90 else f"{job.budget_s / 60:.0f} min"
