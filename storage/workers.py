"""Workers that report themselves, so that the page can say whether anybody computes."""

from datetime import timedelta

from sqlalchemy import delete, insert, select, update

from storage import tables
from storage.database import Database
from storage.rows import WorkerRow

ALIVE = timedelta(seconds=10)
_FORGET = timedelta(days=1)


class Workers(Database):
    """The table of workers."""

    def worker_seen(self, name: str, science_version: str) -> None:
        """A worker reports itself; due every few seconds."""
        w = tables.worker
        with self._write() as connection:
            now = self._now(connection)
            known = connection.execute(
                update(w).where(w.c.name == name).values(
                    last_seen=now, science_version=science_version
                )
            )  # fmt: skip
            if known.rowcount == 0:
                connection.execute(delete(w).where(w.c.last_seen < now - _FORGET))
                connection.execute(
                    insert(w).values(
                        name=name, science_version=science_version, started_at=now, last_seen=now
                    )
                )

    def worker_left(self, name: str) -> None:
        """A worker has ended."""
        with self._write() as connection:
            connection.execute(delete(tables.worker).where(tables.worker.c.name == name))

    def list_workers(self) -> list[WorkerRow]:
        """Workers that have reported lately, last seen first."""
        query = select(tables.worker).order_by(tables.worker.c.last_seen.desc())
        with self._read() as connection:
            return [WorkerRow(**row) for row in connection.execute(query).mappings()]

    def worker_alive(self) -> bool:
        """Whether any worker has reported within the last seconds."""
        w = tables.worker.c
        with self._read() as connection:
            since = self._now(connection) - ALIVE
            return connection.execute(select(w.name).where(w.last_seen > since)).first() is not None
