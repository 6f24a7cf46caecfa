"""Whether surfaces are expected to meet: walls of neighbouring chambers, the body and an obstacle,
the curled-up end and the rest."""

from dataclasses import replace

from actuators.mechanics.effects.decision import Decision
from actuators.mechanics.effects.forecast import Forecast
from actuators.mechanics.effects.reach import obstacle_distances, rod_clearance
from actuators.quantities import percent

OBSTACLES = ("plate_contact", "cylinder_contact")
CLOSED = 0.7
"""Share of a gap that the linear cell closes beyond which walls are expected to meet."""
PRESSED_APART = 0.2
"""Change of the tip by walls that push each other, where they would close their gap many times
over."""
NEAR = 1.0
"""Clearance of a curling rod, in thicknesses, below which it is expected to meet itself."""
COST_SELF_CONTACT, COST_OBSTACLE = 1.1, 1.05
"""Time of a 3D solve that looks for contact over one that does not; more where there is some."""
REACHED = 0.7
"""Share of the way to an obstacle that the rod covers beyond which it is expected to touch."""
WATCHED = "it is watched, and switches itself on when they meet"


def self_contact(forecast: Forecast) -> Decision:
    """Of neighbouring walls by the linear cell, of a body that curls up by the rod."""
    closed = forecast.row.gap_closing * forecast.pressure
    clearance = rod_clearance(forecast)
    if closed > CLOSED:
        change = PRESSED_APART * max(1.0 - 1.0 / closed, 0.0)
        reason = (
            f"neighbouring walls are expected to close {percent(closed)} of the gap between them"
        )
        return _contact("self_contact", reason, change, COST_SELF_CONTACT)
    if clearance is None or clearance < NEAR:
        reason = "the body is expected to curl up onto itself"
        return _contact("self_contact", reason, None, COST_SELF_CONTACT)
    if closed > 0.0:
        reason = (
            f"neighbouring walls are expected to close {percent(closed)} of the gap between them, "
            f"less than {percent(CLOSED)}; {WATCHED}"
        )
    elif forecast.row.gap_closing != 0.0:
        reason = f"the gaps between neighbouring walls widen; {WATCHED}"
    else:
        reason = f"no walls face each other, and the body does not curl up that far; {WATCHED}"
    return replace(_contact("self_contact", reason, 0.0, COST_SELF_CONTACT), on=False, watched=True)


def obstacle_contact(forecast: Forecast, name: str) -> Decision:
    """Of the body with the scene's plate or cylinder, by the rod."""
    word = name.removesuffix("_contact")
    scene = forecast.scene
    obstacle = scene.plate if name == "plate_contact" else scene.cylinder
    if obstacle is None:
        return Decision(name, False, f"the scene has no {word}")
    distance = obstacle_distances(forecast, obstacle)
    if distance is None:
        reason = "the instant model does not say how far the body comes"
        return _contact(name, reason, None, COST_OBSTACLE)
    at_rest, least = float(distance[0]), float(distance.min())
    if at_rest - least < REACHED * at_rest:
        reason = (
            f"the body is expected to stay {least * 1e3:.2g} mm away from the {word} "
            f"({at_rest * 1e3:.2g} mm at rest); {WATCHED}"
        )
        return replace(_contact(name, reason, 0.0, COST_OBSTACLE), on=False, watched=True)
    if least < 0.0 and forecast.travel > 0.0:
        reason = f"freely the body would move {-least * 1e3:.2g} mm beyond the {word}'s surface"
        return _contact(name, reason, -least / forecast.travel, COST_OBSTACLE)
    reason = f"the body is expected to come within {least * 1e3:.2g} mm of the {word}"
    if least <= 0.0:
        reason = f"the body is expected to touch the {word}"
    return _contact(name, reason, None, COST_OBSTACLE)


def _contact(name: str, reason: str, change: float | None, cost: float) -> Decision:
    return Decision(name, True, reason, change=change, cost_factor=cost)
