"""What is said of an answer that was stopped."""

from dataclasses import replace

import pytest

from actuators.design import preset
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.scene import Scene
from storage.rows import ClaimedJob
from worker.keeper import Stop
from worker.solving import part_found

DESIGN = preset("slab-rectangle-low").design
JOB = ClaimedJob("a", 1, {}, {}, "fe", 0.01, "", 120.0, None)


def stopped(points: int) -> Response:
    whole = predict(DESIGN, Scene(4e3, steps=4), rung="energy")
    return replace(whole, outcome=Outcome.CANCELLED, path=whole.path[:points])


@pytest.mark.parametrize(
    ("points", "stop", "said", "not_said"),
    [
        (3, "cancel", "the rest of the path", "accuracy"),
        (5, "cancel", "the accuracy asked for", "rest"),
        (3, "budget", "the part of the path found", "coarser mesh"),
        (5, "budget", "a coarser mesh than asked for", "part"),
    ],
)
def test_what_is_missing_is_the_rest_of_the_path_or_its_accuracy(
    points: int, stop: Stop, said: str, not_said: str
) -> None:
    answer = part_found(stopped(points), JOB, stop)
    assert answer.outcome is (Outcome.BUDGET_SPENT if stop == "budget" else Outcome.CANCELLED)
    assert answer.advice is not None
    assert said in answer.advice
    assert not_said not in answer.advice
