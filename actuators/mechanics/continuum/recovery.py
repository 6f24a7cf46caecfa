"""From converged states to the result type of the ladder."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from actuators.design.base import Design
from actuators.mechanics.continuum.advice import advice, unstable_materials
from actuators.mechanics.continuum.cavity_gap import least_openness
from actuators.mechanics.continuum.contact.build import holds_cavity
from actuators.mechanics.continuum.contact.effects import contact_findings
from actuators.mechanics.continuum.contact.report import (
    ContactReport,
    Touching,
    contact_report,
    unseen_notes,
)
from actuators.mechanics.continuum.estimates import JUDGED
from actuators.mechanics.continuum.findings import (
    collapse_notes,
    contact_notes,
    effects,
    left_out_notes,
    overlap_note,
    path_notes,
    range_notes,
    sag_notes,
)
from actuators.mechanics.continuum.path import Path
from actuators.mechanics.continuum.sections import RodShape, rod_shape
from actuators.mechanics.continuum.surface_fields import StrainRecovery, surface_fields
from actuators.mechanics.continuum.system import ContinuumSystem
from actuators.mechanics.continuum.wall_overlap import wall_overlap
from actuators.mechanics.effects import EffectPlan
from actuators.mechanics.effects import plan as plan_effects
from actuators.mechanics.response import Outcome, PathPoint, Response
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh


@dataclass(eq=False)
class Answer:
    """States on the finest mesh reached. ``errors``: estimates by quantity, empty where only one
    mesh answered; ``stopped``: why refinement ended early; ``solved``: points solved on this very
    mesh; ``chosen``: whether the mesh was asked for; ``too_large``: unknowns of the next mesh,
    where it was more than this version takes."""

    system: ContinuumSystem
    path: Path
    errors: dict[str, float]
    iterations: int
    stopped: Outcome | None
    solved: int
    chosen: bool = False
    too_large: int | None = None


def recover(
    design: Design,
    scene: Scene,
    answer: Answer,
    accuracy: float,
    *,
    plan: EffectPlan | None = None,
    came_of_it: Mapping[str, str] | None = None,
    wall_s: float = 0.0,
) -> Response:
    """Points, centreline, surface fields, effects and notes of an answer. ``plan``: the effects
    that it holds (as decided for the scene where left out), ``came_of_it``: what is known of them
    besides; ``wall_s``: time so far [s]."""
    plan = plan or plan_effects(design, scene, accuracy)
    system, mesh = answer.system, answer.system.mesh
    states = [e.state for e in answer.path.points]
    shape = rod_shape(mesh, states)
    strain = StrainRecovery(system)
    at_points = [strain.at_points(state) for state in states]
    largest = np.array([_largest_stretches(system, stretch) for stretch, _ in at_points])
    touching = contact_report(system, answer.path.points)
    points = _points(answer, shape, largest, touching, plan)
    note = None
    if touching.itself is None:
        note = overlap_note(points, wall_overlap(mesh, states))
    notes = [*_notes(answer, accuracy), *path_notes(answer.path, halves(mesh))]
    unstable: list[str] = []
    if states:
        notes += range_notes(system.materials, largest.max(axis=0))
        unstable = unstable_materials(system.materials, largest.max(axis=0))
        if not holds_cavity(system.interactions):
            notes += collapse_notes(points, least_openness(mesh, states))
    if note is not None:
        notes.append(note)
    notes += sag_notes(points, answer.errors.get("tip")) + contact_notes(points)
    notes += unseen_notes(system, answer.path.points)
    notes += left_out_notes(plan)
    found = {**contact_findings(points, touching, note), **(came_of_it or {})}
    path = answer.path
    if answer.stopped is not None:
        path = replace(path, outcome=answer.stopped)
    return Response(
        design=design,
        scene=scene,
        rung="fe",
        outcome=path.outcome,
        path=points,
        advice=advice(path, points, plan.applied, unstable),
        centreline=shape.centreline,
        surface=surface_fields(system, states, strain, at_points),
        error_estimate=answer.errors.get("tip"),
        error_estimates=answer.errors,
        limit_pressure=path.limit.pressure if path.limit is not None else None,
        unknowns=system.unknowns,
        newton_iterations=answer.iterations,
        effects=effects(plan, points, found, wall_s),
        notes=tuple(notes),
    )


def _largest_stretches(system: ContinuumSystem, stretch: np.ndarray) -> list[float]:
    """Largest stretch in each region."""
    region = system.mesh.region
    return [
        float(stretch[region == r].max()) if (region == r).any() else 1.0
        for r in range(len(system.materials))
    ]


def _points(
    answer: Answer, shape: RodShape, largest: np.ndarray, touching: ContactReport, plan: EffectPlan
) -> tuple[PathPoint, ...]:
    line = shape.centreline.positions
    clamp, rest = answer.system.mesh.nodes[answer.system.mesh.underside_line[[0, -1]]]
    parts = halves(answer.system.mesh)
    points: list[PathPoint] = []
    for k, found in enumerate(answer.path.points):
        tip = line[k, -1]
        points.append(
            PathPoint(
                pressure=found.pressure,
                tip=_triple(tip),
                tip_displacement=_triple(tip - rest),
                tip_rotation=float(shape.tip_rotation[k]),
                bending_angle=float(np.arctan2(clamp[2] - tip[2], tip[0] - clamp[0])),
                curvature=float(shape.curvature[k]),
                torsion=float(shape.torsion[k]),
                cavity_volume=parts * found.volume,
                max_principal_stretch=float(largest[k].max()),
                plate_force=_force(touching.plate, k, plan, "plate"),
                cylinder_force=_force(touching.cylinder, k, plan, "cylinder"),
                max_contact_pressure=_pressure(touching, k),
            )
        )
    return tuple(points)


def _pressure(touching: ContactReport, k: int) -> float | None:
    return None if touching.pressure is None else float(touching.pressure[k]) or None


def _force(touching: Touching | None, k: int, plan: EffectPlan, name: str) -> float | None:
    """Force on an obstacle [N]: none on one that was watched and not reached."""
    if touching is None:
        return 0.0 if plan.watched(f"{name}_contact") else None
    return float(touching.force[k])


def halves(mesh: HexMesh) -> float:
    """How many of the mesh make the body."""
    return 2.0 if mesh.is_half else 1.0


def _triple(x: np.ndarray) -> tuple[float, float, float]:
    return float(x[0]), float(x[1]), float(x[2])


def _notes(answer: Answer, accuracy: float) -> list[str]:
    notes: list[str] = []
    errors, count = answer.errors, len(answer.path.points)
    judged = {name: errors[name] for name in JUDGED if name in errors}
    worst = max(judged, key=lambda name: judged[name], default=None)
    if worst is None and count:
        notes.append("Only the coarsest mesh answered: there is no error estimate.")
    elif worst is not None and judged[worst] > accuracy and not answer.chosen:
        why = (
            f"the next mesh has {answer.too_large} unknowns, more than this version takes"
            if answer.too_large is not None
            else "there is no finer mesh"
        )
        notes.append(
            f"The accuracy asked for ({accuracy:.2g}) was not reached: the estimated error of "
            f"{_IN_WORDS[worst]} is {judged[worst]:.2g}, and {why}."
        )
    if count:
        notes.append(
            "The largest stretch has no error estimate: it sits at the inner edges of the "
            "chambers, where a sharp corner has no finite one, and grows with finer meshes."
        )
    if answer.solved < count:
        notes.append(
            f"{answer.solved} of {count} points were solved on the finest mesh; the others are "
            "coarse answers with the correction interpolated."
        )
    return notes


_IN_WORDS = {
    "tip": "the tip's displacement", "angle": "the free end's turn",
    "force": "the force on the plate", "limit_pressure": "the limit pressure",
}  # fmt: skip
