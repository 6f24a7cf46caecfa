"""Any design that can be built, in any scene: an answer or a named outcome, in time and memory."""

import resource
import time
import warnings

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from actuators.design import Design
from actuators.errors import QuestionError
from actuators.hard_cases.case import Budget
from actuators.hard_cases.verdict import always
from actuators.mechanics.continuum.progress import Budget as Allowance
from actuators.mechanics.continuum.progress import Monitor
from actuators.mechanics.continuum.solve import solve_with_states
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Scene
from tests.hard_cases.wild import full_scenes, plain_scenes, wild_designs

INSTANT = Budget(seconds=5.0, iterations=20000)
"""Processor time of an instant answer: a wide cell of an oblique body takes a second, the rest is
for machines that are slower and busy. An iteration of a rod takes 50 us."""
SOLID = Budget(seconds=60.0, iterations=250, memory_mib=4000.0)


def judged(answer: Response, seconds: float, budget: Budget) -> None:
    assert list(always(answer, seconds, budget)) == []
    used = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    assert used < budget.memory_mib


def instant(design: Design, scene: Scene, rung: str) -> None:
    begun = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        answer = predict(design, scene, rung=rung)
    judged(answer, time.process_time() - begun, INSTANT)


def solid(design: Design, scene: Scene) -> None:
    begun = time.process_time()
    budget = Allowance(8 * SOLID.seconds, SOLID.iterations, SOLID.memory_mib * 2**20)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            answer = solve_with_states(design, scene, Monitor(budget=budget), mesh="coarse")
        except QuestionError as refused:
            # a cylinder that reaches into the undeformed body is no question
            if refused.field == "cylinder":
                return
            raise
    judged(answer.response, time.process_time() - begun, SOLID)


RUNGS = st.sampled_from(["closed-form", "energy"])


@settings(max_examples=100)
@given(design=wild_designs(), scene=plain_scenes(), rung=RUNGS)
def test_a_hundred_wild_designs_are_answered_at_once(
    design: Design, scene: Scene, rung: str
) -> None:
    instant(design, scene, rung)


@settings(max_examples=5)
@given(design=wild_designs(most_chambers=2), scene=full_scenes())
def test_a_few_wild_designs_are_solved_in_3d(design: Design, scene: Scene) -> None:
    solid(design, scene)


@pytest.mark.slow
@pytest.mark.timeout(7200)
@settings(max_examples=2000)
@given(design=wild_designs(), scene=plain_scenes(), rung=RUNGS)
def test_two_thousand_wild_designs_are_answered_at_once(
    design: Design, scene: Scene, rung: str
) -> None:
    instant(design, scene, rung)


@pytest.mark.slow
@pytest.mark.timeout(36000)
@settings(max_examples=200)
@given(design=wild_designs(most_chambers=3), scene=full_scenes())
def test_two_hundred_wild_designs_are_solved_in_3d(design: Design, scene: Scene) -> None:
    solid(design, scene)
