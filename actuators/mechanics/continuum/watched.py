"""The path on the coarsest mesh, with only the effects that a question calls for; what it comes to
need on the way is switched on, and the path goes on from the last state before."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from actuators.geometry import Body
from actuators.mechanics.continuum.climb import SHARE_OF_PATH, Climb
from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.guard import Guard
from actuators.mechanics.continuum.law_check import law_difference
from actuators.mechanics.continuum.level import Level, open_level
from actuators.mechanics.continuum.levels import Layers
from actuators.mechanics.continuum.memory import refuse_what_does_not_fit
from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.part import PathPart
from actuators.mechanics.continuum.path import Path, PathFollower
from actuators.mechanics.continuum.progress import Monitor
from actuators.mechanics.continuum.recovery import Answer
from actuators.mechanics.effects import EffectPlan
from actuators.mechanics.response import Outcome
from actuators.meshing import HexMesh, mesh_body
from actuators.meshing.counting import condensed_unknowns
from actuators.quantities import kilopascals, percent

WATCHED = ("self_contact", "plate_contact", "cylinder_contact")


class WatchedRun:
    """A nonlinear solve of ``body`` after ``plan``, which it amends; ``plan`` says in the end what
    the answer holds, ``path_done`` when the coarse path was found [s]. The ``monitor`` is offered
    every state of the coarse path, as ``part``."""

    def __init__(
        self, body: Body, plan: EffectPlan, goal: Goal, monitor: Monitor, part: PathPart
    ) -> None:
        self._body, self._goal, self._monitor, self._part = body, goal, monitor, part
        self.plan = plan
        self.path_done = 0.0

    def answer(self, layers: Layers, ladder: Sequence[Layers], accuracy: float) -> Answer:
        """The path on the mesh of ``layers``, carried up the ``ladder`` to ``accuracy``."""
        refuse_what_does_not_fit(condensed_unknowns(self._body, layers), self._monitor.room())
        mesh = mesh_body(self._body, layers=layers)
        level, path = self._path(mesh)
        if self._left_law_behind(level, path):
            level, path = self._path(mesh)
        self.path_done = self._monitor.elapsed
        while True:
            climb = Climb(self._body, self.plan.applied, ladder, self._goal, self._monitor)
            answer = climb.answer(level, path, accuracy)
            if not self._alarmed_by(answer):
                return answer
            level = open_level(mesh, self.plan.applied)

    def _path(self, mesh: HexMesh) -> tuple[Level, Path]:
        """Path on one mesh. Every round switches on at least one effect, or is the last."""
        done: Path | None = None
        before: list[Equilibrium] = []
        while True:
            level = open_level(mesh, self.plan.applied)
            guard = Guard(mesh, self.plan.scene, self._watched())
            guard.before = before
            follower = PathFollower(
                level.system, level.solver, stop=self._stop(guard), watch=self._watch,
                seen=self._seen(level, guard),
            )  # fmt: skip
            if done is None or not before:
                self._begin(level)
                self._part.go_on_from([])
                path = follower.reach(self._goal)
            else:
                self._part.go_on_from([*done.points, *before])
                rest = follower.resume(before, done.points[0], self._goal, limit=done.limit)
                path = joined(done, rest)
            if guard.alarm is None or guard.at is None:
                return level, path
            self._switch_on(guard.alarm.name, guard.alarm.seen, guard.at.pressure)
            before = guard.before
            done = until(path, guard.at, before)

    def _watched(self) -> list[str]:
        return [name for name in WATCHED if self.plan.watched(name)]

    def _switch_on(self, name: str, seen: str, pressure: float) -> None:
        words = f"switched on during the run at {kilopascals(pressure, 3)} kPa, where {seen}"
        self.plan = self.plan.switched_on(name, words)
        self._monitor.report(0.0, f"{name.replace('_', ' ')} {words}", pressure)

    def _alarmed_by(self, answer: Answer) -> bool:
        """Whether a finer mesh came to touch where the coarse one stayed apart."""
        guard = Guard(answer.system.mesh, self.plan.scene, self._watched())
        for found in answer.path.points:
            guard.see(found)
        if guard.alarm is None or guard.at is None:
            return False
        self._switch_on(guard.alarm.name, guard.alarm.seen, guard.at.pressure)
        return True

    def _left_law_behind(self, level: Level, path: Path) -> bool:
        """Whether the true laws differ too much from those computed in the last state."""
        decision = self.plan.by_name["hyperelasticity"]
        if decision.on or decision.forced == "off" or not decision.change or not path.points:
            return False
        last = path.points[-1]
        change = law_difference(level.system, last.state)
        if change <= self.plan.threshold:
            return False
        words = (
            "switched on after a first run: the laws differed by "
            f"{percent(change)} in the energy at {kilopascals(last.pressure, 3)} kPa"
        )
        self.plan = self.plan.switched_on("hyperelasticity", words, change=change)
        return True

    def _stop(self, guard: Guard) -> Callable[[], Outcome | None]:
        return lambda: Outcome.CANCELLED if guard.alarm is not None else self._monitor.stop()

    def _seen(self, level: Level, guard: Guard) -> Callable[[Equilibrium], None]:
        def see(found: Equilibrium) -> None:
            guard.see(found)
            if guard.alarm is None:
                self._monitor.found(self._part.up_to(level.system, found, self.plan))

        return see

    def _begin(self, level: Level) -> None:
        scene = self.plan.applied
        loaded = scene.gravity or scene.tip_force or scene.outside_pressure
        first = "own weight and loads" if loaded else "first step"
        self._monitor.report(0.0, f"coarse mesh, {level.system.unknowns} unknowns: {first}")

    def _watch(self, share: float, pressure: float) -> None:
        message = f"coarse mesh at {kilopascals(pressure, 3)} kPa"
        self._monitor.report(SHARE_OF_PATH * share, message, pressure)


def until(path: Path, at: Equilibrium, before: Sequence[Equilibrium]) -> Path:
    """The part of a path up to the last of the states ``before`` the state ``at``, from which it is
    to go on. By their order: where the volume turns back, volumes tell nothing."""
    points = list(path.points)
    ends = [k for k, point in enumerate(points) if point is at]
    kept = points[: ends[0]] if ends else points
    if before:
        last = [k for k, point in enumerate(kept) if point is before[-1]]
        kept = kept[: last[0] + 1] if last else kept
    limit = path.limit
    if limit is not None and any(point is limit for point in points):
        limit = limit if any(point is limit for point in kept) else None
    by_arc = max(0, path.by_arc - (len(points) - len(kept)))
    leaps = [leap for leap in path.leaps if any(point is leap[1] for point in kept)]
    return replace(path, points=kept, limit=limit, beyond=None, by_arc=by_arc, leaps=leaps)


def joined(first: Path, rest: Path) -> Path:
    """``first`` and what was found after it."""
    return replace(
        rest,
        points=[*first.points, *rest.points],
        limit=first.limit or rest.limit,
        leaps=[*first.leaps, *rest.leaps],
        iterations=first.iterations + rest.iterations,
        by_arc=first.by_arc + len(rest.points) if first.by_arc else rest.by_arc,
    )
