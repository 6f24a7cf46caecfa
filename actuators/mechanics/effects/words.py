"""How estimates and choices read."""

import math
from dataclasses import replace

from actuators.mechanics.choices import Choice
from actuators.mechanics.effects.decision import Decision


def percent(share: float) -> str:
    """A fraction in words: two digits, and no more than anybody can picture."""
    if not math.isfinite(share) or share > 10.0:
        return "more than 1000 %"
    if share < 1e-4:
        return "less than 0.01 %"
    return f"{100 * share:.2g} %" if share < 1.0 else f"{100 * share:.0f} %"


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
    return f"{what} left out by choice; it would change the tip by about {percent(change)}."
