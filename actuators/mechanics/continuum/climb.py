"""From the path on the coarsest mesh to an answer as accurate as asked for."""

from collections.abc import Sequence
from itertools import count

from actuators.geometry import Body
from actuators.mechanics.continuum.estimates import JUDGED, change, estimates, measure
from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.level import Level, condensed_size, open_level
from actuators.mechanics.continuum.levels import Layers
from actuators.mechanics.continuum.memory import memory_needed
from actuators.mechanics.continuum.path import Path
from actuators.mechanics.continuum.progress import Monitor
from actuators.mechanics.continuum.recovery import Answer
from actuators.mechanics.continuum.refinement import Anchor, Refinement, shared_points
from actuators.mechanics.response import Outcome
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh, mesh_body
from actuators.meshing.counting import condensed_unknowns

MOST_UNKNOWNS = 400_000
"""Largest system this version factorises (322,000 unknowns of an oblique half took 4 GB)."""
SHARE_OF_PATH = 0.4
"""Part of the progress bar that the coarse path takes."""
LAST_SHARE = 0.95


class Climb:
    """One path carried up the ``ladder`` of meshes."""

    def __init__(
        self,
        body: Body,
        scene: Scene,
        ladder: Sequence[Layers],
        goal: Goal,
        monitor: Monitor,
    ) -> None:
        self._body, self._scene, self._ladder = body, scene, ladder
        self._goal, self._monitor = goal, monitor

    def answer(self, coarse: Level, path: Path, accuracy: float) -> Answer:
        """Solve the anchor on finer and finer meshes until the estimated errors are below
        ``accuracy``; then the whole path on the last one."""
        answer = Answer(coarse.system, path, {}, path.iterations, None, len(path.points))
        if path.loads < 1.0 or path.outcome in (Outcome.CANCELLED, Outcome.BUDGET_SPENT):
            return answer
        shared = shared_points(path)
        before = Anchor(coarse.system, path.points[shared - 1])
        limit = path.limit.pressure if path.limit is not None else None
        measured = measure(before.system, before.found, limit)
        best: tuple[Refinement, Anchor, Path | None] | None = None
        for number, layers in enumerate(self._ladder):
            size = condensed_unknowns(self._body, layers)
            if size > MOST_UNKNOWNS or memory_needed(size) > self._monitor.room():
                answer.too_large = size
                break
            mesh = mesh_body(self._body, layers=layers)
            refinement = self._refinement(number, mesh, coarse, path, shared)
            anchor = refinement.anchor(before)
            if refinement.shared < shared:
                shared = refinement.shared
                before = Anchor(coarse.system, path.points[shared - 1])
                measured = measure(before.system, before.found, measured.limit_pressure)
            rest = self._beyond(refinement, anchor)
            answer.iterations += refinement.iterations
            answer.stopped = self._monitor.stop()
            if anchor is None or answer.stopped is not None:
                break
            limit = refinement.limit_pressure(anchor, rest)
            finer = measure(anchor.system, anchor.found, limit)
            moved = change(measured, finer)
            answer.errors = estimates(moved, layers, walls_meet=finer.walls_meet)
            before, measured, best = anchor, finer, (refinement, anchor, rest)
            if all(answer.errors.get(name, 0.0) <= accuracy for name in JUDGED):
                break
        if answer.stopped is not None:
            answer.errors = {}
        elif best is not None:
            self._finish(answer, *best, accuracy)
        return answer

    def _refinement(
        self, number: int, mesh: HexMesh, coarse: Level, path: Path, shared: int
    ) -> Refinement:
        base = SHARE_OF_PATH + (LAST_SHARE - SHARE_OF_PATH) * number / len(self._ladder)
        message = f"finer mesh, {condensed_size(mesh)} unknowns"
        self._monitor.report(base, message)

        def watch(share: float) -> None:
            self._monitor.report(base + (LAST_SHARE - base) * share, message)

        taken = count(1)

        def stop() -> Outcome | None:  # asked before every iteration, which may take seconds
            reason = self._monitor.stop()
            if reason is None:
                self._monitor.report(base, f"{message}, iteration {next(taken)}")
            return reason

        fine = open_level(mesh, self._scene)
        return Refinement(
            coarse.system, fine.system, fine.solver, path, shared=shared, stop=stop, watch=watch
        )

    def _beyond(self, refinement: Refinement, anchor: Anchor | None) -> Path | None:
        if anchor is None:
            return None
        return refinement.beyond(anchor, self._goal)

    def _finish(
        self,
        answer: Answer,
        refinement: Refinement,
        anchor: Anchor,
        rest: Path | None,
        accuracy: float,
    ) -> None:
        spent = refinement.iterations
        refined = refinement.whole_path(anchor, rest, accuracy)
        answer.iterations += refinement.iterations - spent
        answer.system, answer.path, answer.solved = anchor.system, refined.path, refined.solved
        answer.stopped = self._monitor.stop()
