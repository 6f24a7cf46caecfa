"""Jobs over HTTP, with a worker's side played on the real store."""

from dataclasses import replace

from fastapi.testclient import TestClient

from actuators.design import parse_design
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Outcome
from actuators.mechanics.scene import Scene
from backend.system.schemas import Health
from storage import BodyFiles, Part, Store
from storage.question import science_version
from storage.response_arrays import pack
from tests.backend.conftest import SLAB, saved


def solve(
    store: Store, job_id: str, files: BodyFiles | None = None, *, rung: str = "energy"
) -> None:
    """What a worker does, with an instant model in the place of the solver."""
    claimed = store.claim(job_id, worker="w", science_version=science_version())
    assert claimed is not None
    store.progress(job_id, claimed.attempt, fraction=0.5, message="half", pressure=20e3)
    response = predict(parse_design(claimed.design), Scene.from_document(claimed.scene), rung=rung)
    document = response.to_document()
    assert store.finish(job_id, claimed.attempt, document, pack(response), files)


def test_a_job_is_queued_solved_and_answered_from_the_store(
    client: TestClient, store: Store
) -> None:
    version = saved(client, "Job", {**SLAB, "length_mm": 90})
    submitted = client.post("/api/jobs", json={"version_id": version["id"], "accuracy": 0.1})
    assert submitted.status_code == 201
    job = submitted.json()
    assert (job["state"], job["pressure_to_kPa"], job["fraction"]) == ("queued", 40.0, 0.0)
    assert client.get(f"/api/jobs/{job['id']}/result").status_code == 404

    solve(store, job["id"])
    done = client.get(f"/api/jobs/{job['id']}").json()
    assert (done["state"], done["outcome"], done["fraction"]) == ("done", "converged", 1.0)
    assert done["elapsed_s"] >= 0
    result = client.get(f"/api/jobs/{job['id']}/result").json()
    assert result["path"][-1]["pressure_kPa"] == 40.0

    fork = client.post(f"/api/versions/{version['id']}/fork", json={"name": "Same"}).json()
    assert [each["id"] for each in fork["version"]["answered_by"]] == [job["id"]]
    body = {"version_id": fork["version"]["id"], "accuracy": 0.1}
    again = client.post("/api/jobs", json=body).json()
    assert (again["state"], again["from_store"]) == ("done", True)

    history = client.get(f"/api/designs/{version['design_id']}").json()["versions"]
    (summary,) = history[0]["results"]
    assert summary["job_id"] == job["id"]
    assert client.post("/api/jobs", json={**body, "version_id": version["id"]}).json()["from_store"]
    again_there = client.get(f"/api/designs/{version['design_id']}").json()["versions"]
    assert again_there == history, "an answer stands once, however often it was asked for"
    of_fork = client.get(f"/api/designs/{fork['design_id']}").json()["versions"]
    assert len(of_fork[0]["results"]) == 1
    assert summary["bending_angle_deg"] == result["path"][-1]["bending_angle_deg"]
    compared = client.get(f"/api/compare?left={version['id']}&right={version['id']}").json()
    assert compared["left"]["fe_result"]["path"] == result["path"]


def test_asking_twice_joins_the_job_and_cancelling_ends_it(client: TestClient) -> None:
    version = saved(client, "Cancel", {**SLAB, "length_mm": 91})
    first = client.post("/api/jobs", json={"version_id": version["id"]}).json()
    second = client.post("/api/jobs", json={"version_id": version["id"]}).json()
    assert first["id"] == second["id"]
    assert client.post(f"/api/jobs/{first['id']}/cancel").json()["state"] == "cancelled"
    listed = client.get("/api/jobs", params={"version_id": version["id"], "state": "cancelled"})
    assert [job["id"] for job in listed.json()] == [first["id"]]


def test_a_message_for_the_worker_reaches_the_broker(client: TestClient) -> None:
    version = saved(client, "Message", {**SLAB, "length_mm": 92})
    job = client.post("/api/jobs", json={"version_id": version["id"]}).json()
    folder = client.app.state.settings.deployment.data / "queue"  # type: ignore[attr-defined]
    messages = [path.read_text() for path in folder.rglob("*") if path.is_file()]
    assert any("pneustudio.solve" in text for text in messages), job["id"]


def test_health_tells_whether_a_worker_is_alive(client: TestClient, store: Store) -> None:
    before = Health.model_validate(client.get("/api/health").json())
    assert (before.status, before.worker.alive) == ("degraded", False)
    store.worker_seen("w", "v")
    after = Health.model_validate(client.get("/api/health").json())
    assert (after.status, after.worker.alive) == ("ok", True)
    store.worker_left("w")


def test_the_part_found_by_a_job_that_failed_is_shown_and_answers_nothing_else(
    client: TestClient, store: Store
) -> None:
    version = saved(client, "Lost", {**SLAB, "length_mm": 98})
    job = client.post("/api/jobs", json={"version_id": version["id"]}).json()
    claimed = store.claim(job["id"], worker="w", science_version=science_version())
    assert claimed is not None
    whole = predict(parse_design(claimed.design), Scene.from_document(claimed.scene))
    found = replace(whole, outcome=Outcome.CANCELLED, path=whole.path[:4])
    part = Part(found.to_document(), pack(found), 0.1)
    store.fail(job["id"], claimed.attempt, "It broke.", advice="Again.", part=part)

    failed = client.get(f"/api/jobs/{job['id']}").json()
    assert (failed["state"], failed["outcome"], failed["has_answer"]) == ("failed", "failed", True)
    assert "is kept. Again." in failed["advice"]
    result = client.get(f"/api/jobs/{job['id']}/result").json()
    assert result["outcome"] == "failed"
    assert result["path"] == found.to_document()["path"]
    compared = client.get(f"/api/compare?left={version['id']}&right={version['id']}").json()
    assert compared["left"]["fe_result"] is None
    question = {"design": version["design"], "scene": version["scene"]}
    points = client.post("/api/ladder", json=question).json()["points"]
    refused = [p["reason"] for p in points if p["rung"] == "fe" and p["state"] == "refused"]
    assert len(refused) == 1
    assert refused[0].startswith("It broke.")
