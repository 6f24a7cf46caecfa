"""What a designer must read beside the numbers: effects, notes, advice when a path ends early."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from actuators.materials import Material
from actuators.mechanics.continuum.path import Path
from actuators.mechanics.response import Effect, Outcome, PathPoint
from actuators.mechanics.scene import Scene

VISIBLE_OVERLAP = 0.01e-3
"""Overlaps below this [m] are taken for touching."""


def advice(path: Path, points: Sequence[PathPoint], scene: Scene) -> str | None:
    """One or two sentences on a path that did not reach its end."""
    reached = f"{points[-1].pressure / 1e3:.3g} kPa" if points else "0 kPa"
    if points and path.by_volume:
        reached = f"{1e6 * (points[-1].cavity_volume or 0.0):.4g} ml ({reached})"
    suction = (scene.pressure_to or 0.0) < 0
    if path.outcome is Outcome.LIMIT_POINT:
        asked = (scene.pressure_to or 0.0) / 1e3
        beyond = "collapse" if suction else "balloon"
        change = (
            "Stay above it, or thicken roof and walls."
            if suction
            else "Stay below it, thicken roof and walls, or choose a stiffer or strain-stiffening "
            "material."
        )
        return (
            f"No equilibrium {'below' if suction else 'above'} {reached} ({asked:.4g} kPa were "
            f"asked for): there the pressure has its {'minimum' if suction else 'maximum'}, and "
            f"beyond it the chambers would {beyond}. {change}"
        )
    if path.outcome is Outcome.STALLED and not points:
        return _overloaded(path, scene)
    if path.outcome is Outcome.STALLED:
        if path.by_volume and scene.volume_to is not None:
            farthest = _farthest(points, scene.volume_to)
            reached = f"{farthest * 1e6:.4g} ml ({scene.volume_to * 1e6:.4g} ml were asked for)"
        less = "less change of volume" if path.by_volume else "a lower pressure"
        return (
            f"The computation found no further equilibrium beyond {reached}, and no proof "
            f"that there is none ({path.reason}). Ask for {'less suction' if suction else less}, "
            "or check the design for very thin walls."
        )
    if path.outcome is Outcome.CANCELLED:
        return f"Cancelled at {reached}; the part found so far is kept."
    if path.outcome is Outcome.BUDGET_SPENT:
        return (
            f"The time allowed was spent at {reached}; the part found so far is kept. "
            "Allow more time or ask for less accuracy."
        )
    return None


def _farthest(points: Sequence[PathPoint], volume_to: float) -> float:
    """The volume [m3] that came nearest to the one asked for."""
    return min((p.cavity_volume or 0.0 for p in points), key=lambda v: abs(v - volume_to))


def _overloaded(path: Path, scene: Scene) -> str:
    """What to do where the body does not carry the loads that come before inflation."""
    loads = ["its own weight"] if scene.gravity is not None else []
    if scene.outside_pressure:
        loads.append(f"{scene.outside_pressure / 1e3:.4g} kPa outside")
    if scene.tip_force is not None:
        loads.append(f"{float(np.linalg.norm(scene.tip_force)):.3g} N on the tip")
    return (
        f"No equilibrium was found under {' and '.join(loads) or 'no load'}, before any inflation "
        f"({path.reason}). Lower these loads, or make the body stiffer."
    )


def path_notes(path: Path, parts: float) -> list[str]:
    """Notes on limit points that a path towards a volume has passed; ``parts`` like the mesh make
    the body."""
    if not path.by_volume:
        return []
    notes: list[str] = []
    if path.limit is not None:
        notes.append(
            f"The pressure has its maximum of {path.limit.pressure / 1e3:.3g} kPa at "
            f"{parts * path.limit.volume * 1e6:.4g} ml: a source of constant pressure makes the "
            "chambers balloon there, a syringe does not."
            if path.limit.pressure > 0
            else f"Suction is strongest, {-path.limit.pressure / 1e3:.3g} kPa, at "
            f"{parts * path.limit.volume * 1e6:.4g} ml: a source of constant suction makes the "
            "chambers collapse there, a syringe does not."
        )
    turned = [
        one.volume
        for one, other in pairwise(path.points)
        if (one.volume - path.points[0].volume) * (other.volume - one.volume) < 0
    ]
    if turned:
        notes.append(
            f"At {parts * turned[0] * 1e6:.4g} ml the volume itself turns back along the path: one "
            "chamber runs away and drains the others. A real actuator leaps there to another state "
            "of this volume, which lies later on the path if it lies on it at all; the states "
            "between are not seen in practice."
        )
    return notes


def collapse_notes(points: Sequence[PathPoint], openness: np.ndarray) -> list[str]:
    """A note on cavity walls that suction has drawn through each other; ``openness`` (k,): their
    smallest distance over that at rest."""
    closed = np.flatnonzero(openness < 0.0)
    if len(closed) == 0:
        return []
    first = points[int(closed[0])]
    return [
        f"Walls of the cavity run through each other from {first.pressure / 1e3:.3g} kPa "
        f"({1e6 * (first.cavity_volume or 0.0):.3g} ml) on: this version has no contact inside the "
        "cavity, and from there on the result is not physical."
    ]


def overlap_note(points: Sequence[PathPoint], depth: np.ndarray) -> str | None:
    """Note on walls that have run into each other; ``depth`` (k,) [m] at every point."""
    deep = np.flatnonzero(depth > VISIBLE_OVERLAP)
    if len(deep) == 0:
        return None
    first, worst = int(deep[0]), int(np.argmax(depth))
    onset = points[first].pressure
    if first > 0:
        share = (VISIBLE_OVERLAP - depth[first - 1]) / (depth[first] - depth[first - 1])
        onset = points[first - 1].pressure + share * (onset - points[first - 1].pressure)
    return (
        f"Neighbouring walls overlap from about {onset / 1e3:.3g} kPa on, by up to "
        f"{depth[worst] * 1e3:.2g} mm (at {points[worst].pressure / 1e3:.3g} kPa): contact is "
        "switched off in the scene, and beyond that pressure the result is not physical."
    )


def range_notes(materials: Sequence[Material], largest: Sequence[float]) -> list[str]:
    """Notes on materials stretched beyond what their source tested, or what is stable."""
    tested = [
        f"{material.name} is stretched to {stretch:.2f}, beyond the tested range "
        f"(up to {material.tested_to_stretch:g})."
        for material, stretch in zip(materials, largest, strict=True)
        if material.tested_to_stretch is not None and stretch > material.tested_to_stretch
    ]
    notes = [
        f"{material.name} is stretched to {stretch:.2f}; by Drucker's criterion its law is stable "
        f"in {material.stable_range.smallest[0]} tension up to "
        f"{material.stable_range.smallest[1]:.2f} only."
        for material, stretch in zip(materials, largest, strict=True)
        if stretch > material.stable_range.smallest[1]
    ]
    return list(dict.fromkeys(tested + notes))


def effects(
    scene: Scene, points: Sequence[PathPoint], contact: Sequence[Effect], is_half: bool
) -> tuple[Effect, ...]:
    """Every effect with the reason why it is on or off; ``contact``: those of surfaces."""
    alone = scene.outside_pressure == 0.0 and scene.tip_force is None
    if scene.gravity is None:
        gravity = Effect("gravity", False, "switched off in the scene")
    elif points and alone:
        droop = float(np.linalg.norm(points[0].tip_displacement)) * 1e3
        gravity = Effect("gravity", True, f"its own weight alone moves the tip by {droop:.3g} mm")
    else:
        gravity = Effect("gravity", True, "asked for in the scene")
    stretch = max((p.max_principal_stretch or 1.0 for p in points), default=1.0)
    half = "half of the body is computed" if is_half else "the whole body is computed"
    return (
        gravity,
        *_outer_effects(scene),
        Effect("finite_strain", True, f"stretches reach {stretch:.2f}"),
        Effect("follower_pressure", True, "pressure stays normal to the deformed cavity"),
        *contact,
        Effect("symmetry", is_half, half),
        Effect("inertia", False, "equilibrium only: slow inflation"),
        Effect("viscoelasticity", False, "the materials' records are elastic"),
    )


def _outer_effects(scene: Scene) -> list[Effect]:
    """Effects of the loads on the outside, for those there are."""
    found: list[Effect] = []
    if scene.outside_pressure != 0.0:
        size = scene.outside_pressure / 1e3
        found.append(
            Effect(
                "outside_pressure",
                True,
                f"{size:.4g} kPa on the underside, always normal",
            )
        )
    if scene.tip_force is not None:
        force = ", ".join(f"{x:.4g}" for x in scene.tip_force)
        found.append(
            Effect("tip_force", True, f"({force}) N, spread over the free end; does not turn")
        )
    return found
