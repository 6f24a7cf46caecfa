"""Which physical effects an instant answer holds, why, and what leaving one out would change."""

import numpy as np

from actuators.mechanics.response import Effect
from actuators.mechanics.rod.solve import RodPath
from actuators.mechanics.scene import Scene
from actuators.quantities import about, percent, two_digits

SMALL_STRAIN = 0.1
"""Largest strain, mean over an element, up to which a small-strain model is worth reading. Against
the weightless 3D solution its curvature is then 13 % too large (oblique-90, whose walls stiffen as
they bulge) or 6 % too small (slab-rectangle-low, which softens towards its limit pressure); at 25 %
strain it is 17 % too large or half as large."""

MODERATE_STRAIN = 0.3
"""Up to here the deviations from 3D above were measured."""


MEANINGLESS_STRAIN = 3.0
"""Ten times what was measured: a linear path ends here, for its numbers say nothing any more."""


def rod_effects(
    scene: Scene, path: RodPath, floating: RodPath, length: float, *, cost: float
) -> tuple[Effect, ...]:
    """Effects of the energy rung. ``floating``: the weightless shape at the last pressure found;
    ``length`` of the undeformed rod [m]."""
    return (
        _gravity(scene, path, floating, length, cost),
        Effect("large_rotation", True, "the rod's segments are exact pieces of helix"),
        Effect(
            "finite_strain", False,
            "the chamber is solved once at small strain; stretch and curvature grow in proportion "
            "to pressure",
        ),
        Effect("self_contact", False, "the rod does not know where walls touch"),
        Effect(
            "end_effects", False,
            "every chamber answers as one in a long row, also near clamp and free end; short wide "
            "slabs move their tip about 10 % further in 3D",
        ),
    )  # fmt: skip


def closed_form_effects(scene: Scene) -> tuple[Effect, ...]:
    """Effects of the closed form: none but the rotation."""
    reasons = {
        "gravity": "the closed form has no weight" if scene.gravity else "the scene has none",
        "finite_strain": "linear in pressure",
        "self_contact": "the section does not know where walls touch",
        "wall_bulging": "walls stay flat in an equivalent section",
    }
    off = [Effect(name, False, reason) for name, reason in reasons.items()]
    return (Effect("large_rotation", True, "constant-curvature arcs"), *off)


def strain_notes(per_pressure: float, pressure: float) -> tuple[str, ...]:
    """A sentence where the largest strain at ``pressure`` leaves what a linear model can say."""
    limit = small_strain_limit(per_pressure, pressure)
    if limit is None:
        return ()
    largest = per_pressure * pressure
    warning = (
        "Beyond, it can be off by 20 % (gapped chambers) to half (slabs near their limit pressure)"
        if largest <= MODERATE_STRAIN
        else "This far beyond, its numbers mean nothing, and there may be no equilibrium at all"
    )
    return (
        f"Strain would reach {about(largest)} at {pressure / 1e3:.6g} kPa; this linear "
        f"model is meant for less than {percent(SMALL_STRAIN)} (about {two_digits(limit / 1e3)} "
        f"kPa). {warning}: solve in 3D.",
    )


def small_strain_limit(per_pressure: float, pressure: float) -> float | None:
    """Pressure [Pa] at which strain leaves what a linear model can say; None where ``pressure``
    stays below it."""
    if per_pressure * pressure <= SMALL_STRAIN:
        return None
    return SMALL_STRAIN / per_pressure


def _gravity(scene: Scene, path: RodPath, floating: RodPath, length: float, cost: float) -> Effect:
    if scene.gravity is None or not any(scene.gravity):
        return Effect("gravity", False, "the scene has none")
    reason = "the scene has it; the rod bears its own weight"
    if len(path.positions) == 0:
        return Effect("gravity", True, reason, cost_s=cost)
    change = 100 * weight_change(path, floating.positions[-1, -1], length, alone=is_plain(scene))
    return Effect("gravity", True, reason, estimated_change_percent=change, cost_s=cost)


def weight_change(path: RodPath, floating: np.ndarray, length: float, *, alone: bool) -> float:
    """What leaving out gravity changes at the tip, over its longest way, as the effects' plan has
    it: the larger of the changes at the path's end, where the weightless tip is at ``floating``
    (3,) [m], and at its beginning, where it rests if weight is ``alone``. ``length`` [m]."""
    tips, rest = path.positions[:, -1], np.array([length, 0.0, 0.0])
    ways = np.linalg.norm(tips - rest, axis=1)
    change = float(np.linalg.norm(tips[-1] - floating))
    if alone:
        change = max(change, float(ways[0]))
    return change / float(ways.max()) if ways.max() > 0.0 else 0.0


def is_plain(scene: Scene) -> bool:
    """Whether weight is the only load beside pressure."""
    return (
        scene.tip_force is None and scene.outside_pressure == 0.0
        and not scene.has_obstacle
    )  # fmt: skip
