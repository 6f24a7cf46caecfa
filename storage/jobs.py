"""Jobs as the page sees them: the rows, their list, and the event that every change leaves."""

from collections.abc import Collection
from typing import Any

from sqlalchemy import ColumnElement, Connection, Select, or_, select, update

from storage import tables
from storage.errors import NotFoundError
from storage.events import Events
from storage.rows import JobRow, JobState

ACTIVE: tuple[JobState, ...] = ("queued", "running")
# columns that only the queue itself needs
_INNER = {"lease_until", "published_at"}


class Jobs(Events):
    """Looking jobs up."""

    def get_job(self, job_id: str) -> JobRow:
        with self._read() as connection:
            return _job(connection, job_id)

    def get_jobs(self, job_ids: Collection[str]) -> dict[str, JobRow]:
        """Rows of the ids that exist, in one query."""
        query = _jobs().where(tables.job.c.id.in_(job_ids))
        with self._read() as connection:
            rows = [JobRow(**row) for row in connection.execute(query).mappings()]
        return {row.id: row for row in rows}

    def list_jobs(
        self,
        *,
        version_id: str | None = None,
        design_id: str | None = None,
        states: Collection[JobState] | None = None,
        content: tuple[str, str] | None = None,
        limit: int = 50,
    ) -> list[JobRow]:
        """Jobs, newest first. ``content``: digests of the design and of the scene asked about,
        whichever version holds them."""
        j = tables.job.c
        query = _jobs()
        if version_id is not None:
            query = query.where(j.version_id == version_id)
        if design_id is not None:
            query = query.where(tables.version.c.design_id == design_id)
        if states is not None:
            query = query.where(j.state.in_(states))
        if content is not None:
            design_digest, scene_digest = content
            query = query.where(j.design_digest == design_digest, j.scene_digest == scene_digest)
        query = query.order_by(j.created_at.desc(), j.id).limit(limit)
        with self._read() as connection:
            return [JobRow(**row) for row in connection.execute(query).mappings()]

    def _change_job(self, connection: Connection, job_id: str, **values: Any) -> JobRow:
        """Change a job and every job that follows it, and tell of each."""
        changed = connection.execute(
            update(tables.job).where(with_followers(job_id)).values(**values)
            .returning(tables.job.c.id)
        ).scalars().all()  # fmt: skip
        for each in changed:
            self._tell(connection, _job(connection, each))
        return _job(connection, job_id)

    def _tell(self, connection: Connection, job: JobRow) -> None:
        data = {
            "state": job.state, "fraction": job.fraction, "message": job.message,
            "pressure": job.pressure, "version_id": job.version_id, "attempt": job.attempt,
        }  # fmt: skip
        self._record(connection, "job", job.id, data)


def with_followers(job_id: str) -> ColumnElement[bool]:
    """Condition: the job itself, or one that waits for its answer."""
    return or_(tables.job.c.id == job_id, tables.job.c.follows == job_id)


def _jobs() -> Select[Any]:
    columns = [c for c in tables.job.c if c.name not in _INNER]
    return (
        select(
            *columns,
            tables.version.c.design_id,
            tables.version.c.number.label("version_number"),
            tables.design.c.name.label("design_name"),
        )
        .join(tables.version, tables.version.c.id == tables.job.c.version_id)
        .join(tables.design, tables.design.c.id == tables.version.c.design_id)
    )


def _job(connection: Connection, job_id: str) -> JobRow:
    row = connection.execute(_jobs().where(tables.job.c.id == job_id)).mappings().one_or_none()
    if row is None:
        raise NotFoundError("job", job_id)
    return JobRow(**row)


def jobs_where(connection: Connection, *conditions: ColumnElement[bool]) -> list[JobRow]:
    """Jobs that fulfil all conditions, oldest first."""
    query = _jobs().where(*conditions).order_by(tables.job.c.created_at, tables.job.c.id)
    return [JobRow(**row) for row in connection.execute(query).mappings()]
