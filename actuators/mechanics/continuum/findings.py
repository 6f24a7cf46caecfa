"""What a designer must read beside the numbers: effects, notes, advice when a path ends early."""

from collections.abc import Mapping, Sequence
from itertools import pairwise, takewhile

import numpy as np

from actuators.materials import Material
from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.path import Path
from actuators.mechanics.continuum.sheets import wrinkle_note
from actuators.mechanics.crossing import first_below
from actuators.mechanics.effects import Decision, EffectPlan
from actuators.mechanics.effects.words import left_out_note
from actuators.mechanics.response import Effect, PathPoint
from actuators.mechanics.scene import Scene
from actuators.quantities import kilopascals, two_digits

MOSTLY_SAG = 2.0
"""Whole way of the tip over what inflation makes of it, from which on this is said."""
VISIBLE_OVERLAP = 0.01e-3
"""Overlaps below this [m] are taken for touching."""


def path_notes(path: Path, parts: float) -> list[str]:
    """Notes on layers that would wrinkle, and on limit points that a path towards a volume has
    passed; ``parts`` like the mesh make the body."""
    notes: list[str] = []
    wrinkled = next((point for point in path.points if point.wrinkles), None)
    if wrinkled is not None:
        notes.append(wrinkle_note(wrinkled.pressure))
    notes += [
        f"At {parts * before.volume * 1e6:.4g} ml ({kilopascals(before.pressure, 3)} kPa) the "
        "branch of equilibrium ends, or could not be followed: from "
        f"{parts * after.volume * 1e6:.4g} ml "
        f"({kilopascals(after.pressure, 3)} kPa) on the states lie on another branch, to which a "
        "real actuator snaps. Which of several it takes was not computed."
        for before, after in path.leaps
    ]
    if not path.by_volume:
        return notes
    if path.limit is not None and not _passed_before(path, path.limit):
        notes.append(
            f"The pressure has its maximum of {kilopascals(path.limit.pressure, 3)} kPa at "
            f"{parts * path.limit.volume * 1e6:.4g} ml: a source of constant pressure makes the "
            "chambers balloon there, a syringe does not."
            if path.limit.pressure > 0
            else f"Suction is strongest, {kilopascals(-path.limit.pressure, 3)} kPa, at "
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


def _passed_before(path: Path, limit: Equilibrium) -> bool:
    """Whether a state before ``limit`` has more pressure: the path has leapt in between."""
    if all(point is not limit for point in path.points):
        return False
    earlier = takewhile(lambda point: point is not limit, path.points)
    return any(abs(point.pressure) > abs(limit.pressure) for point in earlier)


def sag_notes(points: Sequence[PathPoint], error: float | None) -> list[str]:
    """What an ``error`` of the tip's whole way means for the part of it that inflation makes, where
    the loads before it make most of the way."""
    tips = np.array([point.tip_displacement for point in points]).reshape(-1, 3)
    if error is None or len(tips) == 0:
        return []
    way = float(np.linalg.norm(tips, axis=1).max())
    inflation = float(np.linalg.norm(tips - tips[0], axis=1).max())
    if inflation == 0.0 or way < MOSTLY_SAG * inflation:
        return []
    return [
        f"Most of the tip's way of {way * 1e3:.3g} mm is made by the loads before inflation, which "
        f"moves it by {inflation * 1e3:.3g} mm. The estimated error is a part of the whole way: up "
        f"to {two_digits(100 * error * way / inflation)} % of what inflation does."
    ]


def contact_notes(points: Sequence[PathPoint]) -> list[str]:
    """What the largest contact pressure is worth, where surfaces press."""
    if not any(point.max_contact_pressure for point in points):
        return []
    return [
        "The contact pressure has no error estimate: the largest sits where edges press, and may "
        "be several times another mesh's. Forces and shapes hardly depend on it."
    ]


def collapse_notes(points: Sequence[PathPoint], openness: np.ndarray) -> list[str]:
    """A note on cavity walls that suction has drawn through each other; ``openness`` (k,): their
    smallest distance over that at rest."""
    pressure = first_below(np.array([point.pressure for point in points]), openness)
    volume = first_below(np.array([point.cavity_volume or 0.0 for point in points]), openness)
    if pressure is None or volume is None:
        return []
    return [
        f"Walls of the cavity run through each other from about {kilopascals(pressure, 2)} kPa "
        f"({1e6 * volume:.2g} ml) on: there is no contact inside the "
        "cavity here, and from there on the result is not physical."
    ]


def overlap_note(points: Sequence[PathPoint], depth: np.ndarray) -> str | None:
    """Note on walls that have run into each other; ``depth`` (k,) [m] at every point."""
    onset = first_below(np.array([point.pressure for point in points]), -depth, -VISIBLE_OVERLAP)
    if onset is None:
        return None
    worst = int(np.argmax(depth))
    return (
        f"Neighbouring walls overlap from about {kilopascals(onset, 3)} kPa on, by up to "
        f"{depth[worst] * 1e3:.2g} mm (at {kilopascals(points[worst].pressure, 3)} kPa): contact "
        "is switched off in the scene, and beyond that pressure the result is not physical."
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


def left_out_notes(plan: EffectPlan) -> list[str]:
    """Notes on what the scene leaves out by choice although it would change the answer."""
    return [
        left_out_note(d.name, d.change)
        for d in plan.decisions
        if d.forced == "off" and d.change != 0.0
    ]


def effects(
    plan: EffectPlan, points: Sequence[PathPoint], came_of_it: Mapping[str, str], wall_s: float
) -> tuple[Effect, ...]:
    """Every effect with the reason why it is on or off and what came of it. ``came_of_it``: by
    name, of contact and of finite strain; ``wall_s``: time of the answer [s]."""
    came = {**_of_loads(plan.applied, points), **came_of_it}
    decided = [_effect(decision, came.get(decision.name), wall_s) for decision in plan.decisions]
    return (
        *decided,
        Effect("follower_pressure", True, "pressure stays normal to the deformed cavity"),
        Effect("inertia", False, "equilibrium only: slow inflation"),
        Effect("viscoelasticity", False, "the materials' records are elastic"),
    )


def _effect(decision: Decision, came: str | None, wall_s: float) -> Effect:
    factor, known = decision.cost_factor, decision.change is not None
    cost = None
    if factor is not None:
        cost = wall_s * (1.0 - 1.0 / factor) if decision.on else wall_s * (factor - 1.0)
    return Effect(
        decision.name,
        decision.on,
        decision.reason if came is None else f"{decision.reason}; {came}",
        estimated_change_percent=100.0 * (decision.change or 0.0) if known else None,
        cost_s=cost,
        cost_factor=factor,
        forced=decision.forced,
    )


def _of_loads(scene: Scene, points: Sequence[PathPoint]) -> dict[str, str]:
    """What the path says about loads and stretch."""
    if not points:
        return {}
    stretch = max(p.max_principal_stretch or 1.0 for p in points)
    found = {"finite_strain": f"stretches reach {stretch:.2f}"}
    alone = scene.outside_pressure == 0.0 and scene.tip_force is None
    if scene.gravity is not None and alone:
        droop = float(np.linalg.norm(points[0].tip_displacement)) * 1e3
        found["gravity"] = f"alone it moves the tip by {droop:.3g} mm"
    return found
