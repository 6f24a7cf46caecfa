"""Downloads: names, kinds, caching."""

import io
import zipfile
from itertools import takewhile

import numpy as np
import pytest
import trimesh
from fastapi.testclient import TestClient

from storage import BodyFiles, Store
from tests.backend.conftest import OBLIQUE, SLAB, saved
from tests.backend.test_jobs import solve


def test_files_of_a_slab_are_named_after_the_design(client: TestClient, store: Store) -> None:
    version = saved(client, "Größe 7 / left", SLAB)
    base = f"/api/versions/{version['id']}/files"
    offered = {f["what"]: f for f in client.get(base).json()}
    assert offered["mould-svg"]["available"]
    assert offered["actuator-stl"]["file_name"] == "gr-e-7-left-v1.stl"
    assert not offered["result-json"]["available"]
    assert "no finite-element result" in offered["result-json"]["reason"]
    assert client.get(f"{base}/result-json").status_code == 422

    mould = client.get(f"{base}/mould-svg")
    assert mould.headers["content-disposition"].startswith('attachment; filename="gr-e-7-left-v1')
    if mould.headers["content-type"] == "application/zip":
        names = zipfile.ZipFile(io.BytesIO(mould.content)).namelist()
        assert len(names) > 1
        assert all(name.endswith((".svg", ".txt", ".md")) for name in names), names

    stl = client.get(f"{base}/actuator-stl")
    mesh = trimesh.load(io.BytesIO(stl.content), file_type="stl")
    assert mesh.is_watertight  # type: ignore[union-attr]
    unchanged = client.get(f"{base}/actuator-stl", headers={"if-none-match": stl.headers["etag"]})
    assert (unchanged.status_code, unchanged.content) == (304, b"")


def test_a_result_comes_as_json_and_as_one_line_per_pressure(
    client: TestClient, store: Store
) -> None:
    version = saved(client, "Result", {**SLAB, "length_mm": 93})
    job = client.post("/api/jobs", json={"version_id": version["id"]}).json()
    solve(store, job["id"])
    base = f"/api/versions/{version['id']}/files"
    document = client.get(f"{base}/result-json").json()
    lines = client.get(f"{base}/result-csv").text.splitlines()
    assert len(lines) == 1 + len(document["path"])
    assert {"pressure_kPa", "tip_x1_mm", "bending_angle_deg"} <= set(lines[0].split(","))


def test_fields_in_the_whole_body_come_with_the_result_they_belong_to(
    client: TestClient, store: Store
) -> None:
    version = saved(client, "Body", {**SLAB, "length_mm": 95})
    base = f"/api/versions/{version['id']}/files"
    jobs: dict[float, str] = {}
    for accuracy, files in (
        (0.1, BodyFiles(b"ten", 7)),
        (0.05, None),
        (0.02, BodyFiles(b"2", 3)),
    ):
        body = {"version_id": version["id"], "accuracy": accuracy}
        jobs[accuracy] = client.post("/api/jobs", json=body).json()["id"]
        solve(store, jobs[accuracy], files)
    one = client.get(f"/api/jobs/{jobs[0.1]}/result").json()
    assert one["body_files"] == {"points": 7, "bytes": 3}
    best = client.get(f"{base}/result-body")
    assert best.content == b"2"
    assert 'filename="body-v1-whole-body.zip"' in best.headers["content-disposition"]
    assert client.get(f"{base}/result-body", params={"job_id": jobs[0.1]}).content == b"ten"

    # a result without them says so, and how to have them
    of_second = {"job_id": jobs[0.05]}
    assert client.get(f"/api/jobs/{jobs[0.05]}/result").json()["body_files"] is None
    offered = {f["what"]: f for f in client.get(base, params=of_second).json()}
    assert offered["result-csv"]["available"]
    assert not offered["result-body"]["available"]
    assert "export --what vtu" in offered["result-body"]["reason"]
    assert client.get(f"{base}/result-body", params=of_second).status_code == 422

    # a job of another question has no file here
    other = saved(client, "Other", {**SLAB, "length_mm": 96})
    elsewhere = f"/api/versions/{other['id']}/files/result-csv"
    assert client.get(elsewhere, params=of_second).status_code == 404


def test_an_oblique_design_says_why_it_has_no_laser_cut_mould(client: TestClient) -> None:
    version = saved(client, "Oblique", OBLIQUE)
    offered = {f["what"]: f for f in client.get(f"/api/versions/{version['id']}/files").json()}
    assert not offered["mould-svg"]["available"]
    assert "slab" in offered["mould-svg"]["reason"]
    answer = client.get(f"/api/versions/{version['id']}/files/mould-svg")
    assert answer.status_code == 422


def test_a_design_that_is_not_saved_is_exported(client: TestClient) -> None:
    before = len(client.get("/api/designs").json())
    body = {"design": OBLIQUE, "what": "actuator-stl", "name": "Trial"}
    answer = client.post("/api/export", json=body)
    assert answer.headers["content-disposition"].startswith('attachment; filename="trial.stl"')
    assert len(client.get("/api/designs").json()) == before


def test_a_model_comes_as_a_deck_of_its_scene(client: TestClient) -> None:
    version = saved(client, "Deck", {**SLAB, "length_mm": 94})
    deck = client.get(f"/api/versions/{version['id']}/files/inp")
    assert deck.headers["content-disposition"].startswith('attachment; filename="deck-v1.inp"')
    assert b"*DLOAD" in deck.content or b"*DSLOAD" in deck.content
    filled = {"volume_ml": {"to": 40}}
    body = {"design": SLAB, "scene": filled, "what": "inp"}
    assert client.post("/api/export", json=body).json()["detail"]["field"] == "volume_ml"
    assert client.post("/api/export", json={**body, "scene": None}).status_code == 422


def test_a_deck_of_a_volume_holds_the_pressures_of_the_answer_there_is(
    client: TestClient, store: Store
) -> None:
    loads = {"volume_ml": {"to": 14.0, "steps": 4}}
    version = saved(client, "Filled", {**SLAB, "length_mm": 96}, scene=loads)
    base = f"/api/versions/{version['id']}/files"
    offered = {f["what"]: f for f in client.get(base).json()}
    assert "Run 3D FE" in offered["inp"]["reason"]
    assert client.get(f"{base}/inp").status_code == 422

    job = client.post("/api/jobs", json={"version_id": version["id"]}).json()
    solve(store, job["id"], rung="cell-rod")
    path = client.get(f"/api/jobs/{job['id']}/result").json()["path"]
    assert {f["what"]: f for f in client.get(base).json()}["inp"]["available"]
    for query in ({}, {"job_id": job["id"]}):
        lines = client.get(f"{base}/inp", params=query).text.splitlines()
        at = lines.index("*AMPLITUDE, NAME=INFLATION")
        pairs = ", ".join(takewhile(lambda line: line[:1].isdigit(), lines[at + 1 :]))
        times, shares = np.array(pairs.split(", "), dtype=float).reshape(-1, 2).T
        end = path[-1]["pressure_kPa"]
        assert shares == pytest.approx([p["pressure_kPa"] / end for p in path], abs=1e-6)
        volume = np.array([p["cavity_volume_ml"] for p in path])
        assert times == pytest.approx((volume - volume[0]) / np.ptp(volume), abs=1e-6)
        pressures = {float(line.split(",")[2]) for line in lines if ", P" in line}
        assert max(pressures) == pytest.approx(end / 1e3, rel=1e-6)


def test_a_family_that_is_not_cast_says_so_with_its_check(client: TestClient) -> None:
    for design, cast in ((SLAB, True), (OBLIQUE, False)):
        checked = client.post("/api/designs/check", json={"design": design}).json()
        assert ("mould-svg" in checked["unavailable_files"]) is not cast
