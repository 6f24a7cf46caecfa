"""The loop that keeps jobs moving: whoever can send messages runs it, each second."""

import logging
import threading
import time
from collections.abc import Callable

from storage.store import Store

PERIOD_S = 1.0
_PRUNE_S = 600.0
_logger = logging.getLogger(__name__)


class Dispatch:
    """Sweeps the job table in a thread and sends a message for each job that waits for one.

    ``send`` takes a job id. It may fail or be late: the job is swept up again. Several processes
    may dispatch at once; the worst is a doubled message, which does nothing.
    """

    def __init__(
        self, store: Store, send: Callable[[str], None], period_s: float = PERIOD_S
    ) -> None:
        self._store = store
        self._send = send
        self._period_s = period_s
        self._wake = threading.Event()
        self._stopping = False
        self._pruned_at = time.monotonic()
        self._thread = threading.Thread(target=self._run, name="dispatch", daemon=True)

    def start(self) -> None:
        self._thread.start()

    def nudge(self) -> None:
        """Sweep now: a job has just been submitted."""
        self._wake.set()

    def stop(self) -> None:
        self._stopping = True
        self._wake.set()
        self._thread.join(timeout=5)

    def once(self) -> list[str]:
        """One sweep; the ids that were sent."""
        ids = self._store.sweep()
        for job_id in ids:
            self._send(job_id)
        if time.monotonic() - self._pruned_at > _PRUNE_S:
            self._pruned_at = time.monotonic()
            self._store.prune_events()
        return ids

    def _run(self) -> None:
        while not self._stopping:
            try:
                self.once()
            except Exception:
                # database or broker away for a while: the next sweep finds everything again
                _logger.exception("sweep failed, trying again in %g s", self._period_s)
            self._wake.wait(self._period_s)
            self._wake.clear()
