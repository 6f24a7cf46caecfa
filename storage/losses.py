"""What is done when a worker dies or leaves: its jobs go back into the queue, and messages are sent
for those that wait. A job whose workers vanish again and again is given up."""

import time
from datetime import timedelta
from typing import Any

from sqlalchemy import Connection, and_, or_, select, update

from storage import tables
from storage.claims import Claims
from storage.jobs import jobs_where
from storage.rows import JobRow

MAX_LOST = 3
_RESEND_IDLE = timedelta(seconds=5)
_RESEND_BUSY = timedelta(seconds=30)
_RESEND_COUNT = 8
_PRUNE_S = 600.0


class Losses(Claims):
    """Taking jobs back."""

    _prune_at = 0.0

    def release(self, worker: str | None, *, lost: bool) -> list[str]:
        """Put the jobs of a worker back (of every worker if None), without waiting for the lease:
        ``lost`` when it died, else when it leaves in order. Returns their ids."""
        j = tables.job.c
        mine = and_(j.state == "running", j.follows.is_(None))
        if worker is not None:
            mine = and_(mine, j.worker == worker)
        with self._write() as connection:
            jobs = jobs_where(connection, mine)
            for job in jobs:
                self._give_back(connection, job, lost=lost)
            self._resend_all(connection)
        return [job.id for job in jobs]

    def sweep(self) -> list[str]:
        """Put jobs whose lease ran out back into the queue, and return the ids of the queued jobs
        that a message must now be sent for; now and then, prune the events. Due each second, by
        one process or several."""
        if time.monotonic() > self._prune_at:
            self._prune_at = time.monotonic() + _PRUNE_S
            self.prune_events()
        j = tables.job.c
        with self._read() as connection:
            now = self._now(connection)
            expired = _expired(now)
            if not connection.execute(
                select(j.id).where(or_(expired, _waiting())).limit(1)
            ).first():
                return []
        with self._write() as connection:
            for job in jobs_where(connection, expired):
                self._give_back(connection, job, lost=True)
            return self._publish(connection)

    def _publish(self, connection: Connection) -> list[str]:
        """Ids to send a message for: new ones, and those whose message seems to be lost."""
        j = tables.job
        now = self._now(connection)
        running = connection.execute(select(j.c.id).where(j.c.state == "running").limit(1)).first()
        patience = _RESEND_BUSY if running else _RESEND_IDLE
        ordered = (j.c.created_at, j.c.id)
        new = select(j.c.id).where(_waiting(), j.c.published_at.is_(None)).order_by(*ordered)
        oldest = select(j.c.id, j.c.published_at).where(_waiting()).order_by(*ordered)
        due = [
            row.id
            for row in connection.execute(oldest.limit(_RESEND_COUNT))
            if row.published_at is not None and row.published_at < now - patience
        ]
        ids = [*due, *connection.execute(new).scalars()]
        connection.execute(update(j).where(j.c.id.in_(ids)).values(published_at=now))
        return ids

    def _resend_all(self, connection: Connection) -> None:
        # messages that a dead worker had taken died with it, and nobody knows which
        connection.execute(update(tables.job).where(_waiting()).values(published_at=None))

    def _give_back(self, connection: Connection, job: JobRow, *, lost: bool) -> None:
        losses = job.lost + lost
        if job.cancel_requested:
            self._end_cancelled(connection, job.id)
        elif losses >= MAX_LOST:
            self._change_job(connection, job.id, lost=losses)
            at = "" if job.pressure is None else f", last at {job.pressure / 1e3:.3g} kPa"
            self._close_failed(
                connection, job,
                f"The worker was lost {losses} times while computing this{at}; most often it "
                "ran out of memory.", "worker_lost",
                "Ask for a coarser accuracy or mesh, or look into the worker's log.",
            )  # fmt: skip
        else:
            self._change_job(
                connection, job.id, state="queued", lost=losses, lease_until=None, worker=None,
                message="The worker was lost; starting again" if lost else "Waiting for a worker",
            )  # fmt: skip
            self._resend_all(connection)


def _expired(now: Any) -> Any:
    j = tables.job.c
    return and_(j.state == "running", j.follows.is_(None), j.lease_until < now)


def _waiting() -> Any:
    j = tables.job.c
    return and_(j.state == "queued", j.follows.is_(None))
