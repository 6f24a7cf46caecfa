"""What the effects feature takes and gives."""

from typing import Literal

from pydantic import Field

from backend.documents import Answer, Body, DesignDocument, SceneDocument

EffectName = Literal[
    "gravity", "finite_strain", "hyperelasticity", "self_contact", "plate_contact",
    "cylinder_contact", "outside_pressure", "inextensible_layer", "tip_force", "volume_control",
    "symmetry",
]  # fmt: skip


class EffectsRequest(Body):
    """A question whose effects are to be decided. What the scene's `effects` force is kept."""

    design: DesignDocument
    scene: SceneDocument
    accuracy: float = Field(
        default=0.05, ge=0.001, le=0.5, description="Wanted accuracy as a fraction: 0.05 is 5 %"
    )


class EffectDecision(Answer):
    """One effect: whether a 3D solve of this question has it, and why."""

    name: EffectName
    on: bool
    reason: str = Field(description="One sentence with the estimate and its threshold")
    estimated_change_percent: float | None = Field(
        description="How much leaving it out would change the tip's way [%]; null where nobody "
        "knows, or it changes nothing by itself"
    )
    cost_s: float | None = Field(description="[s]; null before a solve")
    cost_factor: float | None = Field(
        description="Time of a 3D solve with it over the time without; below 1: it saves time"
    )
    forced: Literal["auto", "on", "off"] = Field(description="The scene's own choice")
    watched: bool = Field(
        description="Off, but watched during the solve, and switched on when it is needed"
    )


class EffectDecisions(Answer):
    """Every effect, in a fixed order."""

    accuracy: float = Field(description="Fraction: 0.05 is 5 %")
    threshold_percent: float = Field(
        description="Estimated changes up to here are left out [%]: the share of each in half of "
        "the accuracy"
    )
    effects: list[EffectDecision]
