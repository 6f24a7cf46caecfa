"""A migrated store on each kind of database, and a saved design to ask questions about."""

from collections.abc import Generator
from pathlib import Path

import pytest

from actuators.design import preset
from storage import Store, VersionRow, open_store
from tests.storage.databases import database

SLAB = preset("slab-rectangle-low").design.to_document()
SCENE = {"pressure_kPa": {"to": 30}}


@pytest.fixture(params=["sqlite", "postgresql"])
def store(request: pytest.FixtureRequest, tmp_path: Path) -> Generator[Store]:
    with database(request.param, tmp_path) as url:
        opened = open_store(url)
        opened.migrate()
        yield opened
        opened.close()


@pytest.fixture
def version(store: Store) -> VersionRow:
    return store.create_design("Finger", "ada", SLAB, SCENE, "as moulded")[1]
