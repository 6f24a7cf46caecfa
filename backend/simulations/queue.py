"""Waking workers: a message that names a job. The job table is the truth; a message that is lost
is sent again by the sweep."""

import asyncio
import logging

from celery import Celery
from kombu.exceptions import OperationalError

from storage import Store
from storage.deployment import TASK, celery_settings

SWEEP_S = 1.0

log = logging.getLogger(__name__)


class TaskQueue:
    """Sends tasks by name and sweeps the job table; knows no worker."""

    def __init__(self, broker: str) -> None:
        self._celery = Celery("pneustudio")
        self._celery.conf.update(celery_settings(broker))

    def publish(self, store: Store) -> None:
        """Sweep the job table, and send a message for every job that needs one. A broker that is
        away costs nothing but time: the next sweep sends again."""
        for job_id in store.sweep():
            try:
                self._celery.send_task(TASK, args=[job_id], ignore_result=True, retry=False)
            except (OperationalError, OSError) as error:
                log.warning("no message for job %s: %s", job_id, error)

    async def keep_publishing(self, store: Store) -> None:
        """Sweep each second until cancelled."""
        while True:
            try:
                await asyncio.to_thread(self.publish, store)
            except Exception:  # a database that is away must not end the sweep
                log.exception("sweeping the job table failed; trying again")
            await asyncio.sleep(SWEEP_S)

    def close(self) -> None:
        """Give connections back."""
        self._celery.close()
