"""Downloads: names, kinds, caching."""

import io
import zipfile

import trimesh
from fastapi.testclient import TestClient

from storage import Store
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
    plate = {"pressure_kPa": {"to": 5}, "plate": {"gap_mm": 5}}
    body = {"design": SLAB, "scene": plate, "what": "inp"}
    assert client.post("/api/export", json=body).json()["detail"]["field"] == "plate"
    assert client.post("/api/export", json={**body, "scene": None}).status_code == 422


def test_a_family_that_is_not_cast_says_so_with_its_check(client: TestClient) -> None:
    for design, cast in ((SLAB, True), (OBLIQUE, False)):
        checked = client.post("/api/designs/check", json={"design": design}).json()
        assert ("mould-svg" in checked["unavailable_files"]) is not cast
