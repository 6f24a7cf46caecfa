"""A worker whose rungs are slow on purpose: run as ``python -m tests.worker.slow_worker``.

``energy`` takes two seconds in forty steps, reports each and stops when told. ``closed-form``
takes a minute and is deaf. ``fe`` raises, after ten steps. All keep parts of their path soon.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from actuators.design import Design
from actuators.mechanics.response import Outcome, PathPoint, Response
from actuators.mechanics.scene import Scene
from worker import path_kept, presence
from worker.rungs import RUNGS, Report, Solved
from worker.start import main

STEPS = 40


@dataclass(frozen=True)
class Step:
    fraction: float
    message: str
    pressure: float | None


def straight(design: Design, scene: Scene, outcome: Outcome, steps: int) -> Response:
    """An answer that depends on the question alone: a body that does not bend."""
    tip = (design.length, 0.0, 0.0)
    path = tuple(
        PathPoint(scene.pressure_to * i / STEPS, tip, (0.0, 0.0, 0.0), 0.0, 0.0, 0.0, 0.0)
        for i in range(steps + 1)
    )
    return Response(design, scene, "energy", outcome, path)


def slow(
    design: Design,
    scene: Scene,
    *,
    accuracy: float,
    mesh: str | None,
    progress: Callable[[Report], None],
    cancelled: Callable[[], bool],
    found: Callable[[Callable[[], Response]], None],
) -> Solved:
    for step in range(STEPS):
        if cancelled():
            return Solved(straight(design, scene, Outcome.CANCELLED, step))
        found(partial(straight, design, scene, Outcome.CANCELLED, step))
        time.sleep(0.03)
        progress(Step((step + 1) / STEPS, f"step {step + 1}", scene.pressure_to * step / STEPS))
    return Solved(straight(design, scene, Outcome.CONVERGED, STEPS))


def deaf(design: Design, scene: Scene, **_: Any) -> Solved:
    time.sleep(60)
    return Solved(straight(design, scene, Outcome.CONVERGED, STEPS))


def broken(
    design: Design, scene: Scene, *, found: Callable[[Callable[[], Response]], None], **_: Any
) -> Solved:
    for step in range(10):
        found(partial(straight, design, scene, Outcome.CANCELLED, step))
    raise ZeroDivisionError("an element has no volume")


if __name__ == "__main__":
    presence.load_solver = lambda: None  # these rungs need no kernels
    path_kept.FIRST_S, path_kept.SHARE = 0.0, 1.0  # they sleep: no processor's time to speak of
    RUNGS.update({"energy": slow, "closed-form": deaf, "fe": broken})
    main()
