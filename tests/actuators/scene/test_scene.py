"""Scenes: their documents, what they refuse, and identities that must never change."""

from typing import Any

import pytest

from actuators.design import preset
from actuators.errors import InputError, QuestionError, SceneError
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Cylinder, Plate, Scene

FULL = {
    "volume_ml": {"to": 40.0, "steps": 8},
    "gravity_m_s2": [0.0, 0.0, 9.81],
    "outside_pressure_kPa": 0.1,
    "tip_force_N": [0.0, 0.0, 0.05],
    "plate": {"gap_mm": 5.0, "normal": [0.0, 0.0, 1.0]},
    "cylinder": {"radius_mm": 20.0, "centre_mm": [60.0, 0.0, -25.0], "axis": [0.0, 1.0, 0.0]},
    "effects": {"self_contact": "off"},
}


@pytest.mark.parametrize(
    "scene",
    [
        Scene(30e3),
        Scene(-20e3, steps=3),
        Scene(volume_to=38.25e-6, gravity=None),
        Scene(10e3, tip_force=(0, 0.1, -0.2), outside_pressure=-150.0, self_contact="on"),
        Scene(10e3, plate=Plate(0.003, (1, 0, 1)), cylinder=Cylinder(0.02, (0.06, 0, -0.03))),
    ],
)
def test_a_scene_returns_from_its_document(scene: Scene) -> None:
    again = Scene.from_document(scene.to_document())
    assert again.to_document() == scene.to_document()
    assert again.digest == scene.digest


def test_a_full_document_returns_from_its_scene() -> None:
    scene = Scene.from_document(FULL)
    assert scene.to_document() == FULL
    assert (scene.pressure_to, scene.volume_to) == (None, pytest.approx(40e-6))
    assert scene.plate == Plate(0.005, (0, 0, 1))
    assert scene.cylinder == Cylinder(0.02, (0.06, 0, -0.025), (0, 1, 0))


def test_scenes_without_further_loads_keep_the_identity_they_always_had() -> None:
    assert [scene.digest[:16] for scene in (
        Scene(30e3), Scene(12345.6789, steps=7, gravity=None), Scene(0.0, gravity=(0, 3.0, -9.81)),
    )] == ["82093e52ab571d91", "d9b6810b9449c710", "095bf4515f12b82e"]  # fmt: skip


def test_a_force_of_nothing_is_no_force() -> None:
    plain = {"pressure_kPa": {"to": 30.0}}
    forced = {**plain, "tip_force_N": [0, 0, 0], "outside_pressure_kPa": 0, "effects": {}}
    assert Scene.from_document(forced).digest == Scene.from_document(plain).digest


@pytest.mark.parametrize(
    ("more", "field"),
    [
        ({"volume_ml": {"to": 40}}, "volume_ml"),
        ({"pressure_kPa": {"to": -101.4}}, "pressure"),
        ({"pressure_kPa": {"to": float("nan")}}, "pressure"),
        ({"pressure_kPa": {"to": 10**400}}, "pressure_kPa"),
        ({"outside_pressure_kPa": float("inf")}, "outside_pressure"),
        ({"outside_on": "top"}, "outside_on"),
        ({"tip_force_N": [0, 0]}, "tip_force_N"),
        ({"tip_force_N": [0, 0, 1e9]}, "tip_force"),
        ({"plate": {}}, "plate.gap_mm"),
        ({"plate": {"gap_mm": -1}}, "plate.gap"),
        ({"plate": {"gap_mm": 1, "normal": [0, 0, 0]}}, "plate.normal"),
        ({"plate": 5}, "plate"),
        ({"cylinder": {"radius_mm": 10}}, "cylinder.centre_mm"),
        ({"cylinder": {"radius_mm": 0, "centre_mm": [0, 0, 0]}}, "cylinder.radius"),
        ({"cylinder": {"radius_mm": 5, "centre_mm": [0, 0, 1e9]}}, "cylinder.centre"),
        ({"cylinder": {"radius_mm": 5, "centre_mm": [0, 0, 0], "colour": 1}}, "colour"),
        ({"effects": {"self_contact": "perhaps"}}, "self_contact"),
        ({"wind": 3}, "wind"),
    ],
)
def test_what_cannot_be_a_scene_is_refused_by_name(more: dict[str, Any], field: str) -> None:
    with pytest.raises(SceneError) as refusal:
        Scene.from_document({"pressure_kPa": {"to": 30}, **more})
    assert refusal.value.field == field
    assert refusal.value.mend


@pytest.mark.parametrize("arguments", [{}, {"pressure_to": 1e3, "volume_to": 1e-5}])
def test_exactly_one_quantity_ends_the_path(arguments: dict[str, float]) -> None:
    with pytest.raises(SceneError, match="exactly one"):
        Scene(**arguments)  # pyright: ignore


@pytest.mark.parametrize("volume", [0.0, -1e-6, 1.0, float("nan")])
def test_a_volume_must_be_one_a_cavity_can_have(volume: float) -> None:
    with pytest.raises(SceneError) as refusal:
        Scene(volume_to=volume)
    assert refusal.value.field == "volume"
    assert "above 0" in str(refusal.value)
    assert "above 0" in refusal.value.mend


@pytest.mark.parametrize(
    ("scene", "symmetric"),
    [
        (Scene(1e3), True),
        (Scene(1e3, gravity=(0, 1, 0)), False),
        (Scene(1e3, gravity=None, tip_force=(1, 0, 1)), True),
        (Scene(1e3, tip_force=(0, 1, 0)), False),
        (Scene(1e3, plate=Plate(0.0, (1, 0, 1))), True),
        (Scene(1e3, plate=Plate(0.0, (0, 1, 1))), False),
        (Scene(1e3, cylinder=Cylinder(0.01, (0.1, 0.02, 0), (0, 1, 0))), True),
        (Scene(1e3, cylinder=Cylinder(0.01, (0.1, 0.02, 0), (1, 0, 0))), False),
        (Scene(1e3, cylinder=Cylinder(0.01, (0.1, 0, 0), (1, 0, 1))), True),
        (Scene(1e3, cylinder=Cylinder(0.01, (0.1, 0, 0), (1, 1, 0))), False),
    ],
)
def test_a_load_out_of_the_middle_plane_needs_the_whole_body(scene: Scene, symmetric: bool) -> None:
    assert scene.symmetric is symmetric


@pytest.mark.parametrize("rung", ["energy", "closed-form"])
@pytest.mark.parametrize(
    ("scene", "field"),
    [
        (Scene(volume_to=1e-5), "volume"),
        (Scene(-1e3), "pressure"),
        (Scene(1e3, plate=Plate(0.0)), "plate"),
        (Scene(1e3, cylinder=Cylinder(0.01, (0, 0, -0.1))), "cylinder"),
        (Scene(1e3, self_contact="on"), "self_contact"),
    ],
)
def test_instant_rungs_name_the_one_that_carries_a_load(
    scene: Scene, field: str, rung: str
) -> None:
    with pytest.raises(QuestionError, match=r"rung (cell-rod or )?fe") as refusal:
        predict(preset("slab-rectangle-low").design, scene, rung=rung)
    assert refusal.value.field == field
    assert isinstance(refusal.value, InputError)


def test_the_closed_form_leaves_outer_loads_to_rungs_with_a_rod() -> None:
    for scene in (Scene(1e3, outside_pressure=100.0), Scene(1e3, tip_force=(0.0, 0.0, 0.1))):
        with pytest.raises(QuestionError, match="cell-rod or fe"):
            predict(preset("slab-rectangle-low").design, scene, rung="closed-form")
        assert predict(preset("slab-rectangle-low").design, scene).path
