"""Asking and un-asking: a question already answered or under way is not computed again."""

from collections.abc import Mapping
from typing import Any

from sqlalchemy import Connection, insert, select, update

from actuators.mechanics.scene import Scene
from storage import tables
from storage.database import new_id
from storage.errors import NotFoundError
from storage.jobs import ACTIVE, Jobs, jobs_where
from storage.parts import Parts, run_again
from storage.question import (
    DEFAULT_BUDGET_S,
    check_mesh,
    check_question,
    question_digest,
    science_version,
)
from storage.results import closed_result
from storage.rows import JobRow

_NEW: Mapping[str, Any] = {
    "state": "queued", "fraction": 0.0, "message": "Waiting for a worker", "attempt": 0, "lost": 0,
    "from_store": False, "cancel_requested": False,
}  # fmt: skip


class Submission(Jobs, Parts):
    """Submitting and cancelling jobs."""

    def submit(
        self,
        version_id: str,
        scene: Mapping[str, Any],
        rung: str,
        accuracy: float,
        author: str,
        *,
        budget_s: float = DEFAULT_BUDGET_S,
        mesh: str | None = None,
    ) -> JobRow:
        """Put a question about a version to the queue. Raises InputError for a bad one.

        Answered before: a job that is `done` at once, ``from_store``. Under way for this version:
        that job. Under way for another version: a new job that ``follows`` the other one.
        """
        check_question(rung, accuracy)
        check_mesh(mesh, rung)
        surroundings = Scene.from_document(scene)
        with self._write() as connection:
            v = tables.version.c
            design_digest = connection.execute(
                select(v.design_digest).where(v.id == version_id)
            ).scalar_one_or_none()
            if design_digest is None:
                raise NotFoundError("version", version_id)
            parts = (design_digest, surroundings.digest, rung, accuracy, science_version(), mesh)
            question = {
                "version_id": version_id, "author": author, "scene": surroundings.to_document(),
                "design_digest": design_digest, "scene_digest": surroundings.digest, "rung": rung,
                "accuracy": float(accuracy), "science_version": science_version(),
                "digest": question_digest(*parts), "budget_s": budget_s, "mesh": mesh,
            }  # fmt: skip
            answered = self._from_store(connection, question)
            return answered or self._joined(connection, question) or self._insert_job(
                connection, question, _NEW
            )  # fmt: skip

    def cancel(self, job_id: str) -> JobRow:
        """Stop a job: at once while it waits; a running one when its worker has noticed. A job
        that has ended stays as it is."""
        with self._write() as connection:
            found = jobs_where(connection, tables.job.c.id == job_id)
            if not found:
                raise NotFoundError("job", job_id)
            job = found[0]
            if job.state == "running" and job.follows is None:
                connection.execute(
                    update(tables.job).where(tables.job.c.id == job_id).values(
                        cancel_requested=True, message="Cancelling"
                    )
                )  # fmt: skip
                self._tell(connection, jobs_where(connection, tables.job.c.id == job_id)[0])
            elif job.active:
                self._end_cancelled(connection, job_id)
            return jobs_where(connection, tables.job.c.id == job_id)[0]

    def _end_cancelled(self, connection: Connection, job_id: str) -> None:
        """Close one job as cancelled, with the part of the path it had found where that is known;
        jobs that waited for its answer go back to the queue."""
        j = tables.job
        job = jobs_where(connection, j.c.id == job_id)[0]
        part = self._part_as_result(connection, job, "cancelled", run_again)
        if part is not None:
            ending = {"outcome": "cancelled", "advice": part["advice"]}
            connection.execute(update(j).where(j.c.id == job_id).values(**ending))
        heirs = jobs_where(connection, j.c.follows == job_id)
        for heir in heirs:
            first = heir.id == heirs[0].id
            again = {**_NEW, "attempt": heir.attempt, "lost": heir.lost}
            connection.execute(
                update(j).where(j.c.id == heir.id).values(
                    follows=None if first else heirs[0].id, started_at=None, pressure=None, **again
                )
            )  # fmt: skip
            self._tell(connection, jobs_where(connection, j.c.id == heir.id)[0])
        connection.execute(
            update(j).where(j.c.id == job_id).values(
                state="cancelled", message="Cancelled", finished_at=self._now(connection),
                lease_until=None, worker=None,
            )
        )  # fmt: skip
        self._tell(connection, jobs_where(connection, j.c.id == job_id)[0])

    def _from_store(self, connection: Connection, question: Mapping[str, Any]) -> JobRow | None:
        answer = closed_result(connection, question["digest"])
        if answer is None:
            return None
        before = jobs_where(
            connection,
            tables.job.c.digest == question["digest"],
            tables.job.c.version_id == question["version_id"],
            tables.job.c.from_store,
        )
        if before:
            return before[-1]
        now = self._now(connection)
        state = {
            **_NEW, "state": "done", "fraction": 1.0, "message": "Answered from the store",
            "outcome": answer.outcome, "advice": answer.document.get("advice"),
            "from_store": True, "created_at": now, "started_at": now, "finished_at": now,
        }  # fmt: skip
        return self._insert_job(connection, question, state)

    def _joined(self, connection: Connection, question: Mapping[str, Any]) -> JobRow | None:
        j = tables.job.c
        active = jobs_where(
            connection, j.digest == question["digest"], j.state.in_(ACTIVE), ~j.cancel_requested
        )
        for job in active:
            if job.version_id == question["version_id"]:
                return job
        leaders = [job for job in active if job.follows is None]
        if not leaders:
            return None
        leader = leaders[0]
        state = {
            **_NEW, "state": leader.state, "started_at": leader.started_at,
            "fraction": leader.fraction, "message": leader.message, "pressure": leader.pressure,
            "attempt": leader.attempt, "follows": leader.id,
        }  # fmt: skip
        return self._insert_job(connection, question, state)

    def _insert_job(
        self, connection: Connection, question: Mapping[str, Any], state: Mapping[str, Any]
    ) -> JobRow:
        values = {"id": new_id(), "created_at": self._now(connection), **question, **state}
        connection.execute(insert(tables.job).values(**values))
        row = jobs_where(connection, tables.job.c.id == values["id"])[0]
        self._tell(connection, row)
        return row
