"""What happens is pushed: to pages by websocket, to scripts as server-sent events."""

import json
import time
from typing import Any

import httpx
from fastapi.testclient import TestClient

from backend.live.schemas import LiveEvent
from storage import Store
from tests.backend.conftest import SCENE, SLAB, Served, saved
from tests.backend.test_jobs import solve


def until(socket: Any, wanted: Any, most: int = 50) -> LiveEvent:
    for _ in range(most):
        event = LiveEvent.model_validate_json(socket.receive_text())
        if wanted(event):
            return event
    raise AssertionError("the event did not come")


def test_a_tab_sees_history_and_every_state_of_a_job(client: TestClient, store: Store) -> None:
    with client.websocket_connect("ws://localhost/api/live") as socket:
        hello = LiveEvent.model_validate_json(socket.receive_text())
        assert hello.kind == "hello"
        version = saved(client, "Live", {**SLAB, "length_mm": 94})
        history = until(socket, lambda e: e.kind == "history")
        assert history.design_id == version["design_id"]
        job = client.post("/api/jobs", json={"version_id": version["id"]}).json()
        until(socket, lambda e: e.job and e.job.id == job["id"] and e.job.state == "queued")
        solve(store, job["id"])
        done = until(socket, lambda e: e.job and e.job.id == job["id"] and e.job.state == "done")
        assert done.job is not None
        assert done.job.outcome == "converged"
        assert done.seq > hello.seq


def test_a_tab_that_comes_back_misses_nothing(client: TestClient) -> None:
    with client.websocket_connect("ws://localhost/api/live") as socket:
        seen = LiveEvent.model_validate_json(socket.receive_text()).seq
    version = saved(client, "While away", {**SLAB, "length_mm": 95})
    time.sleep(0.3)
    with client.websocket_connect(f"ws://localhost/api/live?after={seen}") as socket:
        assert LiveEvent.model_validate_json(socket.receive_text()).seq == seen
        missed = until(socket, lambda e: e.kind == "history")
        assert missed.design_id == version["design_id"]


def test_a_change_reaches_the_tab_soon(client: TestClient) -> None:
    with client.websocket_connect("ws://localhost/api/live") as socket:
        socket.receive_text()
        start = time.perf_counter()
        saved(client, "Quick", {**SLAB, "length_mm": 96})
        until(socket, lambda e: e.kind == "history")
        # the poller looks each 0.1 s; the rest is for a busy machine
        assert time.perf_counter() - start < 5.0


def test_scripts_read_server_sent_events(served: Served) -> None:
    with httpx.stream("GET", f"{served.base}/api/events", timeout=20) as stream:
        assert stream.headers["content-type"].startswith("text/event-stream")
        lines = stream.iter_lines()
        assert next(lines).startswith("id: ")
        assert next(lines) == "event: hello"
        assert next(lines).startswith("data: ")
        assert next(lines) == ""
        body = {"name": "Script", "design": SLAB, "scene": SCENE}
        httpx.post(f"{served.base}/api/designs", json=body).raise_for_status()
        next(lines)
        assert next(lines) == "event: history"
        event = json.loads(next(lines).removeprefix("data: "))
        assert event["design_id"]


def test_a_nonsense_position_is_refused(client: TestClient) -> None:
    assert client.get("/api/events?after=-1").status_code == 422
    assert client.get("/api/events?after=x").status_code == 422
