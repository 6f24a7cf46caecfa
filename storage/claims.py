"""The worker's side of a job: claim it, keep it, report, finish; and what is done when it dies.

A claim is a lease. Every later write names the attempt it belongs to, so that a worker that was
given up (asleep, cut off) can write nothing any more. The job's row is the truth, a message in the
broker only wakes a worker.
"""

import time
from collections.abc import Mapping
from datetime import timedelta
from typing import Any

from sqlalchemy import Connection, and_, func, or_, select, update

from storage import tables
from storage.body_files import BodyFiles
from storage.jobs import jobs_where
from storage.question import Failure, question_digest
from storage.results import closed_result
from storage.rows import ClaimedJob, Hold, JobRow, ResultRow
from storage.submission import Submission

LEASE = timedelta(seconds=9)
MAX_LOST = 3
_RESEND_IDLE = timedelta(seconds=5)
_RESEND_BUSY = timedelta(seconds=30)
_RESEND_COUNT = 8
_PRUNE_S = 600.0


class Claims(Submission):
    """Claiming, keeping and ending jobs; all of it safe to repeat."""

    _prune_at = 0.0

    def claim(
        self, job_id: str, *, worker: str, science_version: str, lease: timedelta = LEASE
    ) -> ClaimedJob | None:
        """Take a queued job; None if there is nothing to take (running, ended, cancelled).

        The question is named anew after the ``science_version`` of the worker: that is the one
        that answers.
        """
        j = tables.job
        with self._write() as connection:
            found = jobs_where(connection, j.c.id == job_id, j.c.follows.is_(None))
            if not found:
                return None
            job = found[0]
            digest = question_digest(
                job.design_digest,
                job.scene_digest,
                job.rung,
                job.accuracy,
                science_version,
                job.mesh,
            )
            now = self._now(connection)
            taken = connection.execute(
                update(j)
                .where(j.c.id == job_id, j.c.state == "queued", ~j.c.cancel_requested)
                .values(attempt=j.c.attempt + 1, worker=worker, lease_until=now + lease)
                .returning(j.c.attempt)
            ).scalar_one_or_none()
            if taken is None:
                return None
            answer = closed_result(connection, digest)
            named = {"science_version": science_version, "digest": digest}
            if answer is not None:
                self._close_done(connection, job, answer.document, from_store=True, **named)
                return None
            self._change_job(
                connection, job_id, state="running", attempt=taken, fraction=0.0, pressure=None,
                message="Starting", started_at=func.coalesce(j.c.started_at, now.timestamp()),
                **named,
            )  # fmt: skip
            v = tables.version.c
            document = connection.execute(
                select(v.document).where(v.id == job.version_id)
            ).scalar_one()
            return ClaimedJob(
                job_id,
                taken,
                document,
                job.scene,
                job.rung,
                job.accuracy,
                digest,
                job.budget_s,
                job.mesh,
            )

    def hold(self, job_id: str, attempt: int) -> Hold:
        """What the claim is worth now, without renewing it."""
        j = tables.job.c
        with self._read() as connection:
            return _hold(
                connection.execute(
                    select(j.cancel_requested).where(_held(job_id, attempt))
                ).scalar_one_or_none()
            )

    def heartbeat(self, job_id: str, attempt: int, *, lease: timedelta = LEASE) -> Hold:
        """Renew the lease; due every ``lease / 6``."""
        with self._write() as connection:
            return self._renew(connection, job_id, attempt, lease)

    def progress(
        self,
        job_id: str,
        attempt: int,
        *,
        fraction: float,
        message: str,
        pressure: float | None = None,
        lease: timedelta = LEASE,
    ) -> Hold:
        """Report how far the solver is (0 to 1, Pa) and renew the lease."""
        with self._write() as connection:
            hold = self._renew(connection, job_id, attempt, lease)
            if hold is Hold.HELD:
                self._change_job(
                    connection, job_id, message=message, pressure=pressure,
                    fraction=min(max(fraction, 0.0), 1.0),
                )  # fmt: skip
            return hold

    def finish(
        self, job_id: str, attempt: int, document: Mapping[str, Any], arrays: bytes,
        body_files: BodyFiles | None = None,
    ) -> bool:  # fmt: skip
        """Store the answer and close the job, in one transaction. False if the claim is gone."""
        with self._write() as connection:
            found = jobs_where(connection, _held(job_id, attempt))
            if not found:
                return False
            answer = self._store_answer(connection, found[0], document, arrays, body_files)
            self._close_done(connection, found[0], answer.document)
            return True

    def fail(
        self, job_id: str, attempt: int, error: str, *, why: Failure = "failed",
        advice: str | None = None,
    ) -> bool:  # fmt: skip
        """Close a job without an answer; ``error`` and ``advice`` are for the designer."""
        with self._write() as connection:
            if not jobs_where(connection, _held(job_id, attempt)):
                return False
            self._close_failed(connection, job_id, error, why, advice)
            return True

    def confirm_cancel(
        self, job_id: str, attempt: int, document: Mapping[str, Any] | None = None,
        arrays: bytes = b"", body_files: BodyFiles | None = None,
    ) -> bool:  # fmt: skip
        """The worker has stopped for a cancel; ``document``, ``arrays`` and ``body_files``: what it
        found by then."""
        with self._write() as connection:
            found = jobs_where(connection, _held(job_id, attempt))
            if not found:
                return False
            if document is not None:
                self._store_answer(connection, found[0], document, arrays, body_files)
                values = {"outcome": document["outcome"], "advice": document.get("advice")}
                connection.execute(update(tables.job).where(_held(job_id, attempt)).values(values))
            self._end_cancelled(connection, job_id)
            return True

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

    def _store_answer(
        self, connection: Connection, job: JobRow, document: Mapping[str, Any], arrays: bytes,
        body_files: BodyFiles | None,
    ) -> ResultRow:  # fmt: skip
        names = ("digest", "design_digest", "scene_digest", "rung", "accuracy", "mesh")
        question = {name: getattr(job, name) for name in (*names, "science_version")}
        return self._store_result(connection, question, document, arrays, body_files)

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

    def _renew(self, connection: Connection, job_id: str, attempt: int, lease: timedelta) -> Hold:
        return _hold(
            connection.execute(
                update(tables.job)
                .where(_held(job_id, attempt))
                .values(lease_until=self._now(connection) + lease)
                .returning(tables.job.c.cancel_requested)
            ).scalar_one_or_none()
        )

    def _give_back(self, connection: Connection, job: JobRow, *, lost: bool) -> None:
        losses = job.lost + lost
        if job.cancel_requested:
            self._end_cancelled(connection, job.id)
        elif losses >= MAX_LOST:
            self._change_job(connection, job.id, lost=losses)
            at = "" if job.pressure is None else f", last at {job.pressure / 1e3:.3g} kPa"
            self._close_failed(
                connection, job.id,
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

    def _close_done(
        self, connection: Connection, job: JobRow, document: Mapping[str, Any], **more: Any
    ) -> None:
        now = self._now(connection)
        self._change_job(
            connection, job.id, state="done", fraction=1.0, message="Done",
            outcome=document["outcome"], advice=document.get("advice"), lease_until=None,
            started_at=func.coalesce(tables.job.c.started_at, now.timestamp()), finished_at=now,
            cancel_requested=False, **more,
        )  # fmt: skip

    def _close_failed(
        self, connection: Connection, job_id: str, error: str, why: Failure, advice: str | None
    ) -> None:
        self._change_job(
            connection, job_id, state="failed", message="Failed", error=error, outcome=why,
            advice=advice, lease_until=None, finished_at=self._now(connection),
        )  # fmt: skip


def _held(job_id: str, attempt: int) -> Any:
    j = tables.job.c
    return and_(j.id == job_id, j.attempt == attempt, j.state == "running", j.follows.is_(None))


def _hold(cancel_requested: bool | None) -> Hold:
    if cancel_requested is None:
        return Hold.GONE
    return Hold.CANCEL if cancel_requested else Hold.HELD


def _expired(now: Any) -> Any:
    j = tables.job.c
    return and_(j.state == "running", j.follows.is_(None), j.lease_until < now)


def _waiting() -> Any:
    j = tables.job.c
    return and_(j.state == "queued", j.follows.is_(None))
