"""What surrounds and loads an actuator: inflation, gravity, other forces, obstacles."""

import hashlib
import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

from actuators.errors import SceneError
from actuators.mechanics.choices import (
    Choice,
    Choices,
    checked_choices,
    refuse_together,
    refuse_without,
)
from actuators.mechanics.obstacles import Cylinder, Plate, Triple
from actuators.mechanics.scene_document import read_scene, write_scene

__all__ = ["STANDARD_GRAVITY", "Cylinder", "Plate", "Scene"]

STANDARD_GRAVITY = (0.0, 0.0, -9.81)
VACUUM = 101.3e3
"""Largest suction [Pa]: the pressure of the air outside."""
STRONGEST = 10e6
LARGEST_VOLUME = 0.1


@dataclass(frozen=True)
class Scene:
    """Frozen, hashable, in SI. Everything but inflation is applied first.

    Exactly one of ``pressure_to`` and ``volume_to`` says where the path ends: the cavity's pressure
    above the air's [Pa] (below 0: suction), or the whole cavity's volume [m3] (below the volume at
    rest: suction). ``steps``: number of equal steps to report, or None to let the rung choose.
    ``gravity``: acceleration [m/s2], or None for none. ``outside_pressure``: on the underside [Pa],
    stays normal to it. ``tip_force``: dead load spread over the free end [N]. ``effects``: what is
    forced "on" or "off" by name (see :data:`.choices.NAMES`); all else is "auto", for
    :func:`.effects.plan` to decide. ``self_contact`` is kept beside the others: it goes with them
    in documents and in :attr:`forced`.
    """

    pressure_to: float | None = None
    steps: int | None = None
    gravity: Triple | None = STANDARD_GRAVITY
    volume_to: float | None = None
    outside_pressure: float = 0.0
    outside_on: Literal["bottom"] = "bottom"
    tip_force: Triple | None = None
    plate: Plate | None = None
    cylinder: Cylinder | None = None
    self_contact: Choice = "auto"
    effects: Choices | Mapping[str, Choice] = ()

    def __post_init__(self) -> None:
        self._check_inflation()
        _check_vector(self.gravity, "gravity", 1e4, "m/s2", "Use (0, 0, -9.81) or null.")
        _check_vector(self.tip_force, "tip_force", 1e4, "N", "Use for example (0, 0, 0.05).")
        if not abs(self.outside_pressure) <= STRONGEST:
            raise _out_of_range("outside_pressure", self.outside_pressure / 1e3, -1e4, 1e4, "kPa")
        if self.outside_on != "bottom":
            raise SceneError(
                f"outside_on is {self.outside_on!r}; outside pressure acts on the bottom only.",
                field="outside_on", value=repr(self.outside_on), mend="Use 'bottom'.",
            )  # fmt: skip
        self._check_choices()

    def _check_choices(self) -> None:
        chosen = checked_choices(self.effects)
        alone = checked_choices({"self_contact": self.self_contact})
        if alone and chosen.get("self_contact", self.self_contact) != self.self_contact:
            raise SceneError(
                f"self_contact is {self.self_contact!r}, and {chosen['self_contact']!r} among the "
                "effects. Give it once.",
                field="self_contact", value=repr(self.self_contact), mend="Give it once.",
            )  # fmt: skip
        # one place for each: what is forced has one digest, and `replace` one meaning
        object.__setattr__(self, "self_contact", chosen.pop("self_contact", self.self_contact))
        object.__setattr__(self, "effects", tuple(chosen.items()))
        self._refuse_empty_choices()

    def _refuse_empty_choices(self) -> None:
        forced = self.forced
        for name, there, missing, mend in (
            ("gravity", any(self.gravity or ()), "the scene has none", "Give gravity_m_s2."),
            ("plate_contact", self.plate, "the scene has no plate", "Give a plate."),
            ("cylinder_contact", self.cylinder, "the scene has no cylinder", "Give a cylinder."),
            ("outside_pressure", self.outside_pressure, "the scene has none",
             "Give outside_pressure_kPa."),
            ("tip_force", self.tip_force, "the scene has none", "Give tip_force_N."),
            ("volume_control", self.volume_to, "a pressure ends the path",
             "Give volume_ml instead of pressure_kPa."),
        ):  # fmt: skip
            if forced.get(name) == "on" and not there:
                raise refuse_without(name, missing, mend)
        if forced.get("volume_control") == "off" and self.volume_to is not None:
            mend = "Give pressure_kPa instead of volume_ml."
            raise SceneError(
                f"volume control is switched off, but a volume ends the path. {mend}",
                field="effects.volume_control", value="off", mend=mend,
            )  # fmt: skip
        if forced.get("finite_strain") == "off":
            for name in ("self_contact", "plate_contact", "cylinder_contact", "hyperelasticity"):
                if forced.get(name) == "on":
                    why = "one linear solution holds neither contact nor a curved law"
                    raise refuse_together(name, "finite_strain", why)

    @property
    def has_obstacle(self) -> bool:
        """Whether there is a plate or a cylinder."""
        return self.plate is not None or self.cylinder is not None

    @property
    def forced(self) -> dict[str, Choice]:
        """What is not left to the studio, by name."""
        return checked_choices({**dict(self.effects), "self_contact": self.self_contact})

    def choice(self, name: str) -> Choice:
        """How an effect is chosen."""
        return self.forced.get(name, "auto")

    def choosing(self, **choices: Choice) -> "Scene":
        """The same scene with these choices in place of its own."""
        merged = {**self.forced, **choices}
        return replace(self, effects=merged, self_contact=merged.get("self_contact", "auto"))

    def _check_inflation(self) -> None:
        if (self.pressure_to is None) == (self.volume_to is None):
            given = "neither" if self.pressure_to is None else "both"
            raise SceneError(
                f"pressure and volume: {given} given; exactly one of them must end the path.",
                field="pressure", value=given, mend="Give a pressure or a volume.",
            )  # fmt: skip
        if self.pressure_to is not None and not -VACUUM <= self.pressure_to <= STRONGEST:
            raise _out_of_range(
                "pressure", self.pressure_to / 1e3, -VACUUM / 1e3, STRONGEST / 1e3, "kPa"
            )
        if self.volume_to is not None and not 0 < self.volume_to <= LARGEST_VOLUME:
            size = f"{self.volume_to * 1e6:g} ml"
            mend = f"Give a volume above 0 and up to {LARGEST_VOLUME * 1e6:g} ml."
            raise SceneError(
                f"volume is {size}; it must lie above 0 and be at most {LARGEST_VOLUME * 1e6:g} "
                "ml, for it is the whole cavity's.",
                field="volume", value=size, mend=mend,
            )  # fmt: skip
        if self.steps is not None and not 1 <= self.steps <= 1000:
            raise SceneError(
                f"steps is {self.steps}; it must lie between 1 and 1000.",
                field="steps", value=str(self.steps), mend="Use 1 to 1000 steps, or auto.",
            )  # fmt: skip

    @property
    def symmetric(self) -> bool:
        """Whether no load leaves the plane X2 = 0: half a symmetric body then says it all."""
        flat = all(v is None or v[1] == 0.0 for v in (self.gravity, self.tip_force))
        return flat and all(o is None or o.symmetric for o in (self.plate, self.cylinder))

    @classmethod
    def from_document(cls, document: Mapping[str, Any]) -> "Scene":
        """Read the border form: mm, kPa, ml, N; see docs of the command line."""
        return cls(**read_scene(document, STANDARD_GRAVITY))

    def to_document(self) -> dict[str, Any]:
        """Border form, the inverse of :meth:`from_document`; what is at its default is left out."""
        return write_scene(self)

    @property
    def digest(self) -> str:
        """sha256 of the document."""
        text = json.dumps(self.to_document(), sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()


def _check_vector(value: Triple | None, name: str, most: float, unit: str, mend: str) -> None:
    if value is not None and not all(math.isfinite(x) and abs(x) <= most for x in value):
        raise SceneError(
            f"{name} is {value}; its three components must be finite and at most {most:g} {unit} "
            "in size.",
            field=name, value=str(value), mend=mend,
        )  # fmt: skip


def _out_of_range(name: str, value: float, least: float, most: float, unit: str) -> SceneError:
    return SceneError(
        f"{name} is {value:g} {unit}; it must lie between {least:g} and {most:g} {unit}.",
        field=name, value=f"{value:g} {unit}",
        mend=f"Give a {name.replace('_', ' ')} between {least:g} and {most:g} {unit}.",
    )  # fmt: skip
