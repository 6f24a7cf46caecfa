"""3D finite elements of a design in a scene: the finest rung of the ladder.

A path is followed on the coarsest mesh, then carried to finer ones until two nested answers differ
by less than the accuracy asked for.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

from actuators.design.base import Design
from actuators.errors import QuestionError
from actuators.geometry import Body, build_body
from actuators.mechanics.continuum.assembly import region_materials
from actuators.mechanics.continuum.loads import check_loads
from actuators.mechanics.continuum.outer_loads import outer_loads
from actuators.mechanics.continuum.path import Path, PathFollower
from actuators.mechanics.continuum.progress import Monitor, Progress
from actuators.mechanics.continuum.recovery import Answer, recover
from actuators.mechanics.continuum.refinement import (
    Anchor,
    Refinement,
    difference,
    shared_points,
)
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.continuum.wall_overlap import has_gaps
from actuators.mechanics.direct_solver import SymmetricSolver, open_solver
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.scene import Scene
from actuators.meshing import mesh_body

Layers = tuple[int, int, int]
LEVELS: tuple[Layers, ...] = ((0, 0, 0), (1, 0, 0), (1, 0, 1), (1, 1, 1), (2, 2, 2))
"""Thin layers at the block borders, per direction; each level's lines contain the one's before."""
LEVELS_WITH_GAPS: tuple[Layers, ...] = ((0, 0, 0), (0, 1, 0), (0, 1, 1), (1, 1, 1))
"""Free-standing chambers have lines enough along the body; their side walls come first (measured:
2.8 % of the tip, layers along the body 0.3 %)."""
MOST_UNKNOWNS = 160_000
"""Largest system this version factorises."""
SHARE_OF_PATH = 0.4
"""Part of the progress bar that the coarse path takes."""


@dataclass(eq=False)
class _Level:
    system: ContinuumSystem
    solver: SymmetricSolver


def solve(
    design: Design,
    scene: Scene,
    *,
    accuracy: float = 0.05,
    progress: Callable[[Progress], None] | None = None,
    cancelled: Callable[[], bool] | None = None,
    time_budget: float | None = None,
) -> Response:
    """Path of ``design`` under ``scene``.

    ``accuracy``: largest difference between two nested answers, as a fraction of the tip's
    displacement. ``cancelled`` is asked between iterations; ``time_budget`` [s]. Not reaching the
    end is a result: see ``Response.outcome`` and ``Response.advice``.
    """
    if not 1e-4 <= accuracy <= 1.0:
        raise QuestionError(
            f"accuracy is {accuracy:g}; it must lie between 0.0001 and 1 (0.05 means 5 %).",
            field="accuracy", value=f"{accuracy:g}", mend="Use for example 0.05.",
        )  # fmt: skip
    check_loads(scene)
    monitor = Monitor(progress, cancelled, time_budget)
    body = build_body(design)
    if body.symmetric and scene.symmetric:
        body = body.half()
    return solve_body(body, design, scene, accuracy, monitor)


def solve_body(
    body: Body, design: Design, scene: Scene, accuracy: float, monitor: Monitor
) -> Response:
    """As :func:`solve`, for a body already built (whole, or the half that is to be computed)."""
    monitor.report(0.0, "meshing")
    level = _open(body, scene, LEVELS[0])
    marks = [monitor.elapsed]
    path = _coarse_path(level, scene, monitor)
    marks.append(monitor.elapsed)
    answer = _refine(body, scene, level, path, accuracy, monitor)
    marks.append(monitor.elapsed)
    monitor.report(0.98, "fields on the surface")
    response = recover(design, scene, answer, accuracy)
    marks.append(monitor.elapsed)
    monitor.report(1.0, "done")
    spans = [later - earlier for earlier, later in zip([0.0, *marks], marks, strict=False)]
    names = ("set_up", "coarse_path", "refinement", "recovery")
    return replace(response, wall_s=monitor.elapsed, timings=dict(zip(names, spans, strict=True)))


def _open(body: Body, scene: Scene, layers: Layers) -> _Level:
    mesh = mesh_body(body, layers=layers)
    system = ContinuumSystem(
        mesh, region_materials(mesh), free=clamped(mesh), gravity=scene.gravity,
        outer_loads=outer_loads(mesh, scene),
    )  # fmt: skip
    return _Level(system, open_solver(system.indptr, system.indices))


def _report(scene: Scene) -> list[float] | None:
    """Pressures to report [Pa], None to leave it to the path."""
    if scene.steps is None:
        return None
    pressure_to = scene.pressure_to or 0.0
    return [pressure_to * (i + 1) / scene.steps for i in range(scene.steps)]


def _coarse_path(level: _Level, scene: Scene, monitor: Monitor) -> Path:
    pressure_to = scene.pressure_to or 0.0

    def watch(pressure: float) -> None:
        share = pressure / pressure_to if pressure_to > 0 else 1.0
        monitor.report(SHARE_OF_PATH * share, f"coarse mesh at {pressure / 1e3:.3g} kPa", pressure)

    loaded = scene.gravity or scene.tip_force or scene.outside_pressure
    first = "own weight and loads" if loaded else "first pressure step"
    monitor.report(0.0, f"coarse mesh, {level.system.unknowns} unknowns: {first}")
    follower = PathFollower(level.system, level.solver, stop=monitor.stop, watch=watch)
    return follower.follow(pressure_to, _report(scene))


def _refine(
    body: Body, scene: Scene, coarse: _Level, path: Path, accuracy: float, monitor: Monitor
) -> Answer:
    """Carry the path to finer meshes until two answers agree."""
    answer = Answer(coarse.system, path, None, path.iterations, None, len(path.points))
    if not path.points or path.outcome in (Outcome.CANCELLED, Outcome.BUDGET_SPENT):
        return answer
    levels = LEVELS_WITH_GAPS if has_gaps(coarse.system.mesh) else LEVELS
    usable = [layers for layers in levels[1:] if _unknowns(body, layers) <= MOST_UNKNOWNS]
    before = Anchor(coarse.system, path.points[shared_points(path) - 1])
    limit = path.points[-1].pressure
    for number, layers in enumerate(usable):
        base = SHARE_OF_PATH + (0.95 - SHARE_OF_PATH) * number / len(usable)
        fine = _open(body, scene, layers)
        message = f"finer mesh, {fine.system.unknowns} unknowns"
        monitor.report(base, message)

        def watch(share: float, base: float = base, message: str = message) -> None:
            monitor.report(base + (0.95 - base) * share, message)

        refinement = Refinement(
            coarse.system, fine.system, fine.solver, path, stop=monitor.stop, watch=watch
        )
        anchor = refinement.anchor(before)
        if anchor is not None:
            rest = refinement.beyond(anchor, scene.pressure_to or 0.0, _report(scene))
            limits = (limit, rest.points[-1].pressure) if rest and rest.points else None
            estimate = difference(before, anchor, limits)
            if estimate <= accuracy or number == len(usable) - 1:
                refined = refinement.whole_path(anchor, rest)
                answer = Answer(
                    fine.system, refined.path, estimate, answer.iterations, None, refined.solved
                )
            before, limit = anchor, limits[1] if limits else limit
        answer.iterations += refinement.iterations
        answer.stopped = monitor.stop()
        if anchor is None or answer.stopped is not None or answer.error_estimate is not None:
            break
    return answer


def _unknowns(body: Body, layers: Layers) -> int:
    """Size of the condensed system, before holding anything."""
    mesh = mesh_body(body, layers=layers)
    return 3 * (len(mesh.nodes) - len(mesh.elements))
