"""Which solver computes which rung: the one seam between the queue and the science.

Solvers are imported when first used, so that a worker starts fast and a child pays only for what
it computes. Tests replace entries of ``RUNGS``.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from actuators.design import Design
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Scene
from storage import BodyFiles


class Report(Protocol):
    """What a solver tells while it runs: as ``continuum.Progress``."""

    @property
    def fraction(self) -> float: ...
    @property
    def message(self) -> str: ...
    @property
    def pressure(self) -> float | None: ...


@dataclass(frozen=True, eq=False)
class Solved:
    """A response; ``body_files`` makes the fields in the whole body, in at most so many bytes, or
    None where they take more. Left out where the rung has no such fields."""

    response: Response
    body_files: Callable[[int], BodyFiles | None] | None = None


class Solver(Protocol):
    """Answers a question; calls ``progress`` now and then and stops soon after ``cancelled()``.
    ``found`` is offered what makes an answer of the path found so far.

    ``mesh``: the one mesh to solve on, by name or layers; None to refine to ``accuracy``.
    """

    def __call__(
        self,
        design: Design,
        scene: Scene,
        *,
        accuracy: float,
        mesh: str | None,
        progress: Callable[[Report], None],
        cancelled: Callable[[], bool],
        found: Callable[[Callable[[], Response]], None],
    ) -> Solved: ...


def _fe(
    design: Design,
    scene: Scene,
    *,
    accuracy: float,
    mesh: str | None,
    progress: Callable[[Report], None],
    cancelled: Callable[[], bool],
    found: Callable[[Callable[[], Response]], None],
) -> Solved:
    from actuators.export.whole_body import WholeBody
    from actuators.mechanics.continuum.progress import Monitor
    from actuators.mechanics.continuum.solve import solve_with_states

    monitor = Monitor(progress, cancelled, None, found)
    solution = solve_with_states(design, scene, monitor, accuracy=accuracy, mesh=mesh)

    def body_files(at_most: int) -> BodyFiles | None:
        made = WholeBody(solution).archive(at_most=at_most)
        return None if made is None else BodyFiles(made.zipped, len(made.points))

    return Solved(solution.response, body_files)


def _instant(rung: str) -> Solver:
    def solve(
        design: Design,
        scene: Scene,
        *,
        accuracy: float,
        mesh: str | None,
        progress: Callable[[Report], None],
        cancelled: Callable[[], bool],
        found: Callable[[Callable[[], Response]], None],
    ) -> Solved:
        from actuators.mechanics.predict import predict

        return Solved(predict(design, scene, rung=rung))

    return solve


RUNGS: dict[str, Solver] = {
    "fe": _fe,
    "cell-rod": _instant("cell-rod"),
    "energy": _instant("energy"),
    "closed-form": _instant("closed-form"),
}
