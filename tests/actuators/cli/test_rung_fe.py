"""The rung fe from the command line: what it asks the solver, and how it tells what it hears."""

import json
import os
import re
import signal
from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest
from click.testing import CliRunner

from actuators.cli import main
from actuators.design import Design
from actuators.mechanics import continuum
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.scene import Scene

ARGUMENTS = ("predict", "slab-rectangle-low", "--pressure", "3kPa", "--rung", "fe")


class Solver:
    """Stands in for the 3D solver, which takes seconds: notes the question, answers by the rod."""

    def __init__(self, outcome: Outcome = Outcome.CONVERGED, *, interrupt: bool = False) -> None:
        self.outcome, self.interrupt = outcome, interrupt
        self.asked: dict[str, Any] = {}

    def __call__(
        self,
        design: Design,
        scene: Scene,
        *,
        progress: Callable[[Any], None],
        cancelled: Callable[[], bool],
        **options: Any,
    ) -> Response:
        self.asked = {"design": design, "scene": scene, **options}
        progress(SimpleNamespace(fraction=0.5, message="half way", pressure=1500.0))
        assert not cancelled()
        if self.interrupt:
            os.kill(os.getpid(), signal.SIGINT)
            assert cancelled()
        found = predict(design, scene, steps=2)
        return replace(found, rung="fe", outcome=self.outcome, error_estimate=0.012)


def ask(monkeypatch: pytest.MonkeyPatch, solver: Solver, *arguments: str):
    monkeypatch.setattr(continuum, "solve", solver, raising=False)
    return CliRunner().invoke(main, [*ARGUMENTS, *arguments])


def test_progress_goes_to_standard_error_and_the_answer_to_standard_output(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    result = ask(monkeypatch, Solver(), "--json")
    assert result.exit_code == 0
    document = json.loads(result.stdout)
    assert document["rung"] == "fe"
    assert document["error_estimate_percent"] == pytest.approx(1.2)
    assert "50 %  half way" in result.stderr
    expected = re.search(r"Expected to take (\S+) s \(.*: (\S+) to (\S+) s\)", result.stderr)
    assert expected is not None
    seconds, low, high = (float(number) for number in expected.groups())
    assert 0.0 < low <= seconds <= high


def test_accuracy_is_a_fraction_for_the_solver(monkeypatch: pytest.MonkeyPatch) -> None:
    solver = Solver()
    assert ask(monkeypatch, solver, "--accuracy", "2%").exit_code == 0
    assert solver.asked["accuracy"] == pytest.approx(0.02)
    assert solver.asked["scene"].pressure_to == pytest.approx(3e3)


def test_a_mesh_is_passed_on_and_only_the_3d_rung_has_one(monkeypatch: pytest.MonkeyPatch) -> None:
    solver = Solver()
    assert ask(monkeypatch, solver, "--mesh", "1,0,1").exit_code == 0
    assert solver.asked["mesh"] == "1,0,1"
    refused = CliRunner().invoke(
        main, ["predict", "slab-rectangle-low", "--pressure", "3kPa", "--mesh", "fine"]
    )
    assert refused.exit_code != 0
    assert "has no mesh to choose" in refused.stderr


@pytest.mark.parametrize("outcome", [Outcome.LIMIT_POINT, Outcome.STALLED])
def test_an_answer_that_ended_early_is_still_an_answer(
    monkeypatch: pytest.MonkeyPatch, outcome: Outcome
) -> None:
    result = ask(monkeypatch, Solver(outcome))
    assert result.exit_code == 0
    assert outcome.value in result.stdout


def test_the_first_interrupt_asks_for_what_there_is(monkeypatch: pytest.MonkeyPatch) -> None:
    before = signal.getsignal(signal.SIGINT)
    result = ask(monkeypatch, Solver(Outcome.CANCELLED, interrupt=True))
    assert result.exit_code == 0
    assert "cancelled" in result.stdout
    assert "Ctrl-C again" in result.stderr
    assert signal.getsignal(signal.SIGINT) is before


def test_an_empty_path_is_told_in_words(monkeypatch: pytest.MonkeyPatch) -> None:
    def solver(design: Design, scene: Scene, **_: Any) -> Response:
        return Response(design, scene, "fe", Outcome.CANCELLED, path=(), advice="Ask again.")

    monkeypatch.setattr(continuum, "solve", solver, raising=False)
    result = CliRunner().invoke(main, list(ARGUMENTS))
    assert result.exit_code == 0
    assert "No point of the path was found." in result.stdout
    assert "Ask again." in result.stdout
