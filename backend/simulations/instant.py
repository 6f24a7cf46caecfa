"""The rungs that answer while a slider moves."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

from actuators.design import PRESETS, Design
from actuators.errors import QuestionError
from actuators.mechanics.choices import Choice
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Response
from actuators.mechanics.scene import STRONGEST, Scene

InstantRung = Literal["closed-form", "energy", "cell-rod"]


def answer(
    design: Design,
    scene: Scene,
    *,
    rung: InstantRung = "energy",
    c: Literal["computed", "published"] | float = "computed",
) -> Response:
    """Response of an instant rung; raises InputError for a question it cannot answer."""
    return predict(design, scene, rung=rung, c=c)


@dataclass(frozen=True)
class LeftOut:
    """A load that a rung cannot carry. ``reason``: the rung's own words."""

    field: str
    reason: str


# what takes a load out of a scene, by the field that a rung's refusal names
_WITHOUT: Mapping[str, Mapping[str, Any]] = {
    "outside_pressure": {"outside_pressure": 0.0},
    "tip_force": {"tip_force": None},
    "plate": {"plate": None},
    "cylinder": {"cylinder": None},
    "self_contact": {"self_contact": "auto"},
}


def answer_in_part(
    design: Design,
    scene: Scene,
    *,
    rung: InstantRung = "energy",
    c: Literal["computed", "published"] | float = "computed",
) -> tuple[Response, tuple[LeftOut, ...]]:
    """Response to the scene without the loads that the rung cannot carry, and which these are.

    A volume to reach is replaced by the pressure at which the rung's own cavity has it. Raises
    InputError where nothing can be left out, or nothing would be left.
    """
    left_out: list[LeftOut] = []
    while True:
        try:
            return answer(design, scene, rung=rung, c=c), tuple(left_out)
        except QuestionError as refusal:
            scene, chosen = _freed(scene, refusal.field), scene.forced
            if refusal.field in _WITHOUT:
                scene = replace(scene, **_WITHOUT[refusal.field])
            elif refusal.field == "volume" and scene.volume_to is not None:
                pressure = _pressure_at_volume(design, scene.volume_to, rung, c)
                if pressure is None:
                    raise
                scene = replace(scene, volume_to=None, pressure_to=pressure)
            elif scene.forced == chosen:
                raise
            left_out.append(LeftOut(refusal.field, str(refusal)))


def _freed(scene: Scene, field: str) -> Scene:
    """The scene without the choice that forces this field on."""
    plain = field.removeprefix("effects.")
    names = {plain, f"{plain}_contact", f"{plain}_control"} & set(scene.forced)
    free: dict[str, Choice] = dict.fromkeys(names, "auto")
    return scene.choosing(**free) if names else scene


def _pressure_at_volume(design: Design, volume: float, rung: InstantRung, c: Any) -> float | None:
    """Pressure [Pa] at which a rung of linear cavity compliance has ``volume`` [m3]; None below the
    volume at rest, beyond any pressure, or where the rung knows no volume."""
    probe = Scene(pressure_to=1e3, steps=1, gravity=None)
    first, last = (point.cavity_volume for point in answer(design, probe, rung=rung, c=c).path)
    if first is None or last is None or last <= first or volume <= first:
        return None
    pressure = 1e3 * (volume - first) / (last - first)
    return pressure if pressure <= STRONGEST else None


def warm() -> None:
    """Answer one question, so that the first one asked finds compiled kernels in memory."""
    first = next(iter(PRESETS.values()))
    answer(first.design, Scene(first.pressure_to))
