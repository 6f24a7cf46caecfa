"""Which solver computes which rung: the one seam between the queue and the science.

Solvers are imported when first used, so that a worker starts fast and a child pays only for what
it computes. Tests replace entries of ``RUNGS``.
"""

from collections.abc import Callable
from typing import Protocol

from actuators.design import Design
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Scene


class Report(Protocol):
    """What a solver tells while it runs: as ``continuum.Progress``."""

    @property
    def fraction(self) -> float: ...
    @property
    def message(self) -> str: ...
    @property
    def pressure(self) -> float | None: ...


class Solver(Protocol):
    """Answers a question; calls ``progress`` now and then and stops soon after ``cancelled()``.

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
    ) -> Response: ...


def _fe(
    design: Design,
    scene: Scene,
    *,
    accuracy: float,
    mesh: str | None,
    progress: Callable[[Report], None],
    cancelled: Callable[[], bool],
) -> Response:
    from actuators.mechanics import continuum

    return continuum.solve(
        design, scene, accuracy=accuracy, mesh=mesh, progress=progress, cancelled=cancelled
    )


def _instant(rung: str) -> Solver:
    def solve(
        design: Design,
        scene: Scene,
        *,
        accuracy: float,
        mesh: str | None,
        progress: Callable[[Report], None],
        cancelled: Callable[[], bool],
    ) -> Response:
        from actuators.mechanics.predict import predict

        return predict(design, scene, rung=rung)

    return solve


RUNGS: dict[str, Solver] = {
    "fe": _fe,
    "cell-rod": _instant("cell-rod"),
    "energy": _instant("energy"),
    "closed-form": _instant("closed-form"),
}
