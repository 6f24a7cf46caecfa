"""The same application on SQLite and on PostgreSQL."""

from pathlib import Path

import pytest

from tests.backend.conftest import SCENE, SLAB, client_on, saved, settings_in
from tests.backend.test_jobs import solve
from tests.storage.databases import database


@pytest.mark.parametrize("kind", ["sqlite", "postgresql"])
def test_the_whole_loop_runs_on_either_database(kind: str, tmp_path: Path) -> None:
    with (
        database(kind, tmp_path) as url,
        client_on(settings_in(tmp_path, PNEUSTUDIO_DATABASE=url)) as client,
    ):
        version = saved(client, "Loop")
        with client.websocket_connect("ws://localhost/api/live") as socket:
            assert "hello" in socket.receive_text()
            job = client.post("/api/jobs", json={"version_id": version["id"]}).json()
            while job["id"] not in socket.receive_text():  # the history of the design comes first
                continue
        solve(client.app.state.store, job["id"])  # type: ignore[attr-defined]
        assert client.get(f"/api/jobs/{job['id']}").json()["state"] == "done"
        view = client.post("/api/views", json={}).json()["view_id"]
        body = {"source": {"kind": "job", "job_id": job["id"]}, "colour": "stress"}
        content = client.put(f"/api/views/{view}/content", json=body).json()
        # the instant model, in the solver's place here, knows no stress
        assert content["colour"] == "displacement"
        assert content["pressures_kPa"][-1] == SCENE["pressure_kPa"]["to"]
        assert client.delete(f"/api/views/{view}").status_code == 204
        changed = {"design": {**SLAB, "width_mm": 46}, "scene": SCENE, "note": "wider"}
        address = f"/api/designs/{version['design_id']}/versions"
        assert client.post(address, json=changed).json()["number"] == 2


def test_a_database_that_is_away_is_said_so(tmp_path: Path) -> None:
    here, away = tmp_path / "data", tmp_path / "away"
    with client_on(settings_in(here)) as client:
        assert client.get("/api/designs").status_code == 200
        here.rename(away)
        client.app.state.store.close()  # type: ignore[attr-defined]
        answer = client.get("/api/designs")
        assert answer.status_code == 503
        assert "database" in answer.json()["detail"]["message"]
        away.rename(here)
        assert client.get("/api/designs").status_code == 200
