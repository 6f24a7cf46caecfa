"""What differs between two designs and their scenes, as a designer reads it."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from actuators.design import FAMILIES
from actuators.mechanics.choices import NAMES
from backend.history.schemas import Change, ParameterPair
from storage import VersionRow

Value = float | str | None


@dataclass(frozen=True)
class Entry:
    """One row of a comparison; values in ``unit``, None where there is none."""

    name: str
    label: str
    unit: str
    left: Value
    right: Value

    @property
    def differs(self) -> bool:
        return self.left != self.right


def changes(before: VersionRow, after: VersionRow) -> list[Change]:
    """Entries that differ from the parent."""
    return [
        Change.model_validate(
            {"name": e.name, "label": e.label, "unit": e.unit, "from": e.left, "to": e.right}
        )
        for e in entries(before, after)
        if e.differs
    ]


def pairs(left: VersionRow, right: VersionRow) -> list[ParameterPair]:
    """Every entry of either side."""
    return [
        ParameterPair(
            name=e.name, label=e.label, unit=e.unit, left=e.left, right=e.right, differs=e.differs
        )
        for e in entries(left, right)
    ]  # fmt: skip


def entries(one: VersionRow, other: VersionRow) -> Iterator[Entry]:
    """Family, parameters in the family's order, then the scene."""
    left, right = one.document, other.document
    scene_left, scene_right = one.scene, other.scene
    families = list(dict.fromkeys([left["family"], right["family"]]))
    yield Entry("family", "Family", "", _title(left["family"]), _title(right["family"]))
    seen: set[str] = set()
    for family in families:
        for p in FAMILIES[family].parameters():
            if p.border_name not in seen:
                seen.add(p.border_name)
                here, there = left.get(p.border_name), right.get(p.border_name)
                yield Entry(p.name, p.label, p.unit, here, there)
    for key, name, label, unit in (
        ("pressure_kPa", "pressure_to", "Pressure up to", "kPa"),
        ("volume_ml", "volume_to", "Volume up to", "ml"),
    ):
        if key in scene_left or key in scene_right:
            here, there = scene_left.get(key, {}), scene_right.get(key, {})
            yield Entry(name, label, unit, here.get("to"), there.get("to"))
    yield Entry("steps", "Steps", "", _steps(scene_left), _steps(scene_right))
    yield Entry("gravity", "Gravity", "m/s2", _gravity(scene_left), _gravity(scene_right))
    for name, (label, unit, read) in _ADDED.items():
        here, there = read(scene_left), read(scene_right)
        if here is not None or there is not None:
            yield Entry(name, label, unit, here, there)


def _title(family: str) -> str:
    return FAMILIES[family].title


def _steps(scene: Mapping[str, Any]) -> Any:
    return (scene.get("pressure_kPa") or scene["volume_ml"])["steps"]


def _gravity(scene: Mapping[str, Any]) -> str:
    gravity = scene["gravity_m_s2"]
    return "none" if gravity is None else _vector(gravity)


def _vector(parts: Sequence[float]) -> str:
    return "(" + ", ".join(f"{part:g}" for part in parts) + ")"


def _tip_force(scene: Mapping[str, Any]) -> Value:
    force = scene.get("tip_force_N")
    return None if force is None else _vector(force)


def _plate(scene: Mapping[str, Any]) -> Value:
    plate = scene.get("plate")
    if plate is None:
        return None
    side = "" if plate["normal"] == [0, 0, 1] else f", normal {_vector(plate['normal'])}"
    return f"{plate['gap_mm']:g} mm away{side}"


def _cylinder(scene: Mapping[str, Any]) -> Value:
    cylinder = scene.get("cylinder")
    if cylinder is None:
        return None
    return (
        f"radius {cylinder['radius_mm']:g} mm at {_vector(cylinder['centre_mm'])} mm, "
        f"axis {_vector(cylinder['axis'])}"
    )


# loads and obstacles that a scene may have, by plain name: label, unit, how it reads
_ADDED: Mapping[str, tuple[str, str, Callable[[Mapping[str, Any]], Value]]] = {
    "outside_pressure": ("Outside pressure", "kPa", lambda s: s.get("outside_pressure_kPa")),
    "tip_force": ("Tip force", "N", _tip_force),
    "plate": ("Plate", "", _plate),
    "cylinder": ("Cylinder", "", _cylinder),
    "self_contact": ("Self-contact", "", lambda s: s.get("effects", {}).get("self_contact")),
    **{
        f"effects.{name}": (
            f"Effect: {name.replace('_', ' ')}",
            "",
            lambda s, name=name: s.get("effects", {}).get(name),
        )
        for name in NAMES
        if name != "self_contact"
    },
}
