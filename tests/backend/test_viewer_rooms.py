"""Viewer rooms: whose they are, what reaches them, what they show, when they end."""

import asyncio
import time
from collections.abc import Iterator
from typing import Any

import httpx
import pytest
import viser
import websockets
from fastapi.testclient import TestClient
from websockets.sync.client import connect

from backend.problems import Busy
from backend.viewer.rooms import RoomKeeper
from backend.viewer.viser_door import KEY_HEADER, PINNED, SUBPROTOCOL, GuardedServer
from storage import NotFoundError
from tests.backend.conftest import SCENE, SLAB, Served

PROTOCOLS = [websockets.Subprotocol(SUBPROTOCOL)]


Joined = tuple[httpx.Client, dict[str, Any]]
"""A session's client, and its view."""


def source(**change: Any) -> dict[str, Any]:
    return {"source": {"kind": "instant", "design": {**SLAB, **change}, "scene": SCENE}}


@pytest.fixture
def room(served: Served) -> Iterator[Joined]:
    """A view with content on the served application, and the session's client."""
    with httpx.Client(base_url=served.base, timeout=30) as client:
        view = client.post("/api/views", json={}).json()
        client.put(f"/api/views/{view['view_id']}/content", json=source()).raise_for_status()
        yield client, view
        client.delete(f"/api/views/{view['view_id']}")


def session(client: httpx.Client) -> str:
    return "; ".join(f"{name}={value}" for name, value in client.cookies.items())


def test_viser_is_the_version_whose_private_names_were_read() -> None:
    assert viser.__version__ == PINNED


@pytest.mark.parametrize("headers", [{}, {KEY_HEADER: "guess"}])
def test_a_raw_connection_to_the_viser_port_gets_nothing(headers: dict[str, str]) -> None:
    guarded = GuardedServer()
    try:
        guarded.server.scene.add_box("/secret")
        with (
            connect(guarded.address, subprotocols=PROTOCOLS, additional_headers=headers) as socket,
            pytest.raises(websockets.ConnectionClosed),
        ):
            socket.recv(timeout=5)
        deadline = time.monotonic() + 5
        while guarded.connections and time.monotonic() < deadline:
            time.sleep(0.02)
        assert guarded.connections == 0
        with connect(
            guarded.address, subprotocols=PROTOCOLS, additional_headers={KEY_HEADER: guarded.key}
        ) as socket:
            assert len(socket.recv(timeout=5)) > 100
    finally:
        guarded.stop()


def test_no_page_can_open_visers_share_tunnel() -> None:
    guarded = GuardedServer()
    try:
        assert not [name for name in guarded.handled_messages if "Share" in name]
        assert "SceneNodeClickMessage" in guarded.handled_messages
    finally:
        guarded.stop()


@pytest.mark.parametrize("slash", ["", "/"])
def test_the_owners_page_is_joined_to_its_room(served: Served, room: Joined, slash: str) -> None:
    client, view = room
    address = f"ws://localhost:{served.port}/viewer/{view['view_id']}{slash}"
    with connect(
        address, subprotocols=PROTOCOLS, origin=websockets.Origin(served.base),
        additional_headers={"Cookie": session(client)}, max_size=None,
    ) as socket:  # fmt: skip
        assert socket.subprotocol == SUBPROTOCOL
        message = socket.recv(timeout=10)
        assert isinstance(message, bytes)
        assert len(message) > 100_000  # 21 bodies and the stage, compressed


@pytest.mark.parametrize(
    ("origin", "with_session", "protocols"),
    [
        ("http://evil.example", True, PROTOCOLS),
        ("null", True, PROTOCOLS),
        (None, False, PROTOCOLS),
        ("own", False, PROTOCOLS),
        ("own", True, []),
        ("own", True, [websockets.Subprotocol("viser-v0.0.1")]),
    ],
)
def test_anybody_else_is_refused_before_the_room(
    served: Served, room: Joined, origin: str | None, with_session: bool, protocols: list[Any]
) -> None:
    client, view = room
    own = served.base if origin == "own" else origin
    with pytest.raises(websockets.InvalidStatus) as refused:
        connect(
            f"ws://localhost:{served.port}/viewer/{view['view_id']}/",
            subprotocols=protocols or None,
            origin=websockets.Origin(own) if own else None,
            additional_headers={"Cookie": session(client)} if with_session else {},
        )
    assert refused.value.response.status_code == 403


def test_another_session_finds_no_view(served: Served, room: Joined) -> None:
    _, view = room
    with httpx.Client(base_url=served.base) as other:
        other.post("/api/views", json={})
        assert other.get(view["url"]).status_code == 404
        assert (
            other.put(f"/api/views/{view['view_id']}/frame", json={"index": 1}).status_code == 404
        )
        assert other.delete(f"/api/views/{view['view_id']}").status_code == 404


def test_the_viewer_page_holds_its_policy_and_drops_foreign_sources(room: Joined) -> None:
    client, view = room
    page = client.get(view["url"])
    policy = page.headers["content-security-policy"]
    assert "default-src 'none'" in policy
    assert "connect-src 'self' data: blob:" in policy
    assert "frame-ancestors 'self'" in policy
    assert "[data-floating-window]" in page.text
    for foreign in ("websocket=ws://evil.example", "playbackPath=http://evil.example/x.viser"):
        answer = client.get(f"{view['url']}?{foreign}")
        assert answer.status_code == 307
        assert answer.headers["location"] == view["url"]


def test_new_content_leaves_nothing_of_the_old_behind(served: Served, room: Joined) -> None:
    client, view = room
    found = served.app.state.rooms._rooms[view["view_id"]]
    kept: list[int] = []
    for k in range(8):
        body = source(roof_thickness_mm=5 + 0.2 * k)
        client.put(f"/api/views/{view['view_id']}/content", json=body).raise_for_status()
        time.sleep(0.3)
        kept.append(found.guarded.kept_messages)
    takes = {name.split("/")[1] for name in found.guarded.server.scene._handle_from_node_name
             if name.startswith("/take")}  # fmt: skip
    assert len(takes) == 1
    assert kept[-1] == kept[1]


def test_of_two_requests_at_once_the_later_one_wins(served: Served, room: Joined) -> None:
    _, view = room
    found = served.app.state.rooms._rooms[view["view_id"]]
    early, late = found.ticket(), found.ticket()
    shown: list[int] = []
    found._send = lambda bodies, frame, visible: shown.append(frame)
    found._stage.fit = lambda box, clamp: None
    bodies = type("Bodies", (), {"box": None, "clamp": None})()
    found.show(bodies, 1, late)
    found.show(bodies, 2, early)
    assert shown == [1]


def test_scrubbing_answers_within_20_ms(room: Joined) -> None:
    client, view = room
    times: list[float] = []
    for index in list(range(21)) * 2:
        start = time.perf_counter()
        answer = client.put(f"/api/views/{view['view_id']}/frame", json={"index": index})
        times.append(time.perf_counter() - start)
        assert answer.status_code == 204
    assert sorted(times)[len(times) // 2] < 0.02


def test_content_says_pressures_legend_and_colours(room: Joined) -> None:
    client, view = room
    answer = client.put(f"/api/views/{view['view_id']}/content", json={**source(), "frame": 3})
    content = answer.json()
    assert content["pressures_kPa"] == pytest.approx([2.0 * k for k in range(21)])
    assert content["frame"] == 3
    assert content["colours"] == ["displacement", "none"]
    legend = content["legend"]
    assert (legend["label"], legend["unit"], legend["lower"]) == ("Displacement", "mm", 0.0)
    assert [legend["stops"][k][0] for k in (0, -1)] == [0.0, 1.0]
    assert content["vertices"] <= 10_000
    plain = client.put(
        f"/api/views/{view['view_id']}/content", json={**source(), "colour": "none"}
    ).json()
    assert plain["legend"] is None


def test_rooms_end_when_nobody_looks_and_are_capped() -> None:
    keeper = RoomKeeper(most=2, idle_s=0.05)
    try:
        first = keeper.open("ada", dark=False)
        second = keeper.open("ada", dark=True)
        third = keeper.open("ada", dark=False)  # the first, longest unused, made way
        assert len(keeper) == 2
        with pytest.raises(NotFoundError):
            keeper.find(first.view_id, "ada")
        with pytest.raises(NotFoundError):
            keeper.find(second.view_id, "bob")
        assert keeper.find(third.view_id, "ada") is third
        time.sleep(0.1)
        assert keeper.sweep() == 2
        assert len(keeper) == 0
    finally:
        keeper.close()


def test_a_room_with_a_page_is_neither_idle_nor_pushed_out() -> None:
    keeper = RoomKeeper(most=1, idle_s=0.05)
    room = keeper.open("ada", dark=False)
    try:
        with connect(
            room.guarded.address, subprotocols=PROTOCOLS,
            additional_headers={KEY_HEADER: room.guarded.key},
        ) as socket:  # fmt: skip
            socket.recv(timeout=5)
            time.sleep(0.1)
            assert keeper.sweep() == 0
            with pytest.raises(Busy):
                keeper.open("ada", dark=False)
    finally:
        keeper.close()


def test_a_job_that_is_not_done_cannot_be_shown(client: TestClient) -> None:
    view = client.post("/api/views", json={}).json()["view_id"]
    body = {"source": {"kind": "job", "job_id": "none"}}
    assert client.put(f"/api/views/{view}/content", json=body).status_code == 404
    assert client.delete(f"/api/views/{view}").status_code == 204


def test_closing_the_studio_ends_every_room() -> None:
    keeper = RoomKeeper()
    address = keeper.open("ada", dark=False).guarded.address
    keeper.close()
    with pytest.raises(OSError):
        asyncio.run(_reach(address))


async def _reach(address: str) -> None:
    async with websockets.connect(address, subprotocols=PROTOCOLS, open_timeout=2):
        pass
