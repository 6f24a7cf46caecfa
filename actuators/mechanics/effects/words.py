"""How estimates and choices read."""

import math
from dataclasses import replace

from actuators.mechanics.choices import Choice
from actuators.mechanics.effects.decision import Decision
from actuators.quantities import about


def forced(estimate: Decision, choice: Choice) -> Decision:
    """The scene's own choice in place of an estimate's."""
    if choice == "on":
        return replace(estimate, on=True, forced="on",
                       reason=f"switched on in the scene; {estimate.reason}")  # fmt: skip
    return replace(estimate, on=False, forced="off",
                   reason=f"left out by choice; {estimate.reason}")  # fmt: skip


def left_out_note(name: str, change: float | None) -> str:
    """What an answer says about an effect that its scene leaves out."""
    what = name.replace("_", " ").capitalize()
    if change is None or not math.isfinite(change):
        return f"{what} left out by choice."
    return f"{what} left out by choice; it would change the tip by {about(change)}."
