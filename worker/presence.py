"""A worker's life: it loads its solver, reports that it is there, and leaves in order."""

import importlib
import logging
import os
import signal
import threading
import time
from typing import Any

from billiard.process import active_children
from celery import signals

from storage import StoreAway, open_store
from storage.deployment import deployment
from storage.question import science_version
from worker.app import child_store

_logger = logging.getLogger(__name__)
_PERIOD_S = 3.0


def announce(name: str) -> None:
    """Connect the worker ``name`` to Celery's signals."""

    def child_starts(**_: Any) -> None:
        threading.Thread(target=_report, args=(name,), name="presence", daemon=True).start()
        load_solver()

    def leave(**_: Any) -> None:
        # Celery's own ways out wait for the running job, or hang. Here nothing is worth waiting
        # for: the jobs are handed back, and what their solvers still wrote would be refused.
        try:
            for child in active_children():
                os.kill(child.pid, signal.SIGKILL)
            _hand_back(name)
        except StoreAway:
            _logger.exception("the jobs could not be handed back; their leases will run out")
        finally:
            os._exit(0)

    signals.worker_process_init.connect(child_starts, weak=False)
    signals.worker_shutting_down.connect(leave, weak=False)


def _hand_back(name: str) -> None:
    store = open_store(deployment().database)
    for job_id in store.release(name, lost=False):
        _logger.info("job %s: handed back", job_id)
    store.worker_left(name)


def _report(name: str) -> None:
    # in the pool's child: its parent forks, and a fork must find no thread inside the database
    while True:
        try:
            child_store().worker_seen(name, science_version())
        except Exception:
            _logger.exception("cannot report, trying again in %g s", _PERIOD_S)
        time.sleep(_PERIOD_S)


def load_solver() -> None:
    """Read the compiled kernels and the direct solver now, so that the first job does not wait."""
    started = time.perf_counter()
    importlib.import_module("actuators.mechanics.continuum.warm").exercise()
    _logger.info("solver loaded in %.1f s", time.perf_counter() - started)
