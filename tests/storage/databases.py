"""Databases to test on: a SQLite file, and a schema of its own on a real PostgreSQL server."""

import os
import secrets
from collections.abc import Generator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import psycopg
import pytest

POSTGRES = os.environ.get("PNEUSTUDIO_TEST_POSTGRES", "postgresql://postgres@127.0.0.1:5432/test")


@contextmanager
def database(kind: str, folder: Path) -> Generator[str]:
    """Address of an empty database; skips, saying why, where there is no PostgreSQL server."""
    if kind == "sqlite":
        yield f"sqlite:///{folder / 'studio.sqlite'}"
        return
    away = _postgres_away()
    if away:
        pytest.skip(f"NOT TESTED ON POSTGRESQL: {POSTGRES} does not answer ({away})")
    schema = f"pneustudio_test_{secrets.token_hex(6)}"
    with psycopg.connect(POSTGRES, autocommit=True) as connection:
        connection.execute(f"CREATE SCHEMA {schema}")  # pyright: ignore
        try:
            yield f"{POSTGRES}?options=-csearch_path%3D{schema}"
        finally:
            connection.execute(f"DROP SCHEMA {schema} CASCADE")  # pyright: ignore


@cache
def _postgres_away() -> str:
    try:
        psycopg.connect(POSTGRES, connect_timeout=2).close()
    except psycopg.OperationalError as error:
        return str(error).splitlines()[0]
    return ""
