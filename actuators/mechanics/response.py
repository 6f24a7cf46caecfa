"""The one result type of every rung of the ladder."""

import math
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

import numpy as np

from actuators.design.base import Design
from actuators.mechanics.choices import Choice
from actuators.mechanics.scene import Scene


class Outcome(StrEnum):
    """How an answer ended. Not converging is a result, not an exception."""

    CONVERGED = "converged"
    LIMIT_POINT = "limit_point"
    STALLED = "stalled"
    CANCELLED = "cancelled"
    BUDGET_SPENT = "budget_spent"


@dataclass(frozen=True)
class PathPoint:
    """State at one pressure, in SI and radians; None where a rung cannot know a quantity.

    The tip point is the middle of the free end's bottom edge. ``bending_angle`` is the angle of the
    line from the clamp (its middle, underside) to the tip against X1 in the X1-X3 plane, positive
    towards -X3; ``tip_rotation`` is the rotation of the end face about X2, same sign, unwrapped.
    ``curvature`` is the mean rod curvature about X2, ``torsion`` right-handed about X1 [1/m].
    ``plate_force``, ``cylinder_force``: sizes of the forces on the scene's obstacles [N];
    ``max_contact_pressure`` [Pa] on any touching surface, None where nothing touches.
    """

    pressure: float
    tip: tuple[float, float, float]
    tip_displacement: tuple[float, float, float]
    tip_rotation: float | None
    bending_angle: float
    curvature: float | None
    torsion: float | None
    helix_radius: float | None = None
    helix_pitch: float | None = None
    cavity_volume: float | None = None
    max_principal_stretch: float | None = None
    plate_force: float | None = None
    cylinder_force: float | None = None
    max_contact_pressure: float | None = None

    def to_document(self) -> dict[str, Any]:
        """Border form of ``predict --json``: mm, kPa, degrees, ml. Infinite becomes null."""
        return {
            "pressure_kPa": _finite(self.pressure, 1e-3),
            "tip_mm": [_finite(x, 1e3) for x in self.tip],
            "tip_displacement_mm": [_finite(x, 1e3) for x in self.tip_displacement],
            "tip_rotation_deg": _finite(self.tip_rotation, 180 / math.pi),
            "bending_angle_deg": _finite(self.bending_angle, 180 / math.pi),
            "curvature_per_m": _finite(self.curvature),
            "torsion_per_m": _finite(self.torsion),
            "helix_radius_mm": _finite(self.helix_radius, 1e3),
            "helix_pitch_mm": _finite(self.helix_pitch, 1e3),
            "cavity_volume_ml": _finite(self.cavity_volume, 1e6),
            "max_principal_stretch": _finite(self.max_principal_stretch),
            "plate_force_N": _finite(self.plate_force),
            "cylinder_force_N": _finite(self.cylinder_force),
            "max_contact_pressure_kPa": _finite(self.max_contact_pressure, 1e-3),
        }


@dataclass(frozen=True)
class Effect:
    """One physical effect: whether it is part of the model, why and what came of it.

    ``estimated_change_percent``: how much leaving it out would change the tip's way, estimated
    beforehand. ``cost_s``: what having it costs, or would cost, in this answer (below 0: saves);
    ``cost_factor``: the same as a ratio of times, of answers with it over those without.
    ``forced``: "on" or "off" where the scene says so.
    """

    name: str
    on: bool
    reason: str
    estimated_change_percent: float | None = None
    cost_s: float | None = None
    cost_factor: float | None = None
    forced: Choice = "auto"

    def to_document(self) -> dict[str, Any]:
        """As in ``predict --json``."""
        return {
            "name": self.name, "on": self.on, "reason": self.reason,
            "estimated_change_percent": _finite(self.estimated_change_percent),
            "cost_s": _finite(self.cost_s), "cost_factor": _finite(self.cost_factor),
            "forced": self.forced,
        }  # fmt: skip


@dataclass(frozen=True, eq=False)
class Centreline:
    """Rod shape at every path point. k points on the path, s stations along the rod.

    ``positions``: (k, s, 3) [m], the line X2 = 0 on the underside; ``frames``: (k, s, 3, 3),
    columns are the directions of the section's (X1, X2, X3); ``stations``: (s,) [m], X1 undeformed.
    """

    stations: np.ndarray
    positions: np.ndarray
    frames: np.ndarray


@dataclass(frozen=True, eq=False)
class SurfaceFields:
    """Fields on the body's surface, outside and cavity, at every path point.

    ``vertices``: (n, 3) [m] undeformed; ``triangles``: (m, 3) int, outward from the rubber;
    ``displacement``: (k, n, 3) [m]; ``stretch``: (k, n) largest principal stretch; ``stress``:
    (k, n) largest principal Cauchy stress [Pa]; ``contact_pressure``: (k, n) [Pa], None where
    nothing can touch. float32.
    """

    vertices: np.ndarray
    triangles: np.ndarray
    displacement: np.ndarray
    stretch: np.ndarray
    stress: np.ndarray
    contact_pressure: np.ndarray | None = None


@dataclass(frozen=True, eq=False)
class Response:
    """Answer of one rung to (design, scene): the path found, and how it ended.

    ``path`` starts at zero pressure (after gravity). ``error_estimate`` is a fraction of the tip's
    displacement, None where the rung has none; ``error_estimates`` name the same for "tip",
    "angle", "force" and "volume" where known. ``limit_pressure``: the pressure's maximum [Pa] that
    the path came to, None where it met none. ``notes`` are findings a designer must read (walls
    overlap by 0.4 mm, ...). ``trusted_to`` is the pressure up to which the rung's own assumptions
    hold [Pa], None where they hold on the whole path. ``wall_s``: on the clock, ``cpu_s``: of the
    processor, all threads together, None where it was not taken. ``timings`` [s] by stage.
    """

    design: Design
    scene: Scene
    rung: str
    outcome: Outcome
    path: tuple[PathPoint, ...]
    advice: str | None = None
    centreline: Centreline | None = None
    surface: SurfaceFields | None = None
    error_estimate: float | None = None
    error_estimates: dict[str, float] = field(default_factory=dict)
    limit_pressure: float | None = None
    trusted_to: float | None = None
    wall_s: float = 0.0
    cpu_s: float | None = None
    unknowns: int = 0
    newton_iterations: int = 0
    effects: tuple[Effect, ...] = ()
    notes: tuple[str, ...] = ()
    timings: dict[str, float] = field(default_factory=dict)

    def to_document(self) -> dict[str, Any]:
        """The JSON document of ``predict --json`` (fields on the surface are kept apart)."""
        return {
            "design": self.design.to_document(),
            "scene": self.scene.to_document(),
            "rung": self.rung,
            "outcome": self.outcome.value,
            "advice": self.advice,
            "path": [p.to_document() for p in self.path],
            "error_estimate_percent": _finite(self.error_estimate, 100.0),
            "error_estimates_percent": {
                name: _finite(value, 100.0) for name, value in self.error_estimates.items()
            },
            "limit_pressure_kPa": _finite(self.limit_pressure, 1e-3),
            "trusted_to_kPa": _finite(self.trusted_to, 1e-3),
            "wall_s": self.wall_s,
            "cpu_s": self.cpu_s,
            "unknowns": self.unknowns,
            "newton_iterations": self.newton_iterations,
            "effects": [e.to_document() for e in self.effects],
            "assumptions": list(self.design.assumptions()),
            "notes": list(self.notes),
        }


def _finite(value: float | None, factor: float = 1.0) -> float | None:
    if value is None or not math.isfinite(value):
        return None
    return float(value) * factor
