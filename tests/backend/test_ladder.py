"""The ladder over HTTP: stored answers are measured points, the rest is predicted."""

import subprocess
import sys
from typing import Any

from fastapi.testclient import TestClient

from actuators.design import parse_design
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene
from storage import Store
from storage.question import science_version
from tests.backend.conftest import SLAB, client_on, saved, settings_in

QUESTION = {"pressure_kPa": {"to": 4.0, "steps": 4}}
ASKED = {"run": ["closed-form", "energy"]}
"""Rungs whose answers take milliseconds: what is tested does not depend on the third."""


def finish(
    client: TestClient, *, accuracy: float, seconds: float, percent: float | None,
    outcome: str = "converged", scene: dict[str, Any] = QUESTION, mesh: str | None = None,
) -> None:  # fmt: skip
    """A job computed by a worker: the energy rung's path under the name of finite elements."""
    store: Store = client.app.state.store  # type: ignore[attr-defined]
    body = {"version_id": saved(client)["id"], "scene": scene, "accuracy": accuracy, "mesh": mesh}
    job = client.post("/api/jobs", json=body).json()
    taken = store.claim(job["id"], worker="w1@bench", science_version=science_version())
    assert taken is not None
    document = predict(parse_design(SLAB), Scene.from_document(scene)).to_document()
    document |= {
        "rung": "fe", "outcome": outcome, "wall_s": seconds, "error_estimate_percent": percent,
        "error_estimates_percent": {} if percent is None else {"tip": percent},
    }  # fmt: skip
    store.finish(job["id"], taken.attempt, document, b"arrays")


def points(client: TestClient, **more: Any) -> tuple[Any, dict[str, Any]]:
    answer = client.post("/api/ladder", json={"design": SLAB, "scene": QUESTION, **ASKED, **more})
    assert answer.status_code == 200, answer.text
    return answer.json(), {point["label"]: point for point in answer.json()["points"]}


def test_stored_answers_are_measured_and_teach_the_others_seconds(tmp_path: Any) -> None:
    with client_on(settings_in(tmp_path)) as client:
        before, predicted = points(client)
        assert before["learned_from_jobs"] == 0
        assert predicted["fe 10 %"]["state"] == "predicted"
        finish(client, accuracy=0.1, seconds=90.0, percent=4.0)
        after, now = points(client, at_most_percent=[4.5, 0.001], at_most_s=[1.0])
    assert after["learned_from_jobs"] == 1
    assert now["fe 10 %"]["state"] == "measured"
    assert now["fe 10 %"]["is_best"]
    assert now["fe 10 %"]["error_percent"]["high"] == 4.0
    # the same path, so the energy rung is off by nothing, give or take the best answer's own error
    assert now["energy"]["error_percent"]["value"] < 1e-6
    assert abs(now["energy"]["error_percent"]["high"] - 4.0) < 1e-6
    assert now["fe 5 %"]["same_as"] == "fe 10 %"
    assert now["fe 2 %"]["seconds"]["value"] > max(90.0, predicted["fe 2 %"]["seconds"]["value"])
    within, beyond, quick = after["choices"]
    assert {within["rung"], quick["rung"]} <= {"energy", "fe 10 %", "fe 5 %"}
    assert beyond["rung"] is None
    assert "no rung is expected to reach it" in beyond["why"]


def test_a_job_under_way_is_named_and_a_failed_one_says_why(client: TestClient) -> None:
    store: Store = client.app.state.store  # type: ignore[attr-defined]
    version = saved(client, "Failing")
    body = {"version_id": version["id"], "scene": QUESTION, "accuracy": 0.02}
    job = client.post("/api/jobs", json=body).json()
    assert points(client)[1]["fe 2 %"]["job_id"] == job["id"]
    taken = store.claim(job["id"], worker="w1@bench", science_version=science_version())
    assert taken is not None
    store.fail(job["id"], taken.attempt, "The cylinder reaches 2 mm into the body.")
    refused = points(client)[1]["fe 2 %"]
    assert (refused["state"], refused["job_id"]) == ("refused", None)
    assert refused["reason"] == "The cylinder reaches 2 mm into the body."


def test_a_job_cut_short_by_its_budget_raises_what_is_expected(tmp_path: Any) -> None:
    with client_on(settings_in(tmp_path)) as client:
        finish(client, accuracy=0.05, seconds=500.0, percent=None, outcome="budget_spent")
        point = points(client)[1]["fe 5 %"]
    assert point["state"] == "predicted"
    assert point["seconds"]["low"] > 500.0
    assert "stopped after" in point["reason"]
    assert (point["outcome"], point["ends_at_kPa"]) == ("budget_spent", 4.0)


def test_a_run_on_one_mesh_is_a_point_of_its_own_however_it_ended(tmp_path: Any) -> None:
    for outcome in ("converged", "limit_point", "cancelled"):
        with client_on(settings_in(tmp_path / outcome)) as client:
            finish(client, accuracy=0.05, seconds=7.0, percent=None, outcome=outcome, mesh="coarse")
            found = points(client)[1]
        coarse = found["fe coarse mesh"]
        assert (coarse["state"], coarse["outcome"]) == ("measured", outcome)
        assert (coarse["seconds"]["value"], coarse["ends_at_kPa"]) == (7.0, 4.0)
        assert found["fe 5 %"]["state"] == "predicted"


def test_a_job_cancelled_before_its_first_point_says_how_long_it_was_waited_for(
    tmp_path: Any,
) -> None:
    with client_on(settings_in(tmp_path)) as client:
        store: Store = client.app.state.store  # type: ignore[attr-defined]
        body = {"version_id": saved(client)["id"], "scene": QUESTION, "accuracy": 0.05}
        job = client.post("/api/jobs", json=body).json()
        assert points(client)[1]["fe 5 %"]["job_id"] == job["id"]
        taken = store.claim(job["id"], worker="w1@bench", science_version=science_version())
        assert taken is not None
        client.post(f"/api/jobs/{job['id']}/cancel")
        assert store.confirm_cancel(job["id"], taken.attempt)
        found = points(client)[1]["fe 5 %"]
        assert (found["state"], found["outcome"]) == ("predicted", "cancelled")
        assert "stopped after" in found["reason"]
        assert found["job_id"] is None
        # asked again and answered, that is forgotten
        finish(client, accuracy=0.05, seconds=7.0, percent=2.0)
        assert points(client)[1]["fe 5 %"]["state"] == "measured"


def test_loads_beyond_an_instant_rung_are_refused_in_its_words(client: TestClient) -> None:
    scene = {**QUESTION, "plate": {"gap_mm": 5.0, "normal": [0, 0, 1]}}
    answer = client.post("/api/ladder", json={"design": SLAB, "scene": scene}).json()
    refused = {p["rung"]: p["reason"] for p in answer["points"] if p["state"] == "refused"}
    assert "plate is 5 mm away" in refused["closed-form"]


def test_instant_rungs_not_asked_now_are_predicted(client: TestClient) -> None:
    _, found = points(client, run=["closed-form"])
    assert found["closed-form"]["state"] == "measured"
    assert found["energy"]["state"] == "predicted"
    assert found["energy"]["seconds"]["value"] < 1


def test_limits_that_mean_nothing_are_refused(client: TestClient) -> None:
    body = {"design": SLAB, "scene": QUESTION, "at_most_percent": [0]}
    assert client.post("/api/ladder", json=body).status_code == 422


def test_an_instant_answer_says_how_far_off_it_typically_is(client: TestClient) -> None:
    answer = client.post("/api/predict", json={"design": SLAB, "scene": QUESTION}).json()
    typical = answer["typical_errors"]
    assert len(typical) == len(answer["result"]["path"])
    assert typical[-1]["half_below_percent"] < typical[-1]["four_of_five_below_percent"]


def test_the_web_process_does_not_load_the_3d_solver() -> None:
    code = (
        "import sys, backend.simulations.ladder; "
        "sys.exit('actuators.mechanics.continuum' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_job_under_way_has_the_seconds_that_its_ladder_told(client: TestClient) -> None:
    store: Store = client.app.state.store  # type: ignore[attr-defined]
    version, scene = saved(client, "Expected"), {"pressure_kPa": {"to": 5.0, "steps": 4}}
    body = {"version_id": version["id"], "scene": scene, "accuracy": 0.02}
    job = client.post("/api/jobs", json=body).json()
    told = points(client, scene=scene)[1]["fe 2 %"]["seconds"]
    address = f"/api/jobs/{job['id']}/expected"
    assert client.get(address).json() == told
    assert told["low"] < told["value"] < told["high"]
    # one mesh is not on the ladder; it has its seconds as well
    coarse = client.post("/api/jobs", json={**body, "mesh": "coarse"}).json()
    alone = client.get(f"/api/jobs/{coarse['id']}/expected").json()
    assert 0.0 < alone["value"] < told["value"]
    store.cancel(job["id"])
    assert client.get(address).json() is None
    assert client.get("/api/jobs/none/expected").status_code == 404
