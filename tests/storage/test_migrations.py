"""The migrations lead exactly to the tables the queries are written for."""

import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from sqlalchemy import create_engine, text

from storage import NewerDatabaseError, Store, open_store
from storage.tables import metadata
from tests.storage.databases import database


@pytest.mark.parametrize("kind", ["sqlite", "postgresql"])
def test_an_empty_database_migrates_to_the_tables_of_the_code(kind: str, tmp_path: Path) -> None:
    with database(kind, tmp_path) as url:
        store = open_store(url)
        store.migrate()
        store.migrate()
        engine = create_engine(store.url)
        with engine.connect() as connection:
            context = MigrationContext.configure(connection, opts={"compare_type": True})
            assert compare_metadata(context, metadata) == []
        engine.dispose()
        store.close()


def at_once(url: str, count: int, use: Callable[[Store], object]) -> list[Exception]:
    """What befalls stores that are used at the same moment."""
    errors: list[Exception] = []
    together = threading.Barrier(count)

    def run() -> None:
        store = open_store(url)
        together.wait()
        try:
            use(store)
        except Exception as error:  # noqa: BLE001 - handed to the test's own thread
            errors.append(error)
        store.close()

    threads = [threading.Thread(target=run) for _ in range(count)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return errors


@pytest.mark.parametrize("kind", ["sqlite", "postgresql"])
def test_several_processes_may_migrate_at_once(kind: str, tmp_path: Path) -> None:
    def migrate(store: Store) -> None:
        store.migrate()
        store.list_designs()

    with database(kind, tmp_path) as url:
        assert at_once(url, 4, migrate) == []


def test_many_processes_may_open_a_new_file_at_once(tmp_path: Path) -> None:
    """Without waiting, one in fifteen such files had somebody who found it locked."""
    for number in range(60):
        errors = at_once(f"sqlite:///{tmp_path / f'{number}.sqlite'}", 8, Store.list_designs)
        # nobody has migrated it
        assert [each for each in errors if "no such table" not in str(each)] == []


@pytest.mark.parametrize("kind", ["sqlite", "postgresql"])
def test_a_database_of_a_newer_version_is_left_alone(kind: str, tmp_path: Path) -> None:
    with database(kind, tmp_path) as url:
        store = open_store(url)
        store.migrate()
        engine = create_engine(store.url)
        with engine.begin() as connection:
            connection.execute(text("UPDATE alembic_version SET version_num = '9999'"))
        engine.dispose()
        with pytest.raises(NewerDatabaseError, match="newer Pneustudio"):
            store.migrate()
        store.close()


def test_a_database_that_processes_cannot_share_is_refused() -> None:
    with pytest.raises(ValueError, match="no file"):
        open_store("sqlite://")
