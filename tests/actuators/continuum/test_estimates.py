"""Error estimates, and the meshes they lead to."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from actuators.design import preset
from actuators.errors import QuestionError
from actuators.geometry import build_body
from actuators.mechanics.continuum import climb
from actuators.mechanics.continuum.estimates import (
    SAFETY,
    Measured,
    change,
    estimates,
    measure,
)
from actuators.mechanics.continuum.levels import LEVELS, LEVELS_WITH_GAPS, layers_of, levels_of
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.refinement import Anchor, Refinement
from actuators.mechanics.continuum.solve import solve
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.direct_solver import SymmetricSolver, open_solver
from actuators.mechanics.scene import Scene
from actuators.meshing import mesh_body
from benchmarks.mini_pneu_net import (
    GRAVITY,
    MATERIALS,
    PRESSURE,
    REFERENCE_TIP,
    mini_pneu_net,
)
from benchmarks.true_errors import PROBLEMS, Ladder

HERE = Measured(
    tip=np.array([0.0, 0.0, -0.04]), angle=0.8, growth=2e-6, size=0.1, rest_volume=1e-5,
    force=0.5, limit_pressure=10e3,
)  # fmt: skip


def test_changes_are_fractions_of_the_later_answer() -> None:
    before = replace(
        HERE, tip=np.array([0.003, 0.0, -0.036]), angle=0.76, growth=1.8e-6, force=0.45,
        limit_pressure=11e3,
    )  # fmt: skip
    assert change(before, HERE) == pytest.approx(
        {"tip": 0.125, "angle": 0.05, "volume": 0.1, "force": 0.1, "limit_pressure": 1 / 11}
    )


def test_a_body_that_hardly_turns_has_no_large_error_of_turning() -> None:
    twisted = replace(HERE, angle=0.002)
    assert change(replace(twisted, angle=0.001), twisted)["angle"] == pytest.approx(0.001 / 0.4)
    still = replace(HERE, tip=np.zeros(3), angle=0.0)
    assert change(still, still)["tip"] == 0.0


def test_quantities_that_are_not_there_have_no_estimate() -> None:
    free = replace(HERE, force=None, limit_pressure=None)
    assert set(change(free, free)) == {"tip", "angle", "volume"}
    assert "force" not in change(free, HERE), "no plate on one side, nothing to compare"


def test_directions_that_were_not_refined_owe_as_much_again() -> None:
    for layers, owed in (((1, 0, 0), 3), ((1, 0, 1), 2), ((1, 1, 1), 1), ((2, 2, 2), 1)):
        assert estimates({"tip": 0.05}, layers)["tip"] == pytest.approx(0.05 * SAFETY * owed)


def test_a_small_change_in_one_direction_is_no_small_error() -> None:
    quiet = {"tip": 1e-4, "volume": 1e-3}
    assert estimates(quiet, (0, 1, 0))["tip"] == pytest.approx(0.02)
    assert estimates(quiet, (0, 1, 0))["volume"] > 0.108, "what oblique-90 hides at 5 kPa"
    assert estimates(quiet, (1, 1, 1))["tip"] == pytest.approx(SAFETY * 1e-4)


def test_estimates_are_not_below_the_true_error_of_the_mini_pneu_net() -> None:
    def open_layers(layers: tuple[int, int, int]) -> tuple[ContinuumSystem, SymmetricSolver]:
        mesh = mesh_body(mini_pneu_net().half(), layers=layers)
        system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh), gravity=GRAVITY)
        return system, open_solver(system.indptr, system.indices)

    system, solver = open_layers((0, 0, 0))
    path = PathFollower(system, solver).follow(PRESSURE, None)
    at = Anchor(system, path.points[-1])
    for layers in ((1, 0, 0), (1, 0, 1), (1, 1, 1)):
        fine, solver = open_layers(layers)
        finer = Refinement(system, fine, solver, path).anchor(at)
        assert finer is not None
        last = change(measure(at.system, at.found), measure(finer.system, finer.found))
        down = -measure(finer.system, finer.found).tip[2]
        true = abs(down / REFERENCE_TIP - 1)
        assert true < estimates(last, layers)["tip"] < 8 * true
        at = finer


def test_the_accuracy_asked_for_chooses_the_mesh() -> None:
    design, scene = preset("slab-rectangle-low").design, Scene(3e3)
    rough = solve(design, scene, accuracy=0.1)
    better = solve(design, scene, accuracy=0.015)
    assert better.unknowns > rough.unknowns
    for response, accuracy in ((rough, 0.1), (better, 0.015)):
        errors = response.error_estimates
        assert errors["tip"] == response.error_estimate
        assert max(errors["tip"], errors["angle"]) <= accuracy
        assert errors["volume"] > 0
        assert not any("was not reached" in note for note in response.notes)
    change_of_tip = np.linalg.norm(
        np.subtract(rough.path[-1].tip_displacement, better.path[-1].tip_displacement)
    ) / np.linalg.norm(better.path[-1].tip_displacement)
    assert change_of_tip < rough.error_estimates["tip"]


def test_a_mesh_that_is_asked_for_is_taken() -> None:
    design, scene = preset("slab-rectangle-low").design, Scene(2e3)
    coarse = solve(design, scene, mesh="coarse")
    assert coarse.error_estimates == {}
    assert coarse.error_estimate is None
    assert any("no error estimate" in note for note in coarse.notes)
    medium = solve(design, scene, mesh="medium", accuracy=1e-4)
    assert medium.unknowns == solve(design, scene, mesh="1,0,0").unknowns > coarse.unknowns
    assert not any("was not reached" in note for note in medium.notes)


def test_points_between_solved_ones_are_as_good_as_solved() -> None:
    design, scene = preset("slab-rectangle-low").design, Scene(4e3)
    quick = solve(design, scene, mesh=(1, 0, 0), accuracy=0.05)
    thorough = solve(design, scene, mesh=(1, 0, 0), accuracy=1e-4)
    assert any("interpolated" in note for note in quick.notes)
    tips = np.array([[p.tip for p in r.path] for r in (quick, thorough)])
    travel = np.linalg.norm(thorough.path[-1].tip_displacement)
    assert np.abs(tips[0] - tips[1]).max() < 0.05 / 10 * travel


def test_points_between_solved_ones_are_as_good_where_a_body_sags_far() -> None:
    """Weight moves the tip by 35 mm, suction by 0.3 mm: what is interpolated is held against that.
    Held against 35 mm, the end's angle wobbled by 0.05 degrees."""
    design = preset("slab-rectangle-low").design
    scene = Scene(-4e3, effects={"hyperelasticity": "on"})
    quick = solve(design, scene, mesh=(1, 0, 0), accuracy=0.05)
    thorough = solve(design, scene, mesh=(1, 0, 0), accuracy=1e-4)
    assert any("interpolated" in note for note in quick.notes)
    tips = np.array([[p.tip_displacement for p in r.path] for r in (quick, thorough)])
    way = np.linalg.norm(tips[1] - tips[1, 0], axis=1).max()
    assert way < 0.02 * np.linalg.norm(tips[1, 0])
    assert np.abs(tips[0] - tips[1]).max() < 0.05 / 10 * way + 2e-6
    angles = np.degrees([[p.bending_angle for p in r.path] for r in (quick, thorough)])
    assert np.abs(angles[0] - angles[1]).max() < 0.01


def test_a_mesh_too_large_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(climb, "MOST_UNKNOWNS", 12_000)
    response = solve(preset("slab-rectangle-low").design, Scene(2e3), accuracy=0.001)
    assert 0 < response.unknowns <= 12_000
    assert any("was not reached" in n and "more than this version" in n for n in response.notes)


def test_meshes_have_names_and_layers() -> None:
    slab = build_body(preset("slab-rectangle-low").design)
    oblique = build_body(preset("oblique-45").design)
    assert levels_of(slab) == LEVELS
    assert levels_of(oblique) == LEVELS_WITH_GAPS
    for body in (slab, oblique):
        ladder = levels_of(body)
        assert layers_of(body, "coarse") == ladder[0]
        assert layers_of(body, "finest") == ladder[-1]
        assert layers_of(body, " 1, 0,2") == layers_of(body, (1, 0, 2)) == (1, 0, 2)
    for bad in ("huge", "1,1", "1,1,9", (0, 0, 7)):
        with pytest.raises(QuestionError) as caught:
            layers_of(slab, bad)
        assert caught.value.field == "mesh"


def test_directions_not_refined_count_six_percent_where_walls_press(tmp_path: Path) -> None:
    """Two chambers of oblique-90: the first halving changes the tip by 0.9 % and hides 11 %."""
    problem = PROBLEMS["straight"]
    measured = Ladder(problem, tmp_path).measured([(0, 1, 0), (0, 1, 1), (1, 1, 1)])
    best = measured[1, 1, 1]
    assert all(each.walls_meet for each in measured.values())
    for before, layers in (((0, 0, 0), (0, 1, 0)), ((0, 1, 0), (0, 1, 1))):
        moved = change(measured[before], measured[layers])
        true = change(measured[layers], best)
        said = estimates(moved, layers, walls_meet=True)
        for name in ("tip", "angle"):
            assert true[name] <= said[name]
            assert said[name] >= 0.06 * layers.count(0)
    # without the rule the first estimate would be below a third of the true error
    moved = change(measured[0, 0, 0], measured[0, 1, 0])
    true = change(measured[0, 1, 0], best)
    assert estimates(moved, (0, 1, 0))["tip"] < true["tip"] / 3


@pytest.mark.slow
def test_the_accuracy_asked_for_refines_where_walls_press() -> None:
    problem = PROBLEMS["straight"]
    rough, better = (
        solve(problem.design, problem.scene, accuracy=accuracy) for accuracy in (0.15, 0.05)
    )
    assert better.unknowns > 2 * rough.unknowns
    for response, accuracy in ((rough, 0.15), (better, 0.05)):
        errors = response.error_estimates
        assert max(errors["tip"], errors["angle"]) <= accuracy
        assert (response.path[-1].max_contact_pressure or 0.0) > 0.0
    tips = [np.array(response.path[-1].tip_displacement) for response in (rough, better)]
    off = np.linalg.norm(tips[0] - tips[1]) / np.linalg.norm(tips[1])
    assert 0.05 < off < rough.error_estimates["tip"] + better.error_estimates["tip"]
