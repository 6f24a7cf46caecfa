"""A foreign page in the same browser, or a foreign name for this machine, gets nothing."""

from pathlib import Path

import pytest
from fastapi.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from backend.guards import is_own_origin
from tests.backend.conftest import SCENE, SLAB, client_on, settings_in

EVIL = "http://evil.example"


@pytest.mark.parametrize(
    "host", ["evil.example", "localhost.evil.example", "127.0.0.1.evil.example", "", "evil:8000",
             "[::2]:8000", "localhost@evil.example"],
)  # fmt: skip
@pytest.mark.parametrize("path", ["/api/designs", "/", "/viewer/x/"])
def test_a_foreign_host_name_gets_nothing(client: TestClient, host: str, path: str) -> None:
    answer = client.get(path, headers={"host": host})
    assert answer.status_code == 403
    assert answer.json()["detail"]["message"]


@pytest.mark.parametrize(
    "host", ["localhost", "localhost:8000", "127.0.0.1:9", "[::1]:8000", "127.0.0.5:80"]
)
def test_loopback_names_are_answered(client: TestClient, host: str) -> None:
    assert client.get("/api/families", headers={"host": host}).status_code == 200


@pytest.mark.parametrize(
    "origin", [EVIL, "null", "http://localhost:9999", "https://localhost.evil.example", "file://"]
)
def test_a_foreign_origin_may_change_nothing(client: TestClient, origin: str) -> None:
    before = client.app.state.store.last_event_seq()  # type: ignore[attr-defined]
    body = {"name": "x", "design": SLAB, "scene": SCENE}
    answer = client.post("/api/designs", json=body, headers={"origin": origin})
    assert answer.status_code == 403
    assert client.app.state.store.last_event_seq() == before  # type: ignore[attr-defined]


def test_a_request_from_another_site_is_refused_even_without_an_origin(client: TestClient) -> None:
    answer = client.post("/api/views", json={}, headers={"sec-fetch-site": "cross-site"})
    assert answer.status_code == 403


def test_our_own_origin_and_scripts_without_one_are_served(client: TestClient) -> None:
    body = {"design": SLAB}
    own = {"origin": "http://localhost", "sec-fetch-site": "same-origin"}
    assert client.post("/api/designs/check", json=body, headers=own).status_code == 200
    assert client.post("/api/designs/check", json=body).status_code == 200


def test_an_origin_is_own_only_on_the_same_port() -> None:
    assert is_own_origin("http://localhost:8000", "localhost:8000")
    assert not is_own_origin("http://localhost:8001", "localhost:8000")
    assert not is_own_origin("http://127.0.0.1:8000", "localhost:8000")


@pytest.mark.parametrize("path", ["/api/live", "/viewer/x", "/viewer/x/"])
@pytest.mark.parametrize("headers", [{"origin": EVIL}, {"host": "evil.example"}])
def test_websockets_of_foreign_pages_are_refused(
    client: TestClient, path: str, headers: dict[str, str]
) -> None:
    address = f"ws://localhost{path}"
    with pytest.raises(WebSocketDisconnect), client.websocket_connect(address, headers=headers):
        pass


def test_a_websocket_of_our_own_page_is_served(client: TestClient) -> None:
    headers = {"origin": "http://localhost"}
    with client.websocket_connect("ws://localhost/api/live", headers=headers) as socket:
        assert "hello" in socket.receive_text()


def test_answers_carry_the_security_headers(client: TestClient) -> None:
    api = client.get("/api/families").headers
    assert api["content-security-policy"].startswith("default-src 'none'")
    assert api["x-content-type-options"] == "nosniff"
    assert api["cache-control"] == "no-store"
    page = client.get("/").headers["content-security-policy"]
    assert "script-src 'self';" in page
    assert "frame-ancestors 'none'" in page


def test_without_the_built_page_the_studio_says_how_to_build_it(client: TestClient) -> None:
    answer = client.get("/v/abc")
    assert answer.status_code == 503
    assert "make setup" in answer.text


def test_the_page_is_served_for_its_own_addresses_and_never_outside_its_folder(
    tmp_path: Path,
) -> None:
    dist = tmp_path / "dist"
    (dist / "assets").mkdir(parents=True)
    (dist / "index.html").write_text("the page")
    (dist / "assets" / "app-1a2b.js").write_text("code")
    (tmp_path / "secret.txt").write_text("hidden text")
    with client_on(settings_in(tmp_path)) as client:
        for address in ("/", "/v/0123456789abcdef", "/compare/a/b"):
            assert client.get(address).text == "the page"
        assert "immutable" in client.get("/assets/app-1a2b.js").headers["cache-control"]
        assert client.get("/assets/gone.js").status_code == 404
        assert client.get("/api/gone").status_code == 404
        for path in ("/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/%00"):
            assert "hidden text" not in client.get(path).text
