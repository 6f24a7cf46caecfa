"""The instant answer as a whole: signs, limits, what it says about itself."""

import json
import math

import numpy as np
import pytest

from actuators.design import PRESETS, preset
from actuators.errors import QuestionError
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Outcome
from actuators.mechanics.scene import Scene

FLOATING = Scene(20e3, gravity=None)


@pytest.mark.parametrize("name", sorted(PRESETS))
@pytest.mark.parametrize("rung", ["closed-form", "energy"])
def test_every_preset_is_answered(name: str, rung: str) -> None:
    chosen = preset(name)
    answer = predict(chosen.design, Scene(chosen.pressure_to), rung=rung)
    assert answer.outcome is Outcome.CONVERGED
    assert answer.rung == rung
    assert [p.pressure for p in answer.path] == pytest.approx(
        np.linspace(0, chosen.pressure_to, 21)
    )
    assert answer.centreline is not None
    assert answer.centreline.positions.shape == (21, len(answer.centreline.stations), 3)
    assert answer.centreline.frames.shape == (21, len(answer.centreline.stations), 3, 3)
    assert answer.centreline.stations[-1] == pytest.approx(chosen.design.length)
    for point, line in zip(answer.path, answer.centreline.positions, strict=True):
        assert point.tip == tuple(line[-1])
    json.dumps(answer.to_document(), allow_nan=False)


def test_without_pressure_and_weight_nothing_moves() -> None:
    for name in ("slab-triangle-low", "oblique-30"):
        first = predict(preset(name).design, FLOATING).path[0]
        assert np.abs(first.tip_displacement).max() < 1e-12
        assert (first.curvature, first.torsion, first.bending_angle) == (0, 0, 0)
        assert first.tip_rotation == 0


def test_a_scene_without_pressure_is_answered() -> None:
    answer = predict(preset("oblique-45").design, Scene(0.0))
    assert len({p.tip for p in answer.path}) == 1


def test_pressure_curls_towards_the_bottom_layer_and_weight_pulls_down() -> None:
    design = preset("slab-rectangle-low").design
    floating, heavy = predict(design, FLOATING), predict(design, Scene(20e3))
    upside_down = predict(design, Scene(20e3, gravity=(0, 0, 9.81)))
    assert floating.path[-1].bending_angle > 0
    assert floating.path[-1].tip[2] < 0
    assert heavy.path[0].bending_angle > math.radians(10)
    assert upside_down.path[0].bending_angle < -math.radians(10)


def test_a_straight_chamber_stays_in_its_plane() -> None:
    for point in predict(preset("oblique-90").design, Scene(40e3)).path:
        assert abs(point.tip[1]) < 1e-6 * 0.1
        assert abs(point.torsion or 0) < 1e-3


def test_oblique_chambers_wind_a_right_handed_helix() -> None:
    answer = predict(preset("oblique-45").design, FLOATING)
    last = answer.path[-1]
    assert last.torsion is not None
    assert last.torsion > 0
    assert last.curvature is not None
    assert last.helix_radius is not None
    assert 1 / last.helix_radius > last.curvature  # 1/R = alpha^2 / beta
    assert last.helix_pitch is not None
    assert last.helix_pitch > 0


def test_response_is_linear_in_pressure_without_weight() -> None:
    answer = predict(preset("oblique-60").design, FLOATING)
    rates = [p.curvature / p.pressure for p in answer.path[1:] if p.curvature]
    np.testing.assert_allclose(rates, rates[0], rtol=1e-9)


def test_curvature_of_the_answer_is_the_cells() -> None:
    from actuators.geometry import build_cell
    from actuators.mechanics.cell.cache import cell_response

    design = preset("oblique-90").design
    cell = cell_response(build_cell(design, 0))
    last = predict(design, FLOATING).path[-1]
    # the mean counts the end pieces, which stay straight; the helix does not
    share = 15 * 6 / 104
    assert last.curvature == pytest.approx(cell.free[2] * 20e3 * share, rel=1e-9)
    assert last.helix_radius == pytest.approx(
        (1 + cell.free[0] * 20e3) / (cell.free[2] * 20e3), rel=1e-6
    )
    assert last.cavity_volume is not None
    assert last.cavity_volume > 0


def test_a_given_constant_scales_the_energy_model() -> None:
    design = preset("oblique-60").design
    one, five = (predict(design, FLOATING, c=c).path[-1] for c in (1.0, 5.0))
    assert one.curvature is not None
    assert five.curvature == pytest.approx(5 * one.curvature, rel=1e-9)
    published = predict(design, FLOATING, c="published").path[-1]
    assert published.curvature == pytest.approx(3 * one.curvature, rel=1e-9)  # Table 2: c = 3


def test_computed_constant_makes_the_energy_model_bend_as_the_cell() -> None:
    design = preset("oblique-90").design
    cell = predict(design, FLOATING)
    c = float(cell.notes[0].split("=")[1].split(",")[0])
    scaled = predict(design, FLOATING, c=c)
    # the note rounds c to three digits
    assert scaled.path[-1].curvature == pytest.approx(cell.path[-1].curvature, rel=5e-3)


def test_published_constant_for_a_slab_is_refused() -> None:
    with pytest.raises(QuestionError, match="oblique family"):
        predict(preset("slab-rectangle-low").design, Scene(10e3), c="published")


@pytest.mark.parametrize(
    ("field", "arguments"),
    [("rung", {"rung": "fe"}), ("rung", {"rung": "guess"}), ("c", {"c": "fitted"}),
     ("steps", {"steps": 0}), ("steps", {"steps": 5000})],
)  # fmt: skip
def test_questions_that_make_no_sense_name_the_field(
    field: str, arguments: dict[str, object]
) -> None:
    with pytest.raises(QuestionError) as caught:
        predict(preset("oblique-45").design, Scene(10e3), **arguments)  # pyright: ignore
    assert caught.value.field == field
    assert caught.value.mend


def test_steps_come_from_the_question_then_the_scene() -> None:
    design = preset("oblique-45").design
    assert len(predict(design, Scene(10e3, steps=4)).path) == 5
    assert len(predict(design, Scene(10e3, steps=4), steps=7).path) == 8


def test_gravity_says_what_it_changes() -> None:
    design = preset("slab-rectangle-low").design
    on = predict(design, Scene(10e3)).effects[0]
    off = predict(design, FLOATING).effects[0]
    assert (on.name, on.on, off.on) == ("gravity", True, False)
    assert on.estimated_change_percent is not None
    assert on.estimated_change_percent > 30


def test_large_strain_is_pointed_out() -> None:
    design = preset("oblique-90").design
    assert not any("Strain" in note for note in predict(design, Scene(5e3)).notes)
    assert any("Strain" in note for note in predict(design, Scene(200e3)).notes)


def test_a_rod_that_finds_no_equilibrium_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    from actuators.mechanics import predict as door
    from actuators.mechanics.rod import RodPath, follow_pressures

    def half(*arguments: object) -> RodPath:
        path = follow_pressures(*arguments)  # pyright: ignore
        return RodPath(path.strains[:3], path.positions[:3], path.frames[:3], path.iterations)

    monkeypatch.setattr(door, "follow_pressures", half)
    answer = predict(preset("slab-rectangle-low").design, Scene(20e3))
    assert answer.outcome is Outcome.STALLED
    assert answer.advice is not None
    assert "3 kPa" in answer.advice
    assert len(answer.path) == 3
