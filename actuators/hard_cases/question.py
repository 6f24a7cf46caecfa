"""From a case to the questions that it asks: its own, and those that it is compared with."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from actuators.design import Design, parse_design, preset
from actuators.hard_cases.case import Case, Scaling, Variation
from actuators.mechanics.scene import Scene

SEED = 20260521
"""Of disturbances and orders: the same on every machine."""


@dataclass(frozen=True)
class Question:
    """What is asked, of which rung, on which mesh."""

    design: Design
    scene: Scene
    rung: str
    mesh: str | None = None
    accuracy: float | None = None
    shuffled: bool = False
    threads: int | None = None


def question(case: Case, like: Variation | None = None) -> Question:
    """The question of ``case``, or of what one of its checks compares it with. Raises
    :class:`InputError` for a design or a scene that is none."""
    like = like or Variation()
    asked = Question(
        design=read_design({**case.design, **like.design}),
        scene=Scene.from_document(_without_nulls({**case.scene, **like.scene})),
        rung=like.rung or case.rung,
        mesh=like.mesh or case.mesh,
        accuracy=case.accuracy,
        shuffled=like.shuffled,
        threads=like.threads,
    )
    if like.disturbed:
        asked = _disturbed(asked, like.disturbed)
    if like.scaled is not None:
        asked = _scaled(asked, like.scaled)
    return asked


def _without_nulls(scene: Mapping[str, Any]) -> dict[str, Any]:
    """A scene's document without what is left out by null: for gravity alone null says something
    else than nothing."""
    return {k: v for k, v in scene.items() if v is not None or k == "gravity_m_s2"}


def read_design(entry: Mapping[str, Any]) -> Design:
    """A preset with changes, or a whole document."""
    changes = dict(entry)
    if "family" in changes:
        return parse_design(changes)
    return preset(changes.pop("preset")).design.changed(**changes)


def _disturbed(asked: Question, size: float) -> Question:
    rng = np.random.default_rng(SEED)

    def off(value: float) -> float:
        return value * (1 + size * rng.uniform(-1, 1))

    design, scene = asked.design, asked.scene
    lengths = {p.name: off(getattr(design, p.name)) for p in design.parameters()
               if p.kind == "length"}  # fmt: skip
    # past the documents, which round to twelve digits
    values: dict[str, Any] = {**design.model_dump(), **lengths}
    design = type(design)(**values)
    loads = {name: off(value) for name in ("pressure_to", "volume_to", "outside_pressure")
             if (value := getattr(scene, name)) is not None}  # fmt: skip
    return replace(asked, design=design, scene=replace(scene, **loads))


def _scaled(asked: Question, scaling: Scaling) -> Question:
    """In other units; past the limits of a design, which are a designer's and no model's."""
    design = asked.design
    values: dict[str, Any] = {}
    for p in design.parameters():
        value = getattr(design, p.name)
        if p.kind == "length":
            values[p.name] = scaling.length * value
        elif p.kind == "material":
            values[p.name] = stiffer(value, scaling.modulus)
    return replace(
        asked, design=design.model_copy(update=values), scene=scaled_scene(asked.scene, scaling)
    )


def stiffer(material: str, factor: float) -> str:
    """Key of the material ``factor`` times as stiff."""
    return material if factor == 1.0 else f"{material}@stiffness={factor!r}"


def scaled_scene(scene: Scene, scaling: Scaling) -> Scene:
    """Loads that leave the shape of a scaled body as it was: pressures as moduli, forces as moduli
    times areas, weight (of an unchanged density) by another gravity."""
    s, m = scaling.length, scaling.modulus

    def vector(value: tuple[float, ...] | None, factor: float) -> Any:
        return None if value is None else tuple(factor * x for x in value)

    def number(value: float | None, factor: float) -> Any:
        return None if value is None else factor * value

    return replace(
        scene,
        pressure_to=number(scene.pressure_to, m),
        volume_to=number(scene.volume_to, s**3),
        outside_pressure=m * scene.outside_pressure,
        gravity=vector(scene.gravity, m / s),
        tip_force=vector(scene.tip_force, m * s**2),
        plate=scene.plate and replace(scene.plate, gap=s * scene.plate.gap),
        cylinder=scene.cylinder and replace(
            scene.cylinder, radius=s * scene.cylinder.radius,
            centre=vector(scene.cylinder.centre, s),
        ),
    )  # fmt: skip
