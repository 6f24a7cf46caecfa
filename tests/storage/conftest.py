"""A migrated store on each kind of database, and a saved design to ask questions about."""

from collections.abc import Generator

import pytest
from sqlalchemy import create_engine, text

from actuators.design import preset
from storage import Store, VersionRow, open_store
from storage.tables import metadata
from tests.storage.databases import database

SLAB = preset("slab-rectangle-low").design.to_document()
SCENE = {"pressure_kPa": {"to": 30}}


@pytest.fixture(scope="session", params=["sqlite", "postgresql"])
def address(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Generator[str]:
    """Of a database that was migrated once for all tests, as migrations take their time."""
    with database(request.param, tmp_path_factory.mktemp("migrated")) as url:
        opened = open_store(url)
        opened.migrate()
        opened.close()
        yield url


@pytest.fixture
def store(address: str) -> Generator[Store]:
    """A store without a row in it."""
    engine = create_engine(address.replace("postgresql:", "postgresql+psycopg:"))
    with engine.begin() as connection:
        if connection.dialect.name == "sqlite":
            for table in reversed(metadata.sorted_tables):
                connection.execute(table.delete())
            connection.execute(text("DELETE FROM sqlite_sequence"))
        else:
            names = ", ".join(table.name for table in metadata.sorted_tables)
            connection.execute(text(f"TRUNCATE {names} RESTART IDENTITY CASCADE"))
    engine.dispose()
    opened = open_store(address)
    yield opened
    opened.close()


@pytest.fixture
def version(store: Store) -> VersionRow:
    return store.create_design("Finger", "ada", SLAB, SCENE, "as moulded")[1]
