"""What the command line says where something must be mended, or is replaced."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from actuators.cli import main


def run(*arguments: str) -> Result:
    return CliRunner().invoke(main, arguments)


def test_an_option_that_replaces_a_scene_file_says_so(tmp_path: Path) -> None:
    file = tmp_path / "scene.json"
    file.write_text('{"pressure_kPa": {"to": 4, "steps": 2}}')
    asked = ("predict", "slab-rectangle-low", "--scene", str(file), "--json")
    both = run(*asked, "--pressure", "2kPa", "--steps", "1")
    assert "--pressure 2kPa replaces pressure_kPa.to 4" in both.stderr
    assert "--steps 1 replaces pressure_kPa.steps 2" in both.stderr
    assert json.loads(both.stdout)["scene"]["pressure_kPa"] == {"to": 2.0, "steps": 1}
    assert "replaces" not in run(*asked, "--pressure", "4kPa").stderr


@pytest.mark.parametrize(
    ("scene", "says"),
    [
        ("{}", 'pressure_kPa is missing; it must say where the path ends, in kPa. Write for '
               'example "pressure_kPa": {"to": 30}.'),
        ('{"pressure_kPa": {"to": 4}, "plate": {"gap": 3}}', "Did you mean gap_mm?"),
        ('{"pressure_kPa": {"to": 4}, "cylinder": {"radius_mm": 3, "centre_mm": [60, 0, -20], '
         '"axis": [0, 0, 0]}}', "Use for example [0, 1, 0]: a bar across the body."),
    ],
)  # fmt: skip
def test_a_faulty_scene_file_says_how_to_mend_it(scene: str, says: str, tmp_path: Path) -> None:
    file = tmp_path / "scene.json"
    file.write_text(scene)
    result = run("predict", "slab-rectangle-low", "--scene", str(file))
    assert result.exit_code == 2
    assert says in result.stderr


def test_an_unknown_choice_names_the_known_ones() -> None:
    result = run("show", "printed-14", "--set", "layer=steel")
    assert result.exit_code == 2
    assert "layer is 'steel', which is no choice. Use 'inextensible' or 'none'." in result.stderr


def test_a_path_that_ends_early_is_an_answer_and_told_apart_on_demand(tmp_path: Path) -> None:
    asked = ("predict", "slab-rectangle-low", "--pressure", "10000kPa")
    early = run(*asked)
    assert early.exit_code == 0
    assert "Rung energy: stalled" in early.stdout
    assert "over 1000 %, of which this linear model knows nothing" in early.stdout
    assert "meant for less than 3.8 kPa" in early.stdout
    assert run(*asked, "--strict").exit_code == 3
    assert run("predict", "slab-rectangle-low", "--pressure", "2kPa", "--strict").exit_code == 0
    export = ("export", "slab-rectangle-low", "--what", "actuator-stl", "--to", str(tmp_path))
    assert run(*export, "--strict").exit_code == 0


def test_a_mesh_that_is_none_is_refused_before_anything_is_solved(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def solve(*_: object, **__: object) -> None:
        raise AssertionError("solved")

    monkeypatch.setattr("actuators.mechanics.continuum.solve", solve)
    monkeypatch.setattr("actuators.export.write", solve)
    question = ("slab-rectangle-low", "--pressure", "2kPa", "--mesh", "coarser")
    for command in (
        ("predict", "--rung", "fe"),
        ("export", "--what", "vtu", "--to", str(tmp_path)),
    ):
        result = run(command[0], *question, *command[1:])
        assert result.exit_code == 2
        assert "mesh is 'coarser'" in result.stderr


def test_a_scene_file_that_is_not_there_is_no_preset() -> None:
    result = run("predict", "slab-rectangle-low", "--scene", "nowhere.json")
    assert result.exit_code == 2
    assert "preset" not in result.stderr
    assert "name a preset" in run("show", "nowhere.json").stderr


def test_incompressible_rubbers_are_told_of() -> None:
    assert "KEY@incompressible" in run("materials").stdout
    for command in ("predict", "export", "ladder", "show"):
        assert "@incompressible" in " ".join(run(command, "--help").stdout.split())


def test_an_export_takes_effects(tmp_path: Path) -> None:
    asked = ("export", "slab-rectangle-low", "--what", "inp", "--pressure", "2kPa", "--mesh",
             "coarse", "--to", str(tmp_path))  # fmt: skip
    assert run(*asked).exit_code == 0
    deck = next(tmp_path.glob("*.inp"))
    assert "GRAV" in deck.read_text()
    assert run(*asked, "--effect", "gravity=off").exit_code == 0
    assert "GRAV" not in deck.read_text()
    refused = run(*asked, "--effect", "gravty=off")
    assert refused.exit_code == 2
    assert "gravity" in refused.stderr


def test_what_a_message_says_in_the_middle_of_a_sentence_is_not_said_again() -> None:
    said = run("predict", "slab-rectangle-low").stderr
    assert "pressure is missing; give --pressure 30kPa or --scene FILE." in said
    assert said.casefold().count("give --pressure") == 1
