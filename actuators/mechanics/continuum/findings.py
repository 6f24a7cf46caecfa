"""What a designer must read beside the numbers: effects, notes, advice when a path ends early."""

from collections.abc import Sequence

import numpy as np

from actuators.materials import Material
from actuators.mechanics.continuum.path import Path
from actuators.mechanics.response import Effect, Outcome, PathPoint
from actuators.mechanics.scene import Scene

VISIBLE_OVERLAP = 0.01e-3
"""Overlaps below this [m] are taken for touching."""


def advice(path: Path, points: Sequence[PathPoint], scene: Scene) -> str | None:
    """One or two sentences on a path that did not reach its end."""
    reached = points[-1].pressure / 1e3 if points else 0.0
    asked = (scene.pressure_to or 0.0) / 1e3
    if path.outcome is Outcome.LIMIT_POINT:
        return (
            f"No equilibrium above {reached:.3g} kPa ({asked:.4g} kPa were asked for): there the "
            "pressure has its maximum, and beyond it the chambers would balloon. Stay below it, "
            "thicken roof and walls, or choose a stiffer or strain-stiffening material."
        )
    if path.outcome is Outcome.STALLED:
        return (
            f"The computation found no further equilibrium beyond {reached:.3g} kPa, and no proof "
            f"that there is none ({path.reason}). Ask for a lower pressure, or check the design "
            "for very thin walls."
        )
    if path.outcome is Outcome.CANCELLED:
        return f"Cancelled at {reached:.3g} kPa; the part found so far is kept."
    if path.outcome is Outcome.BUDGET_SPENT:
        return (
            f"The time allowed was spent at {reached:.3g} kPa; the part found so far is kept. "
            "Allow more time or ask for less accuracy."
        )
    return None


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
        f"{depth[worst] * 1e3:.2g} mm (at {points[worst].pressure / 1e3:.3g} kPa): this version "
        "has no contact between walls, and beyond that pressure the result is not physical."
    )


def range_notes(materials: Sequence[Material], largest: Sequence[float]) -> list[str]:
    """Notes on materials stretched beyond what their source tested."""
    return [
        f"{material.name} is stretched to {stretch:.2f}, beyond the tested range "
        f"(up to {material.tested_to_stretch:g})."
        for material, stretch in zip(materials, largest, strict=True)
        if material.tested_to_stretch is not None and stretch > material.tested_to_stretch
    ]


def effects(
    scene: Scene, points: Sequence[PathPoint], overlap: str | None, has_gaps: bool, is_half: bool
) -> tuple[Effect, ...]:
    """Every effect with the reason why it is on or off."""
    if scene.gravity is None:
        gravity = Effect("gravity", False, "switched off in the scene")
    elif points:
        droop = float(np.linalg.norm(points[0].tip_displacement)) * 1e3
        gravity = Effect("gravity", True, f"its own weight alone moves the tip by {droop:.3g} mm")
    else:
        gravity = Effect("gravity", True, "asked for in the scene")
    stretch = max((p.max_principal_stretch or 1.0 for p in points), default=1.0)
    if overlap is not None:
        contact = f"contact between walls comes in a later version. {overlap}"
    elif has_gaps:
        contact = "contact between walls comes in a later version; no walls overlap in this result"
    else:
        contact = "no open gaps between chambers; contact of the body with itself is not looked for"
    half = "half of the body is computed" if is_half else "the whole body is computed"
    return (
        gravity,
        Effect("finite_strain", True, f"stretches reach {stretch:.2f}"),
        Effect("follower_pressure", True, "pressure stays normal to the deformed cavity"),
        Effect("self_contact", False, contact),
        Effect("symmetry", is_half, half),
        Effect("inertia", False, "equilibrium only: slow inflation"),
        Effect("viscoelasticity", False, "the materials' records are elastic"),
    )
