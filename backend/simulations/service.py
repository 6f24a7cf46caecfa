"""Instant answers over HTTP."""

import time

from actuators.mechanics.ladder import typical_error
from actuators.mechanics.response import Response
from backend.designs.question import read_design, read_scene
from backend.simulations.instant import answer, answer_in_part
from backend.simulations.schemas import (
    LeftOutLoad,
    Prediction,
    PredictRequest,
    ResultDocument,
    TypicalError,
)


def predict(body: PredictRequest) -> Prediction:
    """Read the question, answer it, and say how long each took."""
    return answered(body)[0]


def answered(body: PredictRequest) -> tuple[Prediction, Response]:
    """As :func:`predict`, and the science's own answer, which also knows the shape."""
    start = time.perf_counter()
    design, scene = read_design(body.design), read_scene(body.scene)
    read = time.perf_counter()
    if body.beyond == "refuse":
        response, left_out = answer(design, scene, rung=body.rung, c=body.c), ()
    else:
        response, left_out = answer_in_part(design, scene, rung=body.rung, c=body.c)
    solved = time.perf_counter()
    result = ResultDocument.model_validate(response.to_document())
    timings = {f"solve.{stage}": seconds * 1e3 for stage, seconds in response.timings.items()}
    timings["read"] = (read - start) * 1e3
    timings["solve"] = (solved - read) * 1e3
    timings["total"] = (time.perf_counter() - start) * 1e3
    prediction = Prediction(
        result=result,
        typical_errors=[
            None
            if each is None
            else TypicalError(
                half_below_percent=100 * each.half,
                four_of_five_below_percent=100 * each.most,
                source=each.source,
            )
            for each in typical_error(design, response)
        ],
        left_out=[LeftOutLoad(field=each.field, reason=each.reason) for each in left_out],
        timings_ms={name: round(value, 3) for name, value in timings.items()},
    )
    return prediction, response
