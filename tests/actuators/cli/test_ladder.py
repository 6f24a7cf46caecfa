"""``pneustudio ladder``: error against seconds, rung by rung."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from actuators.cli import main
from actuators.cli.past_jobs import remember
from actuators.design import preset
from actuators.mechanics.ladder import Rung
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.scene import Scene

SMALL = ("slab-rectangle-low", "--set", "chamber_count=2", "--set", "length=35mm")


def run(*arguments: str) -> Result:
    return CliRunner().invoke(main, ["ladder", *arguments])


def answer(*arguments: str) -> Any:
    result = run(*arguments, "--json")
    assert result.exit_code == 0, result.stderr
    return json.loads(result.stdout)


def by_label(document: Any) -> dict[str, Any]:
    return {point["label"]: point for point in document["points"]}


def test_instant_rungs_run_and_the_others_are_predicted() -> None:
    document = answer(*SMALL, "--pressure", "3kPa", "--run", "none", "--at-most", "5%",
                      "--at-most", "1000s")  # fmt: skip
    points = by_label(document)
    assert points["energy"]["state"] == "measured"
    assert points["fe 2 %"]["state"] == "predicted"
    assert points["fe 2 %"]["seconds"]["low"] < points["fe 2 %"]["seconds"]["high"]
    assert [choice["rung"] for choice in document["choices"]] == ["fe 5 %", "fe 1 %"]
    assert (document["budget_s"], document["learned_from_jobs"]) == (None, 0)


def test_finite_elements_run_are_measured_and_remembered(own_folder: Path) -> None:
    document = answer(*SMALL, "--pressure", "3kPa", "--run", "fe:30%")
    points = by_label(document)
    ran, energy = points["fe 30 %"], points["energy"]
    best = points[document["best"]]
    assert ran["outcome"] == "converged"
    assert ran["seconds"]["value"] > 0
    assert best["error_percent"]["high"] <= ran["error_percent"]["high"] <= 30
    assert energy["error_kind"] == "against best"
    apart, band = energy["apart_percent"]["tip"], best["error_percent"]["high"]
    assert energy["error_percent"]["high"] == pytest.approx(apart + band)
    assert document["learned_from_jobs"] == 1
    (own_folder / "past_jobs.jsonl").open("a").write("not a job\n")
    again = answer(*SMALL, "--pressure", "3kPa", "--run", "none")
    assert again["learned_from_jobs"] == 1


def test_what_was_stopped_is_expected_to_take_longer(own_folder: Path) -> None:
    """The next command has learnt from it, though it is no job that ended."""
    wanted = (*SMALL, "--pressure", "3kPa", "--run", "none")
    before = by_label(answer(*wanted))["fe 10 %"]["seconds"]
    design = preset(SMALL[0]).design.changed(chamber_count=2, length=35.0)
    stopped = Response(
        design, Scene(3e3), "fe", Outcome.BUDGET_SPENT, (), wall_s=300.0, cpu_s=200.0, unknowns=0
    )
    remember(stopped, Rung("fe", 0.1))
    document = answer(*wanted)
    assert by_label(document)["fe 10 %"]["seconds"]["value"] > 10 * before["value"]
    assert document["learned_from_jobs"] == 0


def test_the_first_job_of_a_process_is_remembered_without_its_loading(own_folder: Path) -> None:
    design = preset("slab-rectangle-low").design
    short = Response(
        design, Scene(3e3), "fe", Outcome.CONVERGED, (), wall_s=4.0, cpu_s=2.0, unknowns=3199,
        timings={"set_up": 3.0, "coarse_path": 1.0},
    )  # fmt: skip
    remember(short, Rung("fe", 0.3), is_first=True)
    assert not (own_folder / "past_jobs.jsonl").exists()
    remember(replace(short, wall_s=12.0, cpu_s=8.0), Rung("fe", 0.3), is_first=True)
    remember(replace(short, cpu_s=None), Rung("fe", 0.3))
    remember(replace(short, outcome=Outcome.CANCELLED), Rung("fe", 0.3))
    lines = map(json.loads, (own_folder / "past_jobs.jsonl").read_text().splitlines())
    kept = [(line["seconds"], line.get("stopped", False)) for line in lines]
    assert kept == [(6.0, False), (4.0, False), (2.0, True)]


def test_a_budget_that_nothing_fits_runs_nothing_and_is_stated() -> None:
    result = run(*SMALL, "--pressure", "3kPa", "--budget", "1ms")
    assert result.exit_code == 0, result.stderr
    assert "Finite elements were given 0.001 s in all" in result.stdout
    assert "~" in result.stdout
    assert "energy leaves out: large strain" in result.stdout


def test_a_load_that_an_instant_rung_cannot_carry_is_told(tmp_path: Path) -> None:
    scene = tmp_path / "scene.json"
    scene.write_text('{"pressure_kPa": {"to": 3}, "plate": {"gap_mm": 1}}')
    points = by_label(answer(*SMALL, "--scene", str(scene), "--run", "none"))
    assert points["closed-form"]["state"] == "refused"
    assert "plate is 1 mm away" in points["closed-form"]["reason"]
    assert points["fe 5 %"]["state"] == "predicted"


@pytest.mark.parametrize(
    ("arguments", "field"),
    [
        (("--at-most", "2"), "at-most"),
        (("--at-most", "0%"), "at-most"),
        (("--at-most", "-3s"), "at-most"),
        (("--budget", "30"), "budget"),
        (("--budget", "0s"), "budget"),
        (("--run", "magic"), "run"),
        (("--run", "fe:5"), "accuracy"),
        (("--run", "fe:0%"), "accuracy"),
        (("--run", "fe:2%,fe:-5%"), "accuracy"),
        (("--run", "fe:101%"), "accuracy"),
        (("--effect", "magic=off"), "effects"),
    ],
)
def test_bad_limits_are_told_with_their_field(arguments: tuple[str, ...], field: str) -> None:
    result = run(*SMALL, "--pressure", "3kPa", *arguments, "--json")
    assert result.exit_code == 2, result.output
    assert json.loads(result.stderr)["error"]["field"] == field


def test_accuracies_are_refused_in_percent() -> None:
    result = run(*SMALL, "--pressure", "3kPa", "--run", "fe:0%")
    assert "accuracy is '0%'; it must lie between 0.01 % and 100 %" in result.stderr


def test_a_run_that_outlasts_its_budget_says_when_it_was_stopped() -> None:
    result = run(*SMALL, "--pressure", "3kPa", "--run", "fe:1%", "--budget", "10ms")
    assert result.exit_code == 0, result.stderr
    row = next(line for line in result.stdout.splitlines() if line.startswith("fe 1 %"))
    assert "stopped after" in row
    chosen = next(line for line in result.stdout.splitlines() if line.startswith("Chosen"))
    assert "fe 1 %" not in chosen


def test_a_limit_reports_the_rung_that_ran_for_it() -> None:
    document = answer(*SMALL, "--pressure", "3kPa", "--at-most", "30%", "--at-most", "2%",
                      "--budget", "1000s")  # fmt: skip
    points = by_label(document)
    for choice in document["choices"]:
        assert points[choice["rung"]]["state"] == "measured"
    assert "ran for it" in document["choices"][1]["why"]


def test_the_table_says_where_a_limit_point_ends_the_best_answer() -> None:
    result = run("slab-rectangle-low", "--pressure", "60kPa", "--run", "none", "--at-most", "100%")
    lines = {line.split("  ")[0]: line for line in result.stdout.splitlines()}
    assert "limit point, best up to there" in lines["cell-rod"]
    assert "contradicted" in lines["energy"]
    assert "ends at a limit point" in result.stdout
    assert "sag under weight" in result.stdout
    assert "at most 100 %: cell-rod" in result.stdout


def test_an_effect_is_forced_as_in_predict() -> None:
    asked = (*SMALL, "--pressure", "3kPa", "--run", "none")
    free, heavy = answer(*asked, "--effect", "gravity=off"), answer(*asked)
    assert free["scene"]["effects"] == {"gravity": "off"}
    tips = [by_label(d)["energy"]["tip_displacement_mm"] for d in (free, heavy)]
    assert tips[0] != tips[1]


def test_the_best_of_answers_that_are_worth_little_says_so() -> None:
    (words,) = [
        line
        for line in run(*SMALL, "--pressure=-6kPa", "--run", "none").stdout.splitlines()
        if line.startswith("Best answer so far")
    ]
    assert "cell-rod, which may be anywhere there by its own estimate" in words
