"""Over all designs that can be built: an answer, finite, without a warning."""

import warnings

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from actuators.design import Design
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Outcome
from actuators.mechanics.scene import Scene
from tests.actuators.design_space import designs


@settings(max_examples=40)
@given(design=designs(), kilopascals=st.sampled_from([0.0, 3.0, 40.0, 500.0]))
def test_every_design_gets_a_finite_answer_or_a_named_outcome(
    design: Design, kilopascals: float
) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        answer = predict(design, Scene(kilopascals * 1e3))
    assert answer.outcome in (Outcome.CONVERGED, Outcome.STALLED)
    assert (answer.advice is None) == (answer.outcome is Outcome.CONVERGED)
    assert answer.centreline is not None
    assert np.all(np.isfinite(answer.centreline.positions))
    assert np.all(np.isfinite(answer.centreline.frames))
    for point in answer.path:
        assert point.curvature is not None
        assert np.isfinite([*point.tip, point.curvature, point.bending_angle]).all()


@settings(max_examples=60)
@given(design=designs())
def test_every_design_has_a_finite_closed_form(design: Design) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        answer = predict(design, Scene(20e3), rung="closed-form")
    assert answer.path[-1].curvature is not None
    assert np.isfinite(answer.path[-1].curvature)
