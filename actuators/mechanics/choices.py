"""Effects that a scene may force on or off, by name."""

from collections.abc import Iterable, Mapping
from typing import Any, Literal, cast

from actuators.errors import SceneError

Choice = Literal["auto", "on", "off"]
Choices = tuple[tuple[str, Choice], ...]

NAMES = (
    "gravity", "finite_strain", "hyperelasticity", "self_contact", "plate_contact",
    "cylinder_contact", "outside_pressure", "inextensible_layer", "tip_force", "volume_control",
    "symmetry",
)  # fmt: skip
"""In the order in which they are listed everywhere."""


def checked_choices(given: Mapping[str, Any] | Iterable[tuple[str, Any]]) -> dict[str, Choice]:
    """Choices by name, those left to the studio ("auto") dropped; raises :class:`SceneError`."""
    named = dict(given)
    for name, choice in named.items():
        if name not in NAMES:
            raise SceneError(
                f"effects names {name!r}; an effect that can be chosen is one of "
                f"{', '.join(NAMES)}.",
                field="effects", value=repr(name), mend=f"Remove {name} from the effects.",
            )  # fmt: skip
        if choice not in ("auto", "on", "off"):
            raise SceneError(
                f"{name} is {choice!r}; it must be 'auto', 'on' or 'off'.",
                field=field_of(name), value=repr(choice), mend="Use 'auto', 'on' or 'off'.",
            )  # fmt: skip
    return {
        name: cast("Choice", named[name]) for name in NAMES if named.get(name, "auto") != "auto"
    }


def field_of(name: str) -> str:
    """The field that a refusal of this choice names."""
    return "self_contact" if name == "self_contact" else f"effects.{name}"


def refuse_without(name: str, missing: str, mend: str) -> SceneError:
    """``name`` is forced on, but there is nothing it could be."""
    return SceneError(
        f"{name.replace('_', ' ')} is switched on, but {missing}. {mend}",
        field=field_of(name), value="on", mend=mend,
    )  # fmt: skip


def refuse_together(name: str, other: str, why: str) -> SceneError:
    """``name`` is forced on while ``other``, which it needs, is forced off."""
    mend = f"Leave {name} or {other} to 'auto'."
    return SceneError(
        f"{name.replace('_', ' ')} is switched on and {other.replace('_', ' ')} off: {why}. {mend}",
        field=field_of(name), value="on", mend=mend,
    )  # fmt: skip
