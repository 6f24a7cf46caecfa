"""Loads left out by an estimate are looked at again on the shape that was found."""

from dataclasses import replace

import numpy as np
import pytest

from actuators.design import preset
from actuators.mechanics.effects import EffectPlan, checked, plan
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Scene

DESIGN = preset("printed-14").design
LOADS = {
    "tip_force": {"tip_force": (0.0, 0.0, -2e-3)},
    "outside_pressure": {"outside_pressure": 2.0},
    "gravity": {"gravity": (0.0, 0.0, -0.1)},
}


def found_without(name: str) -> tuple[EffectPlan, Response, float]:
    """The plan that leaves a small load out, the shape without it, and how far the load moves the
    rod's tip in truth, over its way."""
    whole = Scene(20e3, steps=2, **{"gravity": None, **LOADS[name]})  # pyright: ignore[reportArgumentType]
    bare = Scene(20e3, steps=2, gravity=None)
    chosen, answer = plan(DESIGN, whole), predict(DESIGN, bare)
    tips = [np.array(predict(DESIGN, scene).path[-1].tip) for scene in (whole, bare)]
    way = float(np.linalg.norm(answer.path[-1].tip_displacement))
    effects = tuple(e for e in answer.effects if e.name != name)
    from_plan = predict(DESIGN, bare.choosing()).effects[0]
    shown = replace(from_plan, name=name, on=False, reason="left out")
    return (
        chosen,
        replace(answer, effects=(shown, *effects)),
        float(np.linalg.norm(tips[0] - tips[1])) / way,
    )


@pytest.mark.parametrize("name", LOADS)
def test_what_is_left_out_is_estimated_on_the_shape_found(name: str) -> None:
    chosen, answer, true = found_without(name)
    assert not chosen.on(name)
    again = checked(answer, chosen)
    effect = next(effect for effect in again.effects if effect.name == name)
    assert effect.estimated_change_percent == pytest.approx(100 * true, rel=0.35)
    assert "checked afterwards" in effect.reason
    assert again.notes == answer.notes


def test_a_load_that_should_not_have_been_left_out_is_marked() -> None:
    chosen, answer, true = found_without("tip_force")
    again = checked(answer, replace(chosen, threshold=true / 2))
    assert any("Switch it on" in note for note in again.notes)
