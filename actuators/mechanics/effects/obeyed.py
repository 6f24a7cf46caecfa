"""What the instant rungs make of choices: they leave out what is off, refuse what they cannot
switch on, and mark the answer."""

from dataclasses import replace

from actuators.design import Design
from actuators.errors import QuestionError
from actuators.mechanics.choices import field_of
from actuators.mechanics.effects.afterwards import LOADS
from actuators.mechanics.effects.contacts import self_contact
from actuators.mechanics.effects.expected import Expectations
from actuators.mechanics.effects.forecast import Forecast, without_layer
from actuators.mechanics.effects.words import left_out_note
from actuators.mechanics.response import Effect, Response
from actuators.mechanics.scene import Scene

BEYOND = ("finite_strain", "hyperelasticity", "self_contact")
"""Effects that no rung of small strains has."""
INFLATED = ("finite_strain", "hyperelasticity", "self_contact")
"""Those of them that the inflated cell has."""
_LOADS = {
    "gravity": "gravity", "outside_pressure": "outside_pressure", "tip_force": "tip_force",
    "plate_contact": "plate", "cylinder_contact": "cylinder",
}  # fmt: skip
"""Effects that are a load or an obstacle of the scene, with its name there."""


def obeyed(design: Design, scene: Scene, rung: str) -> tuple[Design, Scene]:
    """The question that is left when what the scene switches off is gone. Raises
    :class:`QuestionError` for an effect switched on that ``rung`` does not have."""
    for name in BEYOND:
        if scene.choice(name) == "on" and not (rung == "cell-rod" and name in INFLATED):
            mend = f"Use the rung fe, or leave {name} to 'auto'."
            raise QuestionError(
                f"{name.replace('_', ' ')} is switched on, which the rung {rung} does not have. "
                f"{mend}",
                field=field_of(name), value="on", mend=mend,
            )  # fmt: skip
    kept = replace(
        without_loads_off(scene),
        effects=(),
        # only an inflated cell has walls that meet
        self_contact="off" if rung == "cell-rod" and scene.self_contact == "off" else "auto",
    )
    loose = without_layer(design) if scene.choice("inextensible_layer") == "off" else None
    return loose or design, kept


def without_loads_off(scene: Scene) -> Scene:
    """The scene less the loads and obstacles that it switches off."""
    off = {field for name, field in _LOADS.items() if scene.choice(name) == "off"}
    return replace(
        scene,
        gravity=None if "gravity" in off else scene.gravity,
        outside_pressure=0.0 if "outside_pressure" in off else scene.outside_pressure,
        tip_force=None if "tip_force" in off else scene.tip_force,
        plate=None if "plate" in off else scene.plate,
        cylinder=None if "cylinder" in off else scene.cylinder,
    )


def marked(response: Response, design: Design, scene: Scene) -> Response:
    """The answer with the question as it was asked, and a note on what was left out by choice."""
    left_out = _left_out(design, scene, response.rung)
    others = [effect for effect in response.effects if effect.name not in left_out]
    chosen = [effect for effect, _ in left_out.values()]
    notes = [note for _, note in left_out.values()]
    return replace(
        response, design=design, scene=scene, effects=(*chosen, *others),
        notes=(*response.notes, *notes),
    )  # fmt: skip


def _left_out(design: Design, scene: Scene, rung: str) -> dict[str, tuple[Effect, str]]:
    """Effect and note by name of everything that is there and switched off."""
    found: dict[str, tuple[Effect, str]] = {}
    expected = Expectations(design, scene)
    for name in ("gravity", "outside_pressure", "tip_force", "plate_contact", "cylinder_contact",
                 "inextensible_layer", "self_contact"):  # fmt: skip
        if scene.choice(name) != "off" or not _there(name, design, scene, rung):
            continue
        change = _change(name, expected)
        percent = None if change is None else 100.0 * change
        effect = Effect(
            name, False, "left out by choice", estimated_change_percent=percent, forced="off"
        )
        found[name] = effect, left_out_note(name, change)
    return found


def _there(name: str, design: Design, scene: Scene, rung: str) -> bool:
    if name == "self_contact":  # rungs of small strains say for themselves that they have none
        return rung == "cell-rod" and Forecast(design, scene).row.gap_closing != 0.0
    if name == "inextensible_layer":
        return without_layer(design) is not None
    if name == "gravity":
        return any(scene.gravity or ())
    return bool(getattr(scene, _LOADS[name]))


def _change(name: str, expected: Expectations) -> float | None:
    if name in LOADS:
        return expected.of_load(name)[0]
    if name == "inextensible_layer":
        return expected.of(name).layer_share
    return self_contact(expected.of(name)).change if name == "self_contact" else None
