"""The real application on a real database, in process or on a port."""

import threading
import time
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import uvicorn
from fastapi.testclient import TestClient

from actuators.design import preset
from backend.app import create_app
from backend.settings import Settings, from_environment
from storage import Store

SLAB = preset("slab-rectangle-low").design.to_document()
OBLIQUE = preset("oblique-45").design.to_document()
SCENE: dict[str, Any] = {"pressure_kPa": {"to": 40.0, "steps": 20}}


def settings_in(folder: Path, **more: str) -> Settings:
    return from_environment(
        {"PNEUSTUDIO_DATA": str(folder), "PNEUSTUDIO_AUTHOR": "ada",
         "PNEUSTUDIO_PAGE": str(folder / "dist"), **more}
    )  # fmt: skip


@contextmanager
def client_on(settings: Settings) -> Generator[TestClient]:
    with TestClient(
        create_app(settings), base_url="http://localhost", raise_server_exceptions=False
    ) as client:
        yield client


@pytest.fixture(scope="module")
def client(tmp_path_factory: pytest.TempPathFactory) -> Iterator[TestClient]:
    with client_on(settings_in(tmp_path_factory.mktemp("studio"))) as opened:
        yield opened


@pytest.fixture
def store(client: TestClient) -> Store:
    return client.app.state.store  # type: ignore[attr-defined]


@dataclass(frozen=True)
class Served:
    """The application on a port of loopback."""

    base: str
    port: int
    app: Any


@contextmanager
def served_on(settings: Settings) -> Generator[Served]:
    app = create_app(settings)
    config = uvicorn.Config(
        app, host="127.0.0.1", port=0, log_level="warning", ws_per_message_deflate=False,
        timeout_graceful_shutdown=1,
    )  # fmt: skip
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run, daemon=True)
    thread.start()
    deadline = time.monotonic() + 60
    while not server.started:
        if time.monotonic() > deadline or not thread.is_alive():
            raise RuntimeError("the server did not start")
        time.sleep(0.02)
    port = server.servers[0].sockets[0].getsockname()[1]
    try:
        yield Served(f"http://localhost:{port}", port, app)
    finally:
        server.should_exit = True
        thread.join(30)


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    with served_on(settings_in(tmp_path_factory.mktemp("studio"))) as running:
        yield running


def saved(
    client: TestClient, name: str = "Finger", design: dict[str, Any] = SLAB,
    *, scene: dict[str, Any] = SCENE,
) -> Any:  # fmt: skip
    """A design kept under a name; the version's document."""
    answer = client.post("/api/designs", json={"name": name, "design": design, "scene": scene})
    assert answer.status_code == 201, answer.text
    return answer.json()["version"]
