"""What a designer must read about contact."""

from collections.abc import Sequence

import numpy as np

from actuators.mechanics.continuum.contact.report import ContactReport, Touching
from actuators.mechanics.response import PathPoint


def contact_findings(
    points: Sequence[PathPoint], report: ContactReport, overlap: str | None
) -> dict[str, str]:
    """What came of contact of the body with itself and with the scene's obstacles, by effect.
    ``overlap``: a note on walls that ran into each other where contact was left out."""
    found = {"self_contact": _itself(points, report.itself, overlap)}
    for name, touching in (("plate", report.plate), ("cylinder", report.cylinder)):
        if touching is not None:
            found[f"{name}_contact"] = _obstacle(name, points, touching)
    return found


def _itself(points: Sequence[PathPoint], touching: Touching | None, overlap: str | None) -> str:
    if touching is None:
        return overlap or "no walls overlap"
    if not (touching.pressure > 0).any():
        return "no surfaces of the body meet"
    return f"surfaces of the body meet {_onset(points, touching)}; {_hardness(touching)}"


def _obstacle(name: str, points: Sequence[PathPoint], touching: Touching) -> str:
    if not (touching.pressure > 0).any():
        return f"the {name} is not reached"
    return (
        f"the {name} is pressed {_onset(points, touching)}, with up to "
        f"{touching.force.max():.3g} N; {_hardness(touching)}"
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
