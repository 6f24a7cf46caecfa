"""Connections and transactions: SQLite in WAL mode or PostgreSQL behind the same two doors."""

import secrets
import sqlite3
import time
from collections.abc import Generator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from sqlalchemy import Connection, Engine, create_engine, event, func, select, text
from sqlalchemy.engine import URL, make_url

# One writer at a time, on PostgreSQL as on SQLite: event numbers then become visible in their
# order, so that a reader of `seq > last` misses none. Any constant does; this spells "pneu".
_WRITER_LOCK = 0x706E6575
_BUSY_S = 15


class Database:
    """Engine and the two kinds of transaction; the subjects of :class:`Store` build on it."""

    def __init__(self, url: str) -> None:
        self.url = _normal(url)
        self._engine = _engine(self.url)
        self._writing = self._engine.execution_options(pneustudio_write=True)

    @property
    def is_sqlite(self) -> bool:
        return self.url.get_backend_name() == "sqlite"

    @contextmanager
    def _read(self) -> Generator[Connection]:
        with self._engine.connect() as connection:
            yield connection

    @contextmanager
    def _write(self) -> Generator[Connection]:
        """One transaction, alone: committed at the end of the block, rolled back on error."""
        with self._writing.begin() as connection:
            if not self.is_sqlite:
                connection.execute(select(func.pg_advisory_xact_lock(_WRITER_LOCK)))
            yield connection

    def _now(self, connection: Connection) -> datetime:
        """The database's clock: leases of several machines are measured by one clock."""
        if self.is_sqlite:
            return datetime.fromtimestamp(time.time(), UTC)
        return connection.execute(select(func.clock_timestamp())).scalar_one().astimezone(UTC)

    def close(self) -> None:
        """Close every connection; the store opens new ones when used again."""
        self._engine.dispose()


def new_id() -> str:
    """Random key of a row: short enough for an address, too many to guess or to collide."""
    return secrets.token_hex(8)


def _normal(url: str) -> URL:
    parsed = make_url(url)
    if parsed.get_backend_name() == "postgresql":
        return parsed.set(drivername="postgresql+psycopg")
    return parsed


def _engine(url: URL) -> Engine:
    if url.get_backend_name() != "sqlite":
        options = f"-c lock_timeout={_BUSY_S}s -c idle_in_transaction_session_timeout={_BUSY_S}s"
        given = url.query.get("options", "")
        engine = create_engine(
            url.update_query_dict({"options": f"{given} {options}".strip()}),
            pool_pre_ping=True, pool_size=10, max_overflow=20,
        )  # fmt: skip
        return engine
    if not url.database or url.database == ":memory:":
        raise ValueError(f"{url} has no file: several processes share the database.")
    Path(url.database).parent.mkdir(parents=True, exist_ok=True)
    engine = create_engine(url, connect_args={"timeout": _BUSY_S}, pool_size=10, max_overflow=20)
    event.listen(engine, "connect", _prepare_sqlite)
    event.listen(engine, "begin", _begin_sqlite)
    return engine


def _prepare_sqlite(connection: Any, _record: Any) -> None:
    # the driver must not open transactions by itself: _begin_sqlite says when and how
    connection.isolation_level = None
    _into_wal(connection)
    for pragma in ("synchronous=NORMAL", "foreign_keys=ON"):
        connection.execute(f"PRAGMA {pragma}")


def _into_wal(connection: Any) -> None:
    """A new file's change of its journal does not wait for others that change it, as other locks
    do: it fails at once."""
    end = time.monotonic() + _BUSY_S
    while True:
        try:
            connection.execute("PRAGMA journal_mode=WAL")
        except sqlite3.OperationalError as error:
            if error.sqlite_errorcode & 0xFF != sqlite3.SQLITE_BUSY or time.monotonic() > end:
                raise
            time.sleep(0.01)
        else:
            return


def _begin_sqlite(connection: Connection) -> None:
    # plain BEGIN takes the write lock late and then fails at once when another writer came first
    write = connection.get_execution_options().get("pneustudio_write", False)
    connection.execute(text("BEGIN IMMEDIATE" if write else "BEGIN"))
