"""What a designer must read about contact."""

from collections.abc import Sequence

import numpy as np

from actuators.mechanics.continuum.contact.report import ContactReport, Touching
from actuators.mechanics.response import Effect, PathPoint
from actuators.mechanics.scene import Scene


def contact_effects(
    scene: Scene, points: Sequence[PathPoint], report: ContactReport, overlap: str | None
) -> tuple[Effect, ...]:
    """Contact of the body with itself, and with the scene's obstacles. ``overlap``: a note on walls
    that ran into each other where contact was left out."""
    found = [_itself(scene, points, report.itself, overlap)]
    if report.plate is not None:
        found.append(_obstacle("plate", points, report.plate))
    if report.cylinder is not None:
        found.append(_obstacle("cylinder", points, report.cylinder))
    return tuple(found)


def _itself(
    scene: Scene, points: Sequence[PathPoint], touching: Touching | None, overlap: str | None
) -> Effect:
    name = "self_contact"
    if touching is None:
        return Effect(name, False, overlap or "switched off in the scene; no walls overlap")
    if (touching.pressure > 0).any():
        reason = f"surfaces of the body meet {_onset(points, touching)}"
        return Effect(name, True, f"{reason}; {_hardness(touching)}")
    if scene.self_contact == "on":
        return Effect(name, True, "asked for in the scene; no surfaces of the body meet")
    return Effect(name, False, "looked for, and no surfaces of the body meet")


def _obstacle(name: str, points: Sequence[PathPoint], touching: Touching) -> Effect:
    if not (touching.pressure > 0).any():
        return Effect(f"{name}_contact", True, f"the {name} is not reached")
    return Effect(
        f"{name}_contact",
        True,
        f"the {name} is pressed {_onset(points, touching)}, with up to "
        f"{touching.force.max():.3g} N; {_hardness(touching)}",
    )


def _onset(points: Sequence[PathPoint], touching: Touching) -> str:
    """Pressure of the first point that touches; before it, nothing did."""
    first = int(np.flatnonzero(touching.pressure > 0)[0])
    if first == 0:
        return "from the start on"
    return f"from about {points[first].pressure / 1e3:.3g} kPa on"


def _hardness(touching: Touching) -> str:
    return (
        f"contact pressure reaches {touching.pressure.max() / 1e3:.3g} kPa, and surfaces enter "
        f"each other by at most {touching.depth * 1e3:.2g} mm"
    )
