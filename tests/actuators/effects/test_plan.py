"""Decisions of the plan: estimates against closed forms and finite elements, budgets, refusals."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from actuators.design import preset
from actuators.errors import QuestionError, SceneError
from actuators.mechanics.choices import NAMES
from actuators.mechanics.effects import plan
from actuators.mechanics.effects.forecast import Forecast
from actuators.mechanics.effects.plan import shared_threshold
from actuators.mechanics.effects.reach import (
    narrowing,
    obstacle_distances,
    self_clearance,
    way_up_to,
)
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene

BAR = preset("printed-14").design.changed(chamber_count=3, length=30)
SLAB = preset("slab-rectangle-low").design.changed(chamber_count=2, length=36, width=20)


def test_every_effect_is_decided_once_and_in_order() -> None:
    decided = plan(BAR, Scene(1e3))
    assert tuple(d.name for d in decided.decisions) == NAMES
    assert all(d.reason for d in decided.decisions)


@pytest.mark.parametrize("axis", [1, 2])
def test_a_small_tip_force_bends_the_forecast_like_a_cantilever(axis: int) -> None:
    """u = sum of C lever^2 dx F, C the compliance against bending in that plane; C L^3/3 for a
    rod of one compliance."""
    force = (0.0, 1e-3, 0.0) if axis == 1 else (0.0, 0.0, 1e-3)
    found = Forecast(BAR, Scene(1e3, gravity=None, tip_force=force))
    rod = found.rod
    about = {1: 3, 2: 2}[axis]
    lever = BAR.length - found.middles
    moved = float((rod.compliance[:, about, about] * lever**2) @ rod.length) * 1e-3
    bent = found.force.tip - found.force.sheared
    assert bent[axis] == pytest.approx(moved, rel=1e-9)
    stiffest, softest = (f(rod.compliance[:, about, about]) for f in (np.min, np.max))
    cantilever = BAR.length**3 / 3 * 1e-3
    assert stiffest * cantilever < 1.01 * moved < 1.02 * softest * cantilever


def test_small_weight_droops_the_forecast_as_it_droops_the_energy_rung() -> None:
    light = (0.0, 0.0, -0.01)
    scene = Scene(0.0, gravity=light)
    droop = predict(BAR, scene).path[0].tip_displacement
    assert Forecast(BAR, scene).weight.tip == pytest.approx(droop, rel=1e-3, abs=1e-9)


def test_what_is_switched_off_is_no_reason_to_reach_a_plate() -> None:
    """Weight alone carries the slab to the plate: without it, by choice, nothing does."""
    hanging = Scene(10.0, plate=Plate(0.1e-3))
    floating = Scene(10.0, plate=Plate(0.1e-3), gravity=None)
    chosen = hanging.choosing(gravity="off")
    with_weight, without, off = (
        plan(SLAB, scene).by_name["plate_contact"] for scene in (hanging, floating, chosen)
    )
    assert with_weight.on
    assert not without.on
    assert off == without
    pressed = {
        choice: plan(SLAB, hanging.choosing(gravity="off", plate_contact=choice))
        for choice in ("on", "off")
    }
    for choice, decided in pressed.items():
        found = decided.by_name["plate_contact"]
        assert found.on == (choice == "on")
        assert found.change == without.change
        assert without.reason.split(";")[0] in found.reason
    # what gravity would change is told beside the plate that it would press on
    assert plan(SLAB, chosen).by_name["gravity"].change == with_gravity_share(hanging)


def with_gravity_share(scene: Scene) -> float | None:
    return plan(SLAB, scene).by_name["gravity"].change


def test_a_load_is_told_beside_those_that_are_left_in() -> None:
    both = Scene(2e3, tip_force=(0.0, 0.0, 0.02))
    alone = plan(BAR, Scene(2e3)).by_name["gravity"]
    beside = plan(BAR, both).by_name["gravity"]
    off = plan(BAR, both.choosing(tip_force="off")).by_name["gravity"]
    assert off == alone
    assert off.change != beside.change


def test_a_plate_that_is_left_out_takes_nothing_of_the_way() -> None:
    far, near = Scene(20e3, plate=Plate(20e-3)), Scene(20e3, plate=Plate(0.1e-3))
    share = {
        name: plan(BAR, scene).by_name["gravity"].change or 0.0
        for name, scene in {
            "far": far, "near": near, "off": near.choosing(plate_contact="off"),
            "linear": near.choosing(finite_strain="off"),
        }.items()
    }  # fmt: skip
    assert share["near"] > 5 * share["far"]
    assert share["off"] == share["far"] == share["linear"]


@pytest.mark.parametrize("gap", [0.05e-3, 0.5e-3])
def test_the_way_that_a_plate_leaves_is_about_its_gap(gap: float) -> None:
    """A bar freely bends down by 0.85 mm there: a plate holds the tip when it has come to it, and
    so it is where the free rod enters it. The rest is the tip's way along the plate."""
    forecast = Forecast(BAR, Scene(20e3, plate=Plate(gap)))
    assert forecast.travel > 0.8e-3
    assert forecast.travel / narrowing(forecast) == pytest.approx(gap, rel=0.15)
    plate = forecast.scene.plate
    assert plate is not None
    distances = obstacle_distances(forecast, plate)
    assert distances is not None
    assert way_up_to(forecast, distances) == pytest.approx(gap, rel=0.15)


def test_effects_left_out_together_stay_within_the_budget() -> None:
    assert shared_threshold([], 0.025) == 0.025
    assert shared_threshold([0.02], 0.025) == 0.025
    assert shared_threshold([0.02, 0.5], 0.025) == 0.025
    assert shared_threshold([0.01, 0.012], 0.025) == 0.0125
    rng = np.random.default_rng(0)
    for _ in range(200):
        changes = rng.exponential(0.02, size=5)
        left_out = changes[changes <= shared_threshold(changes.tolist(), 0.025)]
        assert left_out.sum() <= 0.025 + 1e-12


def test_a_finer_accuracy_leaves_out_less() -> None:
    scene = Scene(2e3, tip_force=(0.0, 0.0, 1e-4))
    on = [
        {d.name for d in plan(BAR, scene, accuracy).decisions if d.on}
        for accuracy in (0.2, 0.05, 0.01, 0.001)
    ]
    for rough, fine in pairwise(on):
        assert rough <= fine
    assert on[0] != on[-1]


def test_a_line_bent_to_a_circle_comes_back_to_itself() -> None:
    angle = np.linspace(0.0, 2 * np.pi, 80)
    circle = 0.05 * np.stack([np.sin(angle), 0 * angle, np.cos(angle) - 1], axis=-1)
    assert self_clearance(circle, 0.01) < 0.5
    assert self_clearance(circle[:40], 0.01) > 2.0
    assert self_clearance(circle[:2], 0.01) == np.inf


@pytest.mark.parametrize(
    ("more", "field", "said"),
    [
        ({"gravity": None, "effects": {"gravity": "on"}}, "effects.gravity", "none"),
        ({"effects": {"plate_contact": "on"}}, "effects.plate_contact", "no plate"),
        ({"effects": {"cylinder_contact": "on"}}, "effects.cylinder_contact", "no cylinder"),
        ({"effects": {"tip_force": "on"}}, "effects.tip_force", "none"),
        ({"effects": {"outside_pressure": "on"}}, "effects.outside_pressure", "none"),
        ({"effects": {"volume_control": "on"}}, "effects.volume_control", "pressure"),
        ({"effects": {"gravity": "perhaps"}}, "effects.gravity", "'auto'"),
        ({"effects": {"wind": "on"}}, "effects", "wind"),
        ({"effects": {"self_contact": "on"}, "self_contact": "off"}, "self_contact", "once"),
        ({"effects": {"finite_strain": "off", "self_contact": "on"}}, "self_contact", "linear"),
    ],
)
def test_a_choice_without_its_data_is_refused_by_name(
    more: dict[str, Any], field: str, said: str
) -> None:
    with pytest.raises(SceneError, match=said) as refusal:
        Scene(1e3, **more)
    assert refusal.value.field == field
    assert refusal.value.mend


def test_volume_control_cannot_be_left_out_of_a_volume() -> None:
    with pytest.raises(SceneError, match="pressure_kPa") as refusal:
        Scene(volume_to=1e-5, effects={"volume_control": "off"})
    assert refusal.value.field == "effects.volume_control"


def test_choices_that_a_design_cannot_have_are_refused() -> None:
    with pytest.raises(QuestionError, match="no such layer") as refusal:
        plan(SLAB, Scene(1e3, effects={"inextensible_layer": "on"}))
    assert refusal.value.field == "effects.inextensible_layer"
    with pytest.raises(QuestionError, match="mirror image"):
        plan(SLAB, Scene(1e3, gravity=(0, 1, 0), effects={"symmetry": "on"}))


def test_choices_return_from_documents_and_leave_old_digests_alone() -> None:
    forced = Scene(30e3, effects={"gravity": "off", "self_contact": "on", "symmetry": "auto"})
    assert forced.self_contact == "on"
    assert forced.to_document()["effects"] == {"gravity": "off", "self_contact": "on"}
    assert Scene.from_document(forced.to_document()) == forced
    assert forced.digest != Scene(30e3).digest
    assert Scene(30e3, effects={"gravity": "auto"}).digest == Scene(30e3).digest
    assert forced.choosing(gravity="auto", self_contact="auto") == Scene(30e3)
    assert Scene(1e3, self_contact="off") == Scene(1e3, effects={"self_contact": "off"})


def test_instant_rungs_leave_out_what_is_off_and_mark_the_answer() -> None:
    scene = Scene(5e3, plate=Plate(1e-3), effects={"gravity": "off", "plate_contact": "off"})
    found = predict(BAR, scene)
    free = predict(BAR, Scene(5e3, gravity=None))
    assert found.path[-1].tip == free.path[-1].tip
    assert found.scene == scene
    assert [e.name for e in found.effects if e.forced == "off"] == ["gravity", "plate_contact"]
    assert any("Gravity left out by choice" in note and "%" in note for note in found.notes)


def test_the_layer_left_out_of_the_energy_rung_is_the_design_without_it() -> None:
    found = predict(BAR, Scene(5e3, effects={"inextensible_layer": "off"}))
    bare = predict(BAR.changed(layer="none"), Scene(5e3))
    assert found.path[-1].tip == pytest.approx(bare.path[-1].tip)
    assert found.design == BAR


def test_an_obstacle_behind_the_body_is_watched_and_one_in_its_way_is_not() -> None:
    above = Cylinder(5e-3, (20e-3, 0.0, 40e-3))
    below = Cylinder(5e-3, (28e-3, 0.0, -5.05e-3))
    far, near = (plan(SLAB, Scene(4e3, cylinder=c)) for c in (above, below))
    assert far.watched("cylinder_contact")
    assert not far.on("cylinder_contact")
    assert near.on("cylinder_contact")
