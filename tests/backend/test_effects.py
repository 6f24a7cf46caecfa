"""Which effects a question calls for, over HTTP."""

from typing import Any

from fastapi.testclient import TestClient

SLAB: dict[str, Any] = {"family": "slab"}


def decided(client: TestClient, scene: dict[str, Any], accuracy: float = 0.05) -> dict[str, Any]:
    answer = client.post(
        "/api/effects", json={"design": SLAB, "scene": scene, "accuracy": accuracy}
    )
    assert answer.status_code == 200, answer.text
    return answer.json()


def test_every_effect_is_decided_with_its_reason(client: TestClient) -> None:
    plan = decided(client, {"pressure_kPa": {"to": 5}})
    effects = {each["name"]: each for each in plan["effects"]}
    assert len(effects) == 11
    assert effects["gravity"]["on"]
    assert effects["gravity"]["estimated_change_percent"] > plan["threshold_percent"]
    assert not effects["plate_contact"]["on"]
    assert effects["self_contact"]["watched"]
    assert all(each["reason"] for each in plan["effects"])


def test_a_choice_is_kept_and_marked(client: TestClient) -> None:
    plan = decided(client, {"pressure_kPa": {"to": 5}, "effects": {"gravity": "off"}})
    gravity = plan["effects"][0]
    assert (gravity["name"], gravity["on"], gravity["forced"]) == ("gravity", False, "off")


def test_an_effect_without_its_data_is_refused_by_name(client: TestClient) -> None:
    scene = {"pressure_kPa": {"to": 5}, "effects": {"plate_contact": "on"}}
    answer = client.post("/api/effects", json={"design": SLAB, "scene": scene})
    assert answer.status_code == 422
    assert answer.json()["detail"]["field"] == "effects.plate_contact"
    assert "no plate" in answer.json()["detail"]["message"]


def test_the_instant_answer_leaves_out_what_it_cannot_switch_on(client: TestClient) -> None:
    scene = {
        "pressure_kPa": {"to": 5}, "plate": {"gap_mm": 5},
        "effects": {"plate_contact": "on", "finite_strain": "on"},
    }  # fmt: skip
    question = {"design": SLAB, "scene": scene, "beyond": "leave out"}
    answer = client.post("/api/predict", json=question)
    assert answer.status_code == 200, answer.text
    left_out = {each["field"] for each in answer.json()["left_out"]}
    assert left_out == {"plate", "effects.finite_strain"}
