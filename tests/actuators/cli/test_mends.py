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
