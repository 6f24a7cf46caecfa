"""The rungs that answer while a slider moves."""

from typing import Literal

from actuators.design import PRESETS, Design
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Scene

InstantRung = Literal["closed-form", "energy"]


def answer(
    design: Design,
    scene: Scene,
    *,
    rung: InstantRung = "energy",
    c: Literal["computed", "published"] | float = "computed",
) -> Response:
    """Response of an instant rung; raises InputError for a question it cannot answer."""
    return predict(design, scene, rung=rung, c=c)


def warm() -> None:
    """Answer one question, so that the first one asked finds compiled kernels in memory."""
    first = next(iter(PRESETS.values()))
    answer(first.design, Scene(first.pressure_to))
