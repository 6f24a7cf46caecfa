"""What surrounds and loads an actuator: pressure path and gravity."""

import hashlib
import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

from actuators.errors import SceneError

STANDARD_GRAVITY = (0.0, 0.0, -9.81)


@dataclass(frozen=True)
class Scene:
    """Frozen, hashable, in SI.

    ``pressure_to``: end of the path from zero [Pa]; ``steps``: number of equal pressure steps to
    report, or None to let the rung choose; ``gravity``: acceleration [m/s2] applied before
    inflation, or None for none.
    """

    pressure_to: float
    steps: int | None = None
    gravity: tuple[float, float, float] | None = STANDARD_GRAVITY

    def __post_init__(self) -> None:
        if not math.isfinite(self.pressure_to) or not 0 <= self.pressure_to <= 10e6:
            raise SceneError(
                f"pressure is {self.pressure_to / 1e3:g} kPa; it must lie between 0 and 10000 kPa.",
                field="pressure", value=f"{self.pressure_to / 1e3:g} kPa",
                mend="Give a pressure between 0 and 10000 kPa.",
            )  # fmt: skip
        if self.steps is not None and not 1 <= self.steps <= 1000:
            raise SceneError(
                f"steps is {self.steps}; it must lie between 1 and 1000.",
                field="steps", value=str(self.steps), mend="Use 1 to 1000 steps, or auto.",
            )  # fmt: skip
        if self.gravity is not None and not all(
            math.isfinite(g) and abs(g) <= 1e4 for g in self.gravity
        ):
            raise SceneError(
                f"gravity is {self.gravity}; its three components must be finite and at most "
                "10000 m/s2 in size.",
                field="gravity", value=str(self.gravity), mend="Use (0, 0, -9.81) or null.",
            )  # fmt: skip

    @classmethod
    def from_document(cls, document: Mapping[str, Any]) -> "Scene":
        """Read the border form: ``pressure_kPa: {to, steps}``, ``gravity_m_s2``."""
        known = {"pressure_kPa", "gravity_m_s2"}
        for key in document:
            if key not in known:
                raise SceneError(
                    f"{key} is not part of a scene this version can compute. "
                    f"Known: {', '.join(sorted(known))}.",
                    field=key, value=repr(document[key]), mend=f"Remove {key} from the scene.",
                )  # fmt: skip
        pressure = document.get("pressure_kPa")
        if not isinstance(pressure, Mapping) or not _is_number(pressure.get("to")):
            raise SceneError(
                f"pressure_kPa is {pressure!r}; give {{'to': kPa, 'steps': number or 'auto'}}.",
                field="pressure_kPa", value=repr(pressure), mend="For example {'to': 30}.",
            )  # fmt: skip
        steps = pressure.get("steps", "auto")
        if steps in ("auto", None):
            steps = None
        elif isinstance(steps, bool) or not isinstance(steps, int):
            raise SceneError(
                f"steps is {steps!r}; it must be a whole number or 'auto'.",
                field="steps", value=repr(steps), mend="Use a whole number or 'auto'.",
            )  # fmt: skip
        gravity = _read_gravity(document.get("gravity_m_s2", STANDARD_GRAVITY))
        return cls(pressure_to=float(pressure["to"]) * 1e3, steps=steps, gravity=gravity)

    def to_document(self) -> dict[str, Any]:
        """Border form, the inverse of :meth:`from_document`."""
        return {
            "pressure_kPa": {
                "to": float(f"{self.pressure_to / 1e3:.12g}"),
                "steps": "auto" if self.steps is None else self.steps,
            },
            "gravity_m_s2": None if self.gravity is None else list(self.gravity),
        }

    @property
    def digest(self) -> str:
        """sha256 of the document."""
        text = json.dumps(self.to_document(), sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()


def _read_gravity(value: Any) -> tuple[float, float, float] | None:
    if value is None:
        return None
    if isinstance(value, Sequence):
        parts = list(cast("Sequence[Any]", value))
        if len(parts) == 3 and all(_is_number(part) for part in parts):
            return (float(parts[0]), float(parts[1]), float(parts[2]))
    raise SceneError(
        f"gravity_m_s2 is {value!r}; it must be three numbers or null.",
        field="gravity_m_s2", value=repr(value), mend="Use [0, 0, -9.81] or null.",
    )  # fmt: skip


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)
