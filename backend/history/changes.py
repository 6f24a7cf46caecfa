"""What differs between two designs and their scenes, as a designer reads it."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from actuators.design import FAMILIES
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


def _title(family: str) -> str:
    return FAMILIES[family].title


def _steps(scene: Mapping[str, Any]) -> Any:
    return (scene.get("pressure_kPa") or scene["volume_ml"])["steps"]


def _gravity(scene: Mapping[str, Any]) -> str:
    gravity = scene["gravity_m_s2"]
    return "none" if gravity is None else "(" + ", ".join(f"{g:g}" for g in gravity) + ")"
