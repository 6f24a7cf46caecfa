"""3D finite elements of a design in a scene: the finest rung of the ladder.

First it is decided which effects the question calls for. A path is followed on the coarsest mesh,
then carried to finer ones until nested answers agree as well as asked for; where displacements and
strains stay small, one linear solution a mesh takes its place.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

from actuators.design.base import Design
from actuators.errors import QuestionError
from actuators.geometry import Body, build_body
from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.guard import Guard
from actuators.mechanics.continuum.levels import MeshChoice, layers_of, levels_of
from actuators.mechanics.continuum.linear import missed, solve_linear, states_of
from actuators.mechanics.continuum.part import PathPart
from actuators.mechanics.continuum.progress import Monitor, Progress
from actuators.mechanics.continuum.recovery import Answer, recover
from actuators.mechanics.continuum.watched import WATCHED, WatchedRun
from actuators.mechanics.effects import EffectPlan, checked, plan, without_layer
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Scene
from actuators.quantities import about, percent


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
    return _Question(design, scene, accuracy, monitor, mesh).solution()


class _Question:
    """One question on its way to a solution."""

    def __init__(
        self,
        design: Design,
        scene: Scene,
        accuracy: float,
        monitor: Monitor,
        mesh: MeshChoice | None,
    ) -> None:
        monitor.report(0.0, "which effects matter")
        self._design, self._scene, self._accuracy = design, scene, accuracy
        self._monitor, self._chosen = monitor, mesh is not None
        self._plan = plan(design, scene, accuracy)
        self._body = _body(design, self._plan)
        self._goal = Goal.of(scene, is_half=self._plan.on("symmetry"))
        self._came_of_it: dict[str, str] = {}
        self._meshes = list(levels_of(self._body))
        if mesh is not None:
            wanted = layers_of(self._body, mesh)
            self._meshes = list(dict.fromkeys([self._meshes[0], wanted]))

    def solution(self) -> Solution:
        """By one linear solution where that is enough, else along the path."""
        monitor, marks = self._monitor, [self._monitor.elapsed]
        answer = None if self._plan.on("finite_strain") else self._linear()
        if answer is None:
            monitor.report(0.0, "meshing")
            part = PathPart(self._design, self._scene, self._accuracy)
            run = WatchedRun(self._body, self._plan, self._goal, monitor, part)
            answer = run.answer(self._meshes[0], self._meshes[1:], self._accuracy)
            self._plan = run.plan
            marks.append(run.path_done)
        answer.chosen = self._chosen
        marks.append(monitor.elapsed)
        monitor.report(0.98, "fields on the surface")
        response = recover(
            self._design, self._scene, answer, self._accuracy, plan=self._plan,
            came_of_it=self._came_of_it, wall_s=monitor.elapsed,
        )  # fmt: skip
        response = checked(response, self._plan)
        marks.append(monitor.elapsed)
        monitor.report(1.0, "done")
        spans = [later - earlier for earlier, later in zip([0.0, *marks], marks, strict=False)]
        names = ("set_up", "coarse_path", "refinement", "recovery")
        if len(spans) < len(names):
            names = ("set_up", "linear", "recovery")
        timings = dict(zip(names, spans, strict=True))
        response = replace(
            response, wall_s=monitor.elapsed, cpu_s=monitor.elapsed_cpu, timings=timings
        )
        return Solution(response, answer)

    def _linear(self) -> Answer | None:
        """The linear answer; None where it turns out to miss too much, or bodies would touch."""
        decision = self._plan.by_name["finite_strain"]
        found = solve_linear(
            self._body, self._plan.applied, self._goal, self._meshes, self._accuracy, self._monitor
        )
        off = missed(found, self._plan.rotation_per_way)
        if decision.forced == "off":
            self._plan = self._plan.found_to_change("finite_strain", off)
            self._came_of_it["finite_strain"] = (
                f"by the strains and the way found, the tip is off by {about(off)}"
            )
            return found.answer
        watched = [name for name in WATCHED if self._plan.watched(name)]
        guard = Guard(found.level.system.mesh, self._scene, watched)
        alarms = [a for a in map(guard.look, states_of(found)) if a is not None]
        if off <= self._plan.threshold and not alarms:
            self._came_of_it["finite_strain"] = (
                f"checked afterwards by the strains and the way found: {percent(off)}"
            )
            return found.answer
        why = f"by its strains and way, the tip was off by {about(off)}"
        if alarms:
            why = f"in one linear solution {alarms[0].seen}"
        self._plan = self._plan.nonlinear(f"switched on after a first, linear run: {why}")
        return None


def _body(design: Design, chosen: EffectPlan) -> Body:
    """What is left of the body: without the layer that keeps its length, and its mirror image,
    where these are off."""
    bare = None if chosen.on("inextensible_layer") else without_layer(design)
    body = build_body(bare or design)
    return body.half() if chosen.on("symmetry") else body
