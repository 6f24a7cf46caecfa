"""What happened, numbered: one poller in the web process feeds every open page from here."""

from datetime import timedelta
from typing import Any, Literal

from sqlalchemy import Connection, delete, func, insert, select

from storage import tables
from storage.database import Database
from storage.rows import EventRow

KEEP = timedelta(days=2)


class Events(Database):
    """Reading and pruning of the event table."""

    def events_after(self, seq: int, *, limit: int = 1000) -> list[EventRow]:
        """Events with a number above ``seq``, oldest first. Rising numbers appear in order."""
        query = (
            select(tables.event).where(tables.event.c.seq > seq).order_by(tables.event.c.seq)
        ).limit(limit)
        with self._read() as connection:
            return [EventRow(**row) for row in connection.execute(query).mappings()]

    def last_event_seq(self) -> int:
        """Number of the newest event, 0 before the first; where a new page starts listening."""
        with self._read() as connection:
            return connection.execute(select(func.max(tables.event.c.seq))).scalar_one() or 0

    def prune_events(self, keep: timedelta = KEEP) -> int:
        """Forget events older than ``keep``; the rows they told of stay. Returns how many."""
        with self._write() as connection:
            before = self._now(connection) - keep
            return connection.execute(
                delete(tables.event).where(tables.event.c.at < before)
            ).rowcount

    def _record(
        self,
        connection: Connection,
        kind: Literal["job", "history"],
        subject: str,
        data: dict[str, Any],
    ) -> None:
        connection.execute(
            insert(tables.event).values(
                at=self._now(connection), kind=kind, subject=subject, data=data
            )
        )
