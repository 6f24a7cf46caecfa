"""What surrounds and loads an actuator: inflation, gravity, other forces, obstacles."""

import hashlib
import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from actuators.errors import SceneError
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
    stays normal to it. ``tip_force``: dead load spread over the free end [N]. ``self_contact``:
    "auto" looks for walls that meet, "on" and "off" say it.
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
    self_contact: Literal["auto", "on", "off"] = "auto"

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
        if self.self_contact not in ("auto", "on", "off"):
            raise SceneError(
                f"self_contact is {self.self_contact!r}; it must be 'auto', 'on' or 'off'.",
                field="self_contact", value=repr(self.self_contact),
                mend="Use 'auto', 'on' or 'off'.",
            )  # fmt: skip

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
            raise _out_of_range("volume", self.volume_to * 1e6, 0, LARGEST_VOLUME * 1e6, "ml")
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
