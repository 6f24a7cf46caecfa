"""The worker's side of a job: claim it, keep it, report, finish.

A claim is a lease. Every later write names the attempt it belongs to, so that a worker that was
given up (asleep, cut off) can write nothing any more. The job's row is the truth, a message in the
broker only wakes a worker.
"""

from collections.abc import Mapping
from datetime import timedelta
from typing import Any

from sqlalchemy import Connection, and_, func, select, update

from storage import tables
from storage.body_files import BodyFiles
from storage.jobs import jobs_where
from storage.parts import Part, kept_in_words
from storage.question import Failure, question_digest
from storage.results import closed_result
from storage.rows import ClaimedJob, Hold, JobRow
from storage.submission import Submission

LEASE = timedelta(seconds=9)


class Claims(Submission):
    """Claiming, keeping and ending jobs; all of it safe to repeat."""

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
            if digest != job.digest:
                self._drop_part(connection, job_id)
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

    def keep_part(self, job_id: str, attempt: int, part: Part) -> bool:
        """Keep what the solver has found so far, in place of what was kept before. False if the
        claim is gone."""
        with self._write() as connection:
            if not jobs_where(connection, _held(job_id, attempt)):
                return False
            self._keep_part(connection, job_id, attempt, part)
            return True

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
        advice: str | None = None, part: Part | None = None,
    ) -> bool:  # fmt: skip
        """Close a job without an answer; ``error`` and ``advice`` are for the designer. The
        ``part`` of the path found by then, or the one kept before, is its result, unless the
        question was refused."""
        with self._write() as connection:
            found = jobs_where(connection, _held(job_id, attempt))
            if not found:
                return False
            if part is not None:
                self._keep_part(connection, job_id, attempt, part)
            self._close_failed(connection, found[0], error, why, advice)
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
                self._drop_part(connection, job_id)
                self._store_answer(connection, found[0], document, arrays, body_files)
                values = {"outcome": document["outcome"], "advice": document.get("advice")}
                connection.execute(update(tables.job).where(_held(job_id, attempt)).values(values))
            self._end_cancelled(connection, job_id)
            return True

    def _renew(self, connection: Connection, job_id: str, attempt: int, lease: timedelta) -> Hold:
        return _hold(
            connection.execute(
                update(tables.job)
                .where(_held(job_id, attempt))
                .values(lease_until=self._now(connection) + lease)
                .returning(tables.job.c.cancel_requested)
            ).scalar_one_or_none()
        )

    def _close_done(
        self, connection: Connection, job: JobRow, document: Mapping[str, Any], **more: Any
    ) -> None:
        now = self._now(connection)
        self._drop_part(connection, job.id)
        self._change_job(
            connection, job.id, state="done", fraction=1.0, message="Done",
            outcome=document["outcome"], advice=document.get("advice"), lease_until=None,
            started_at=func.coalesce(tables.job.c.started_at, now.timestamp()), finished_at=now,
            cancel_requested=False, **more,
        )  # fmt: skip

    def _close_failed(
        self, connection: Connection, job: JobRow, error: str, why: Failure, advice: str | None
    ) -> None:
        def told(part: Mapping[str, Any]) -> str:
            return " ".join(filter(None, (error, kept_in_words(part), advice)))

        part = None
        if why == "refused":
            self._drop_part(connection, job.id)
        else:
            part = self._part_as_result(connection, job, why, told)
        if part is not None:
            advice = " ".join(filter(None, (kept_in_words(part), advice)))
        self._change_job(
            connection, job.id, state="failed", message="Failed", error=error, outcome=why,
            advice=advice, kept_part=part is not None, lease_until=None,
            finished_at=self._now(connection),
        )  # fmt: skip


def _held(job_id: str, attempt: int) -> Any:
    j = tables.job.c
    return and_(j.id == job_id, j.attempt == attempt, j.state == "running", j.follows.is_(None))


def _hold(cancel_requested: bool | None) -> Hold:
    if cancel_requested is None:
        return Hold.GONE
    return Hold.CANCEL if cancel_requested else Hold.HELD
