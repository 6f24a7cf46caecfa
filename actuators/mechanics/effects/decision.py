"""What was decided about each physical effect of a question, and why."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from actuators.design import Design
from actuators.mechanics.choices import Choice
from actuators.mechanics.scene import Scene


@dataclass(frozen=True)
class Decision:
    """One effect: ``on`` or off, with a ``reason`` in one sentence.

    ``change``: estimated change of the tip's way that leaving it out makes, as a fraction; None
    where it changes nothing by itself or nobody knows. ``cost_factor``: time of a 3D solve with it
    over the time without, measured. ``forced``: "auto" where the studio decided. ``watched``: off,
    but switched on by itself when the run comes to need it.
    """

    name: str
    on: bool
    reason: str
    change: float | None = None
    cost_factor: float | None = None
    forced: Choice = "auto"
    watched: bool = False

    def to_document(self) -> dict[str, Any]:
        """Border form, as an effect of a response."""
        known = self.change is not None and math.isfinite(self.change)
        return {
            "name": self.name, "on": self.on, "reason": self.reason,
            "estimated_change_percent": 100.0 * (self.change or 0.0) if known else None,
            "cost_s": None, "cost_factor": self.cost_factor, "forced": self.forced,
            "watched": self.watched,
        }  # fmt: skip


@dataclass(frozen=True, eq=False)
class EffectPlan:
    """Decisions in the order of :data:`.choices.NAMES`. ``threshold``: change of the tip's way, as
    a fraction, below which an effect was left out; ``pressure``: where the path is expected to end
    [Pa]; ``rotation_per_way``: what small rotations miss of the tip's way, over that way [1/m]."""

    design: Design
    scene: Scene
    accuracy: float
    threshold: float
    pressure: float
    rotation_per_way: float
    decisions: tuple[Decision, ...]

    @property
    def by_name(self) -> Mapping[str, Decision]:
        """Decisions by name."""
        return {decision.name: decision for decision in self.decisions}

    def on(self, name: str) -> bool:
        """Whether an effect is part of the model."""
        return self.by_name[name].on

    def watched(self, name: str) -> bool:
        """Whether an effect that is off is watched for."""
        return self.by_name[name].watched

    def switched_on(self, name: str, words: str, *, change: float | None = None) -> "EffectPlan":
        """The plan after a run found that it needs ``name``."""
        old = self.by_name[name]
        new = replace(
            old, on=True, watched=False, reason=words,
            change=old.change if change is None else change,
        )  # fmt: skip
        decisions = tuple(new if d.name == name else d for d in self.decisions)
        return replace(self, decisions=decisions)

    def found_to_change(self, name: str, change: float) -> "EffectPlan":
        """The plan after a run found what leaving ``name`` out changes: better known now."""
        decisions = tuple(
            replace(d, change=change) if d.name == name else d for d in self.decisions
        )
        return replace(self, decisions=decisions)

    def nonlinear(self, words: str) -> "EffectPlan":
        """The plan after one linear solution was not enough: with the materials' own laws."""
        again = self.switched_on("finite_strain", words)
        law = self.by_name["hyperelasticity"]
        if law.change and law.forced == "auto" and law.change > self.threshold:
            again = again.switched_on("hyperelasticity", "switched on with finite strain")
        return again

    @property
    def applied(self) -> Scene:
        """The scene that is left to compute: loads and obstacles of what is off are gone, every
        choice is made."""
        scene, on = self.scene, self.on
        return Scene(
            pressure_to=scene.pressure_to,
            steps=scene.steps,
            gravity=scene.gravity if on("gravity") else None,
            volume_to=scene.volume_to,
            outside_pressure=scene.outside_pressure if on("outside_pressure") else 0.0,
            outside_on=scene.outside_on,
            tip_force=scene.tip_force if on("tip_force") else None,
            plate=scene.plate if on("plate_contact") else None,
            cylinder=scene.cylinder if on("cylinder_contact") else None,
            effects={d.name: "on" if d.on else "off" for d in self.decisions},
        )

    def to_document(self) -> dict[str, Any]:
        """Border form."""
        return {
            "accuracy": self.accuracy,
            "threshold_percent": 100.0 * self.threshold,
            "effects": [decision.to_document() for decision in self.decisions],
        }
