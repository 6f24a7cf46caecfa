"""A scene in its border form: a JSON object in kPa, ml, mm and N."""

import difflib
import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from actuators.errors import SceneError
from actuators.mechanics.choices import NAMES, checked_choices
from actuators.mechanics.obstacles import Cylinder, Plate, Triple

if TYPE_CHECKING:
    from actuators.mechanics.scene import Scene

_KNOWN = (
    "pressure_kPa", "volume_ml", "gravity_m_s2", "outside_pressure_kPa", "outside_on",
    "tip_force_N", "plate", "cylinder", "effects",
)  # fmt: skip


def read_scene(document: Mapping[str, Any], gravity: Triple) -> dict[str, Any]:
    """Arguments of a scene. ``gravity``: where the document says nothing about it."""
    _only(document, _KNOWN, "a scene")
    if "pressure_kPa" in document and "volume_ml" in document:
        raise SceneError(
            "pressure_kPa and volume_ml are both given; exactly one of them must end the path.",
            field="volume_ml", value=repr(document["volume_ml"]), mend="Remove one of the two.",
        )  # fmt: skip
    if "volume_ml" in document:
        end, steps = _inflation(document, "volume_ml", "ml", 40)
        found: dict[str, Any] = {"volume_to": end * 1e-6, "steps": steps}
    else:
        end, steps = _inflation(document, "pressure_kPa", "kPa", 30)
        found = {"pressure_to": end * 1e3, "steps": steps}
    found["gravity"] = _vector(document, "gravity_m_s2", "[0, 0, -9.81] or null", gravity)
    force = _vector(document, "tip_force_N", "[0, 0, 0.05]", None)
    found["tip_force"] = force if force is not None and any(force) else None
    found["outside_pressure"] = 1e3 * _number(document, "outside_pressure_kPa", 0.0)
    found["outside_on"] = document.get("outside_on", "bottom")
    found["plate"] = _plate(document.get("plate"))
    found["cylinder"] = _cylinder(document.get("cylinder"))
    found["effects"] = checked_choices(_object(document, "effects", NAMES) or {})
    return found


def write_scene(scene: "Scene") -> dict[str, Any]:
    """Border form; what is at its default is left out."""
    document: dict[str, Any] = {}
    steps = "auto" if scene.steps is None else scene.steps
    if scene.pressure_to is not None:
        document["pressure_kPa"] = {"to": _border(scene.pressure_to, 1e-3), "steps": steps}
    if scene.volume_to is not None:
        document["volume_ml"] = {"to": _border(scene.volume_to, 1e6), "steps": steps}
    document["gravity_m_s2"] = None if scene.gravity is None else list(scene.gravity)
    if scene.outside_pressure != 0.0:
        document["outside_pressure_kPa"] = _border(scene.outside_pressure, 1e-3)
    if scene.outside_on != "bottom":
        document["outside_on"] = scene.outside_on
    if scene.tip_force is not None:
        document["tip_force_N"] = [_border(x, 1.0) for x in scene.tip_force]
    if scene.plate is not None:
        document["plate"] = {
            "gap_mm": _border(scene.plate.gap, 1e3),
            "normal": [_border(x, 1.0) for x in scene.plate.normal],
        }
    if scene.cylinder is not None:
        document["cylinder"] = {
            "radius_mm": _border(scene.cylinder.radius, 1e3),
            "centre_mm": [_border(x, 1e3) for x in scene.cylinder.centre],
            "axis": [_border(x, 1.0) for x in scene.cylinder.axis],
        }
    if scene.forced:
        document["effects"] = dict(scene.forced)
    return document


def _border(value: float, factor: float) -> float:
    return float(f"{value * factor:.12g}") + 0.0


def _inflation(
    document: Mapping[str, Any], key: str, unit: str, example: float
) -> tuple[float, int | None]:
    given = document.get(key)
    if not isinstance(given, Mapping) or not _is_number(given.get("to")):
        mend = f'Write for example "{key}": {{"to": {example:g}}}.'
        what = "is missing" if given in (None, {}) else f"is {json.dumps(given, default=str)}"
        raise SceneError(
            f"{key} {what}; it must say where the path ends, in {unit}. {mend}",
            field=key, value=repr(given), mend=mend,
        )  # fmt: skip
    steps = given.get("steps", "auto")
    if steps in ("auto", None):
        return float(given["to"]), None
    if isinstance(steps, bool) or not isinstance(steps, int):
        raise SceneError(
            f"steps is {steps!r}; it must be a whole number or 'auto'.",
            field="steps", value=repr(steps), mend="Use a whole number or 'auto'.",
        )  # fmt: skip
    return float(given["to"]), steps


def _plate(given: Any) -> Plate | None:
    entry = _object({"plate": given}, "plate", ("gap_mm", "normal"))
    if entry is None:
        return None
    normal = _vector(entry, "normal", "[0, 0, 1]", (0.0, 0.0, 1.0), "plate.")
    return Plate(
        gap=_number(entry, "gap_mm", None, "plate.") * 1e-3, normal=normal or (0.0, 0.0, 1.0)
    )


def _cylinder(given: Any) -> Cylinder | None:
    entry = _object({"cylinder": given}, "cylinder", ("radius_mm", "centre_mm", "axis"))
    if entry is None:
        return None
    centre = _vector(entry, "centre_mm", "[60, 0, -25]", None, "cylinder.")
    if centre is None:
        raise SceneError(
            "cylinder.centre_mm is missing; give a point on the cylinder's axis, three numbers.",
            field="cylinder.centre_mm", mend="Use for example [60, 0, -25].",
        )  # fmt: skip
    axis = _vector(entry, "axis", "[0, 1, 0]", (0.0, 1.0, 0.0), "cylinder.")
    return Cylinder(
        radius=_number(entry, "radius_mm", None, "cylinder.") * 1e-3,
        centre=(centre[0] * 1e-3, centre[1] * 1e-3, centre[2] * 1e-3),
        axis=axis or (0.0, 1.0, 0.0),
    )


def _object(
    document: Mapping[str, Any], key: str, known: Sequence[str]
) -> Mapping[str, Any] | None:
    given = document.get(key)
    if given is None:
        return None
    if not isinstance(given, Mapping):
        raise SceneError(
            f"{key} is {given!r}; it must be an object with {', '.join(known)}.",
            field=key, value=repr(given), mend=f"Give an object, or leave {key} out.",
        )  # fmt: skip
    entry = cast("Mapping[str, Any]", given)
    _only(entry, known, f"the {key} of a scene")
    return entry


def _only(document: Mapping[str, Any], known: Sequence[str], where: str) -> None:
    for key in document:
        if key not in known:
            near = difflib.get_close_matches(key, known, n=1, cutoff=0.5)
            mend = f"Did you mean {near[0]}?" if near else f"Remove {key} from the scene."
            raise SceneError(
                f"{key} is not part of {where} this version can compute. {mend} "
                f"Known: {', '.join(sorted(known))}.",
                field=key, value=repr(document[key]), mend=mend,
            )  # fmt: skip


def _number(
    document: Mapping[str, Any], key: str, default: float | None, prefix: str = ""
) -> float:
    value = document.get(key, default)
    if not _is_number(value):
        raise SceneError(
            f"{prefix}{key} is {value!r}; it must be a number.",
            field=prefix + key, value=repr(value), mend=f"Give a number for {key}.",
        )  # fmt: skip
    return float(value)


def _vector(
    document: Mapping[str, Any], key: str, example: str, default: Triple | None, prefix: str = ""
) -> Triple | None:
    value = document.get(key, default)
    if value is None:
        return None
    if isinstance(value, Sequence):
        parts = list(cast("Sequence[Any]", value))
        if len(parts) == 3 and all(_is_number(part) for part in parts):
            return (float(parts[0]), float(parts[1]), float(parts[2]))
    raise SceneError(
        f"{prefix}{key} is {value!r}; it must be three numbers"
        f"{' or null' if 'null' in example else ''}.",
        field=prefix + key, value=repr(value), mend=f"Use {example}.",
    )  # fmt: skip


def _is_number(value: Any) -> bool:
    """Whether it is a number that a float can hold; infinity is left to the checks of range."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return False
    return isinstance(value, float) or abs(value) < 1e300
