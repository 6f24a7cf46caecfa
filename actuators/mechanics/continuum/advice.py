"""What a designer can do where a path did not come to its end: a sentence or two per outcome."""

from collections.abc import Sequence

import numpy as np

from actuators.materials import Material
from actuators.mechanics.continuum.newton import TOO_DEEP
from actuators.mechanics.continuum.path import Path
from actuators.mechanics.continuum.unmodelled import CROSSED, EMPTIED, HALVED, MOUNTED
from actuators.mechanics.response import Outcome, PathPoint
from actuators.mechanics.scene import Scene
from actuators.quantities import kilopascals

WAYS_OUT = {
    TOO_DEEP: "Parts of the body far from each other meet there, edge on edge, which contact "
    "between faces sees too late. Ask for less pressure or volume.",
    CROSSED: "Leave self-contact to the program, which then holds the walls apart.",
    EMPTIED: "There is nothing left to suck out: ask for less suction, or for more volume.",
    HALVED: "Ask for less suction, or for the whole body (force symmetry off), whose side "
    "walls are held apart.",
    MOUNTED: "Ask for less pressure or volume, or take a shorter body: what holds the clamp is "
    "taken to be as wide and high as the body, and to begin at its plane.",
}
"""What to do where a path ended at something that is not modelled."""


def advice(
    path: Path, points: Sequence[PathPoint], scene: Scene, unstable: Sequence[str] = ()
) -> str | None:
    """Advice on a path, None where it came to its end. ``unstable``: materials stretched beyond
    what their laws are stable for."""
    if path.outcome is Outcome.CONVERGED:
        return None
    if path.loads < 1.0:
        return _overloaded(path, scene)
    reached = f"{kilopascals(points[-1].pressure, 3)} kPa"
    if path.by_volume:
        reached = f"{1e6 * (points[-1].cavity_volume or 0.0):.4g} ml ({reached})"
    if path.outcome is Outcome.LIMIT_POINT:
        return _limit(reached, scene)
    if path.outcome is Outcome.STALLED:
        return _stalled(path, points, scene, reached, unstable)
    if path.outcome is Outcome.CANCELLED:
        return f"Cancelled at {reached}; the part found so far is kept."
    return (
        f"The time, iterations or memory allowed were spent at {reached}; the part found so far is "
        "kept. Allow more time or ask for less accuracy."
    )


def _limit(reached: str, scene: Scene) -> str:
    suction = (scene.pressure_to or 0.0) < 0
    asked = kilopascals(scene.pressure_to or 0.0)
    change = (
        "Stay above it, or thicken roof and walls."
        if suction
        else "Stay below it, thicken roof and walls, or choose a stiffer or strain-stiffening "
        "material."
    )
    return (
        f"No equilibrium {'below' if suction else 'above'} {reached} ({asked} kPa were "
        f"asked for): there the pressure has its {'minimum' if suction else 'maximum'}, and "
        f"beyond it the chambers would {'collapse, or buckle' if suction else 'balloon'}. {change}"
    )


def _stalled(
    path: Path, points: Sequence[PathPoint], scene: Scene, reached: str, unstable: Sequence[str]
) -> str:
    if path.by_volume and scene.volume_to is not None:
        farthest = _farthest(points, scene.volume_to)
        reached = f"{farthest * 1e6:.4g} ml ({scene.volume_to * 1e6:.4g} ml were asked for)"
    suction = (scene.pressure_to or 0.0) < 0
    if path.reason in WAYS_OUT:
        return f"The path ends at {reached}: {path.reason}. {WAYS_OUT[path.reason]}"
    less = "less change of volume" if path.by_volume else "a lower pressure"
    other = (
        f"or choose a record that stiffens: the law of {' and '.join(unstable)} is stretched "
        "beyond what it is stable for."
        if unstable
        else "or check the design for very thin walls."
    )
    return (
        f"The computation found no further equilibrium beyond {reached}, and no proof "
        f"that there is none ({path.reason}). Ask for {'less suction' if suction else less}, "
        f"{other}"
    )


def _farthest(points: Sequence[PathPoint], volume_to: float) -> float:
    """The volume [m3] that came nearest to the one asked for."""
    return min((p.cavity_volume or 0.0 for p in points), key=lambda v: abs(v - volume_to))


def _overloaded(path: Path, scene: Scene) -> str:
    """Where the path ended under the loads that come before inflation."""
    loads = ["its own weight"] if scene.gravity is not None else []
    if scene.outside_pressure:
        loads.append(f"{kilopascals(scene.outside_pressure)} kPa outside")
    if scene.tip_force is not None:
        loads.append(f"{float(np.linalg.norm(scene.tip_force)):.3g} N on the tip")
    named = " and ".join(loads) or "no load"
    shown = f"Shown is the body under {100 * path.loads:.2g} % of that."
    if path.outcome is Outcome.CANCELLED:
        return f"Cancelled under {named}, before any inflation. {shown}"
    if path.outcome is Outcome.BUDGET_SPENT:
        return (
            f"The time, iterations or memory allowed were spent under {named}, before any "
            f"inflation. {shown} Allow more time, or leave out loads that hardly matter."
        )
    return (
        f"No equilibrium was found under {named}, before any inflation ({path.reason}). {shown} "
        "Lower these loads, or make the body stiffer."
    )


def unstable_materials(materials: Sequence[Material], largest: Sequence[float]) -> list[str]:
    """Names of the materials that ``largest`` stretches take beyond Drucker's limit."""
    beyond = [
        material.name
        for material, stretch in zip(materials, largest, strict=True)
        if stretch > material.stable_range.smallest[1]
    ]
    return list(dict.fromkeys(beyond))
