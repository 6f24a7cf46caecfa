"""3D finite elements of a design in a scene: the finest rung of the ladder.

A path is followed on the coarsest mesh, then carried to finer ones until nested answers agree as
well as asked for.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

from actuators.design.base import Design
from actuators.errors import QuestionError
from actuators.geometry import Body, build_body
from actuators.mechanics.continuum.climb import SHARE_OF_PATH, Climb
from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.level import Level, open_level
from actuators.mechanics.continuum.levels import MeshChoice, layers_of, levels_of
from actuators.mechanics.continuum.path import Path, PathFollower
from actuators.mechanics.continuum.progress import Monitor, Progress
from actuators.mechanics.continuum.recovery import Answer, recover
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Scene
from actuators.meshing import mesh_body


@dataclass(frozen=True, eq=False)
class Solution:
    """A response, and the states behind it."""

    response: Response
    answer: Answer


def solve(
    design: Design,
    scene: Scene,
    *,
    accuracy: float = 0.05,
    mesh: MeshChoice | None = None,
    progress: Callable[[Progress], None] | None = None,
    cancelled: Callable[[], bool] | None = None,
    time_budget: float | None = None,
) -> Response:
    """Path of ``design`` under ``scene``.

    ``accuracy``: largest estimated error of the tip's displacement, the end's turn, the force on a
    plate and a limit pressure, as fractions. ``mesh`` (a name or layers, see :mod:`levels`) takes
    that mesh instead, whatever its error. ``cancelled`` is asked between iterations;
    ``time_budget`` [s]. Not reaching the end is a result: see ``Response.outcome`` and
    ``Response.advice``.
    """
    monitor = Monitor(progress, cancelled, time_budget)
    return solve_with_states(design, scene, monitor, accuracy=accuracy, mesh=mesh).response


def solve_with_states(
    design: Design,
    scene: Scene,
    monitor: Monitor,
    *,
    accuracy: float = 0.05,
    mesh: MeshChoice | None = None,
) -> Solution:
    """As :func:`solve`, with the states that fields in the whole body are made from."""
    if not 1e-4 <= accuracy <= 1.0:
        raise QuestionError(
            f"accuracy is {accuracy:g}; it must lie between 0.0001 and 1 (0.05 means 5 %).",
            field="accuracy", value=f"{accuracy:g}", mend="Use for example 0.05.",
        )  # fmt: skip
    body = build_body(design)
    if body.symmetric and scene.symmetric:
        body = body.half()
    return solve_body(body, design, scene, accuracy, monitor, mesh)


def solve_body(
    body: Body,
    design: Design,
    scene: Scene,
    accuracy: float,
    monitor: Monitor,
    mesh: MeshChoice | None = None,
) -> Solution:
    """As :func:`solve_with_states`, for a body already built (whole, or the half that is to be
    computed)."""
    coarsest, *ladder = levels_of(body)
    if mesh is not None:
        wanted = layers_of(body, mesh)
        ladder = [wanted] if wanted != coarsest else []
    monitor.report(0.0, "meshing")
    level = open_level(mesh_body(body, layers=coarsest), scene)
    marks = [monitor.elapsed]
    goal = Goal.of(scene, is_half=level.system.mesh.is_half)
    path = _coarse_path(level, scene, goal, monitor)
    marks.append(monitor.elapsed)
    answer = Climb(body, scene, ladder, goal, monitor).answer(level, path, accuracy)
    answer.chosen = mesh is not None
    marks.append(monitor.elapsed)
    monitor.report(0.98, "fields on the surface")
    response = recover(design, scene, answer, accuracy)
    marks.append(monitor.elapsed)
    monitor.report(1.0, "done")
    spans = [later - earlier for earlier, later in zip([0.0, *marks], marks, strict=False)]
    names = ("set_up", "coarse_path", "refinement", "recovery")
    timed = replace(response, wall_s=monitor.elapsed, timings=dict(zip(names, spans, strict=True)))
    return Solution(timed, answer)


def _coarse_path(level: Level, scene: Scene, goal: Goal, monitor: Monitor) -> Path:
    def watch(share: float, pressure: float) -> None:
        monitor.report(SHARE_OF_PATH * share, f"coarse mesh at {pressure / 1e3:.3g} kPa", pressure)

    loaded = scene.gravity or scene.tip_force or scene.outside_pressure
    first = "own weight and loads" if loaded else "first step"
    monitor.report(0.0, f"coarse mesh, {level.system.unknowns} unknowns: {first}")
    follower = PathFollower(level.system, level.solver, stop=monitor.stop, watch=watch)
    return follower.reach(goal)
