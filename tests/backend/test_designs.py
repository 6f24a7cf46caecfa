"""Families, presets, materials, checking, and keeping designs."""

import pytest
from fastapi.testclient import TestClient

from actuators.design import FAMILIES, PRESETS
from actuators.materials import CATALOGUE
from tests.backend.conftest import OBLIQUE, SCENE, SLAB, saved


def test_families_list_every_parameter_with_its_unit_and_limits(client: TestClient) -> None:
    listed = {f["family"]: f for f in client.get("/api/families").json()}
    assert set(listed) == set(FAMILIES)
    for name, family in FAMILIES.items():
        assert [p["name"] for p in listed[name]["parameters"]] == [
            p.name for p in family.parameters()
        ]
    thickness = next(p for p in listed["slab"]["parameters"] if p["name"] == "bottom_thickness")
    assert (thickness["border_name"], thickness["unit"]) == ("bottom_thickness_mm", "mm")
    assert thickness["lower"] < thickness["default"] < thickness["upper"]
    assert "assumption" in thickness["assumed"]


def test_every_preset_passes_the_check_and_has_its_drawing(client: TestClient) -> None:
    presets = client.get("/api/presets").json()
    assert [p["name"] for p in presets] == list(PRESETS)
    for preset in presets:
        answer = client.post("/api/designs/check", json={"design": preset["design"]})
        assert answer.status_code == 200, answer.text
        check = answer.json()
        assert check["digest"] == PRESETS[preset["name"]].design.digest
        assert {"section", "planform"} == set(check["drawing"]["views"])
        drawn = {line["parameter"] for line in check["drawing"]["dimensions"]}
        assert {"length", "bottom_thickness", "chamber_count"} <= drawn


def test_derived_values_of_the_slab_are_its_geometry(client: TestClient) -> None:
    check = client.post("/api/designs/check", json={"design": SLAB}).json()
    derived = {d["label"]: (d["value"], d["unit"]) for d in check["derived"]}
    assert derived["Total thickness"] == (16.0, "mm")
    # S, Table 1: h1 = h2 = (89 - 6 - 3) / 11
    assert derived["Chamber length"] == (pytest.approx(80 / 11, rel=1e-5), "mm")
    assert derived["Cavity volume"][1] == "ml"
    assert derived["Mass of top layer"][1] == "g"


def test_materials_carry_their_source_and_border_units(client: TestClient) -> None:
    listed = {m["key"]: m for m in client.get("/api/materials").json()}
    assert set(listed) == set(CATALOGUE)
    elastosil = listed["elastosil-m4601"]
    # E = 3 mu (1 - small), so 483.5 kPa belongs to mu near 161 kPa
    assert elastosil["youngs_modulus_kPa"] == pytest.approx(483.5, rel=0.01)
    assert elastosil["source"]


def test_a_design_goes_through_its_life(client: TestClient) -> None:
    version = saved(client, "  Soft   finger ")
    design_id = version["design_id"]
    assert version["design_name"] == "Soft finger"
    assert (version["number"], version["author"]) == (1, "ada")

    thicker = {**SLAB, "bottom_thickness_mm": 5}
    answer = client.post(
        f"/api/designs/{design_id}/versions",
        json={"design": thicker, "scene": SCENE, "note": "thicker"},
    )
    assert answer.status_code == 201
    second = answer.json()
    assert (second["number"], second["parent_id"]) == (2, version["id"])

    history = client.get(f"/api/designs/{design_id}").json()["versions"]
    assert [v["number"] for v in history] == [2, 1]
    assert history[0]["changes"] == [
        {"name": "bottom_thickness", "label": "Bottom layer", "unit": "mm", "from": 4.0, "to": 5.0}
    ]
    assert history[1]["changes"] == []

    renamed = client.patch(f"/api/designs/{design_id}", json={"name": "Thumb"}).json()
    assert renamed["name"] == "Thumb"
    assert design_id in [d["id"] for d in client.get("/api/designs?search=thum").json()]
    client.patch(f"/api/designs/{design_id}", json={"archived": True})
    assert design_id not in [d["id"] for d in client.get("/api/designs").json()]
    assert design_id in [d["id"] for d in client.get("/api/designs?archived=true").json()]


def test_saving_the_same_content_twice_makes_one_version(client: TestClient) -> None:
    version = saved(client, "Twice")
    again = client.post(
        f"/api/designs/{version['design_id']}/versions", json={"design": SLAB, "scene": SCENE}
    )
    assert again.json()["id"] == version["id"]


def test_versions_are_named_forked_and_compared(client: TestClient) -> None:
    version = saved(client, "Origin")
    named = client.patch(f"/api/versions/{version['id']}", json={"label": "moulded in March"})
    assert named.json()["label"] == "moulded in March"
    unnamed = client.patch(f"/api/versions/{version['id']}", json={"label": None})
    assert unnamed.json()["label"] is None

    fork = client.post(f"/api/versions/{version['id']}/fork", json={"name": "Branch"}).json()
    assert fork["version"]["design"] == version["design"]
    other = client.post(
        f"/api/designs/{fork['design_id']}/versions",
        json={"design": OBLIQUE, "scene": {"pressure_kPa": {"to": 60}}},
    ).json()
    compared = client.get(
        "/api/compare", params={"left": version["id"], "right": other["id"]}
    ).json()
    pairs = {p["name"]: p for p in compared["parameters"]}
    assert (pairs["theta"]["left"], pairs["theta"]["right"]) == (None, 45.0)
    assert pairs["length"]["differs"]
    assert (pairs["pressure_to"]["left"], pairs["pressure_to"]["right"]) == (40.0, 60.0)
    for side in ("left", "right"):
        path = compared[side]["instant_result"]["path"]
        assert path[-1]["bending_angle_deg"] != path[0]["bending_angle_deg"]
        assert compared[side]["fe_result"] is None
