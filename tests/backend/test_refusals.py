"""Bad input at the API's door: a clear message, nothing stored, nothing crashed."""

import json
from typing import Any

import pytest
from fastapi.testclient import TestClient
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from storage import Store
from tests.backend.conftest import SCENE, SLAB, saved

JSON = {"content-type": "application/json"}


def detail(answer: Any) -> dict[str, str]:
    """The one form of every refusal."""
    found = answer.json()["detail"]
    assert set(found) == {"message", "field", "value", "mend", "kind", "changes"}
    assert found["message"]
    return found


def count(store: Store) -> tuple[int, int]:
    return len(store.list_designs()), store.last_event_seq()


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"bottom_thickness_mm": -1}, "bottom_thickness"),
        ({"chamber_count": 2.5}, "chamber_count"),
        ({"chamber_count": 61}, "chamber_count"),
        ({"length_mm": "long"}, "length"),
        ({"length_mm": None}, "length"),
        ({"length_mm": [89]}, "length"),
        ({"length_mm": True}, "length"),
        ({"length": 89}, "length"),
        ({"planform": "star"}, "planform"),
        ({"planform": {"a": 1}}, "planform"),
        ({"top_material": "chewing-gum"}, "top_material"),
        ({"top_material": 3}, "top_material"),
        ({"family": "balloon"}, "family"),
        ({"family": ["slab"]}, "family"),
        ({"side_wall_mm": 22}, "side_wall"),
    ],
)
@pytest.mark.parametrize("door", ["check", "predict", "save", "export", "view"])
def test_an_impossible_design_is_refused_by_name_at_every_door(
    client: TestClient, store: Store, door: str, change: dict[str, Any], field: str
) -> None:
    design = {**SLAB, **change}
    before = count(store)
    if door == "check":
        answer = client.post("/api/designs/check", json={"design": design})
    elif door == "predict":
        answer = client.post("/api/predict", json={"design": design, "scene": SCENE})
    elif door == "save":
        answer = client.post("/api/designs", json={"name": "x", "design": design, "scene": SCENE})
    elif door == "export":
        answer = client.post("/api/export", json={"design": design, "what": "actuator-stl"})
    else:
        view = client.post("/api/views", json={}).json()["view_id"]
        source = {"kind": "instant", "design": design, "scene": SCENE}
        answer = client.put(f"/api/views/{view}/content", json={"source": source})
        client.delete(f"/api/views/{view}")
    assert answer.status_code == 422, answer.text
    assert detail(answer)["field"].startswith(field)
    assert count(store) == before


@pytest.mark.parametrize(
    "scene",
    [
        {}, {"pressure_kPa": 30}, {"pressure_kPa": {"to": "30"}}, {"pressure_kPa": {"to": -1}},
        {"pressure_kPa": {"to": 1e9}}, {"pressure_kPa": {"to": 30, "steps": 0}},
        {"pressure_kPa": {"to": 30, "steps": 1.5}}, {"pressure_kPa": {"to": True}},
        {"pressure_kPa": {"to": 30}, "gravity_m_s2": [0, 0]},
        {"pressure_kPa": {"to": 30}, "gravity_m_s2": "down"},
        {"pressure_kPa": {"to": 30}, "plate": {}}, {"volume_ml": {"to": 3}},
    ],
)  # fmt: skip
def test_a_scene_that_cannot_be_computed_is_refused(client: TestClient, scene: Any) -> None:
    answer = client.post("/api/predict", json={"design": SLAB, "scene": scene})
    assert answer.status_code == 422, answer.text
    assert detail(answer)["field"]


@pytest.mark.parametrize(
    "body",
    [
        b"", b"{", b"nonsense", b"[]", b"null", b'"text"', b"\xff\xfe", b"[" * 100_000,
        b'{"design": NaN}', b'{"design": Infinity}', b'{"design": {"length_mm": 1e999}}',
        b'{"design": {"length_mm": 1' + b"0" * 400 + b"}}",
        b'{"design": {"length_mm": 1' + b"0" * 5000 + b"}}",
        b'{"design": {"family": "\\ud800"}}', b'{"design": {"family": "a\\u0000b"}}',
        b'{"design": {"family": "slab"}, "more": 1}', b'{"design": 3}',
    ],
)  # fmt: skip
def test_malformed_bodies_are_refused_with_a_reason(client: TestClient, body: bytes) -> None:
    answer = client.post("/api/designs/check", content=body, headers=JSON)
    assert answer.status_code == 422, answer.text
    detail(answer)


def test_a_huge_body_is_refused_before_it_is_read(client: TestClient) -> None:
    answer = client.post("/api/designs/check", content=b" " * 2_000_000, headers=JSON)
    assert answer.status_code == 413
    detail(answer)


def test_a_body_that_is_not_json_is_refused(client: TestClient) -> None:
    body = json.dumps({"design": SLAB})
    answer = client.post("/api/designs/check", content=body, headers={"content-type": "text/plain"})
    assert answer.status_code == 415
    detail(answer)


@pytest.mark.parametrize(
    ("method", "path", "body"),
    [
        ("GET", "/api/designs/none", None),
        ("PATCH", "/api/designs/none", {"name": "x"}),
        ("POST", "/api/designs/none/versions", {"design": SLAB, "scene": SCENE}),
        ("GET", "/api/versions/none", None),
        ("PATCH", "/api/versions/none", {"label": "x"}),
        ("POST", "/api/versions/none/fork", {"name": "x"}),
        ("GET", "/api/versions/none/files", None),
        ("GET", "/api/versions/none/files/actuator-stl", None),
        ("GET", "/api/compare?left=a&right=b", None),
        ("POST", "/api/jobs", {"version_id": "none"}),
        ("GET", "/api/jobs/none", None),
        ("POST", "/api/jobs/none/cancel", None),
        ("GET", "/api/jobs/none/result", None),
        ("PUT", "/api/views/none/frame", {"index": 0}),
        ("DELETE", "/api/views/none", None),
        ("GET", "/viewer/none/", None),
        ("GET", "/api/nothing", None),
        ("GET", "/api/designs/%00", None),
        ("GET", "/api/jobs/" + "x" * 5000, None),
    ],
)
def test_what_is_not_there_is_404_in_the_same_form(
    client: TestClient, method: str, path: str, body: Any
) -> None:
    answer = client.request(method, path, json=body)
    assert answer.status_code == 404, answer.text
    detail(answer)


@pytest.mark.parametrize(
    ("method", "path", "body"),
    [
        ("POST", "/api/designs", {"name": "   ", "design": SLAB, "scene": SCENE}),
        ("POST", "/api/designs", {"name": "x" * 300, "design": SLAB, "scene": SCENE}),
        ("POST", "/api/designs", {"design": SLAB, "scene": SCENE}),
        ("POST", "/api/predict", {"design": SLAB, "scene": SCENE, "rung": "fe"}),
        ("POST", "/api/predict", {"design": SLAB, "scene": SCENE, "c": -1}),
        ("POST", "/api/predict", {"design": SLAB, "scene": SCENE, "c": "mine"}),
        ("POST", "/api/jobs", {"version_id": 3}),
        ("POST", "/api/export", {"design": SLAB, "what": "gcode"}),
        ("GET", "/api/jobs?state=lazy", None),
        ("GET", "/api/jobs?limit=0", None),
        ("GET", "/api/jobs?limit=many", None),
        ("GET", "/api/compare?left=a", None),
    ],
)
def test_wrong_requests_are_422_in_the_same_form(
    client: TestClient, method: str, path: str, body: Any
) -> None:
    answer = client.request(method, path, json=body)
    assert answer.status_code == 422, answer.text
    assert detail(answer)["field"]


@pytest.mark.parametrize(
    ("c", "reason"),
    [(1e5, "less than or equal to 10000"), ("mine", "'published'"), ({"a": 1}, "c is")],
)
def test_an_entry_that_may_be_of_two_kinds_is_named_as_it_was_sent(
    client: TestClient, c: Any, reason: str
) -> None:
    answer = client.post("/api/predict", json={"design": SLAB, "scene": SCENE, "c": c})
    assert answer.status_code == 422, answer.text
    found = detail(answer)
    assert found["field"] == "c"
    assert reason in found["message"]
    assert "literal" not in found["message"] + found["mend"]


@pytest.mark.parametrize("accuracy", [0, -1, 2, "high", None])
def test_a_job_with_an_impossible_accuracy_is_refused(
    client: TestClient, store: Store, accuracy: Any
) -> None:
    version = saved(client)["id"]
    before = count(store)
    answer = client.post("/api/jobs", json={"version_id": version, "accuracy": accuracy})
    assert answer.status_code == 422
    assert detail(answer)["field"] == "accuracy"
    assert count(store) == before
    assert client.get(f"/api/jobs?version_id={version}").json() == []


SCALARS = (
    st.none() | st.booleans() | st.integers(-(10**40), 10**40) | st.text(max_size=8)
    | st.floats(allow_nan=False, allow_infinity=False)
)  # fmt: skip
ANYTHING = st.recursive(
    SCALARS,
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(
            st.sampled_from([*SLAB, "to", "steps", "kind"]) | st.text(max_size=5), inner
        )
    ),
    max_leaves=8,
)
DOORS = ["/api/designs/check", "/api/predict", "/api/designs", "/api/jobs", "/api/export",
         "/api/views"]  # fmt: skip


@settings(
    max_examples=150, deadline=None, derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)  # fmt: skip
@given(st.sampled_from(DOORS), st.data())
def test_no_body_whatever_crashes_the_api(
    client: TestClient, door: str, data: st.DataObject
) -> None:
    design = {**SLAB, **data.draw(st.dictionaries(st.sampled_from(list(SLAB)), ANYTHING))}
    scene = data.draw(st.just(SCENE) | ANYTHING)
    body = data.draw(
        st.just({"design": design, "scene": scene})
        | st.fixed_dictionaries(
            {"design": st.just(design) | ANYTHING, "scene": st.just(scene)},
            optional={"name": ANYTHING, "rung": ANYTHING, "c": ANYTHING, "what": ANYTHING,
                      "version_id": ANYTHING, "accuracy": ANYTHING, "dark": ANYTHING},
        )
        | ANYTHING
    )  # fmt: skip
    answer = client.post(door, content=json.dumps(body), headers=JSON)
    assert answer.status_code < 500, (door, body, answer.text)
    if answer.status_code >= 400:
        detail(answer)


def test_a_client_may_prefer_refusals_as_answers(client: TestClient) -> None:
    """A browser logs every status of 400 and more as an error; what is tried is none."""
    design = {**SLAB, "length_mm": 5}
    plain = client.post("/api/designs/check", json={"design": design})
    assert plain.status_code == 422
    asked = {"Prefer": "refusal=answer"}
    answer = client.post("/api/designs/check", json={"design": design}, headers=asked)
    assert answer.status_code == 200
    assert answer.headers["preference-applied"] == "refusal=answer"
    assert answer.json() == plain.json()
    assert answer.json()["detail"]["changes"] == [{"field": "length_mm", "value": 10.0}]
    assert client.get("/api/versions/none", headers=asked).status_code == 404
    good = client.post("/api/designs/check", json={"design": SLAB}, headers=asked)
    assert "preference-applied" not in good.headers
