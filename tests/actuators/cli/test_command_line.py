"""The command ``pneustudio``: answers on stdout, errors on stderr, exit codes."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from actuators.cli import main
from actuators.design import PRESETS, preset

RESULT_FIELDS = {
    "design", "scene", "rung", "outcome", "advice", "path", "error_estimate_percent", "wall_s",
    "unknowns", "newton_iterations", "effects", "assumptions",
}  # fmt: skip
PATH_FIELDS = {
    "pressure_kPa", "tip_mm", "tip_displacement_mm", "tip_rotation_deg", "bending_angle_deg",
    "curvature_per_m", "torsion_per_m", "cavity_volume_ml", "max_principal_stretch",
    "plate_force_N",
}  # fmt: skip


def run(*arguments: str) -> Result:
    return CliRunner().invoke(main, list(arguments))


def answer(*arguments: str) -> Any:
    result = run(*arguments, "--json")
    assert result.exit_code == 0, result.stderr
    return json.loads(result.stdout)


def refusal(*arguments: str) -> dict[str, str]:
    """The error as JSON; the text form must hold the same message."""
    result = run(*arguments, "--json")
    assert result.exit_code == 2, result.output
    assert result.stdout == ""
    error = json.loads(result.stderr)["error"]
    assert set(error) == {"message", "field", "value", "mend"}
    plain = run(*arguments)
    assert plain.exit_code == 2
    assert plain.stdout == ""
    assert plain.stderr.startswith("pneustudio: ")
    assert error["message"] in plain.stderr
    assert len(plain.stderr.strip().splitlines()) == 1
    return error


def test_presets_are_listed() -> None:
    text = run("presets").stdout
    assert all(name in text for name in PRESETS)
    listed = answer("presets")
    assert [p["name"] for p in listed] == list(PRESETS)
    assert listed[0]["design"] == preset(listed[0]["name"]).design.to_document()


def test_materials_are_listed_with_their_source() -> None:
    listed = answer("materials")
    keys = {m["key"] for m in listed}
    assert {"elastosil-m4601", "ecoflex-00-30", "ecoflex-00-50"} <= keys
    assert all(m["source"] and m["density_kg_m3"] > 500 for m in listed)
    assert "elastosil-m4601" in run("materials").stdout


@pytest.mark.parametrize("name", ["slab-ellipse-low", "oblique-30"])
def test_show_names_every_parameter_with_unit_limits_and_source(name: str) -> None:
    design = preset(name).design
    text = run("show", name).stdout
    for p in design.parameters():
        assert p.name in text
        if p.source:
            assert p.source in text
    document = answer("show", name)
    assert document["design"] == design.to_document()
    assert document["digest"] == design.digest
    assert [p["name"] for p in document["parameters"]] == [p.name for p in design.parameters()]
    assert document["assumptions"] == list(design.assumptions())
    assert {"label", "value", "unit"} == set(document["derived"][0])


def test_predict_prints_the_result_document() -> None:
    document = answer("predict", "slab-rectangle-low", "--pressure", "4kPa", "--steps", "4")
    assert set(document) >= RESULT_FIELDS
    assert document["rung"] == "energy"
    assert document["outcome"] == "converged"
    assert set(document["path"][0]) >= PATH_FIELDS
    pressures = [p["pressure_kPa"] for p in document["path"]]
    assert pressures == pytest.approx([0, 1, 2, 3, 4])
    assert document["scene"]["pressure_kPa"] == {"to": 4.0, "steps": 4}
    bending = [p["bending_angle_deg"] for p in document["path"]]
    assert bending == sorted(bending), "the slab curls towards its bottom layer"


def test_predict_prints_a_table() -> None:
    result = run("predict", "oblique-45", "--pressure", "0.04bar", "--steps", "2")
    assert result.exit_code == 0
    heading, *rows = result.stdout.splitlines()[:4]
    assert heading.split()[0] == "p/kPa"
    assert [float(row.split()[0]) for row in rows] == [0, 2, 4]
    assert "converged" in result.stdout
    assert "Assumed:" in result.stdout


def test_the_constant_of_the_energy_rung_is_selectable() -> None:
    def bending(constant: str) -> float:
        scene = ("--pressure", "5kPa", "--steps", "1", "--c", constant)
        return answer("predict", "oblique-90", *scene)["path"][-1]["curvature_per_m"]

    start = answer("predict", "oblique-90", "--pressure", "0kPa", "--steps", "1")
    free = start["path"][-1]["curvature_per_m"]
    assert bending("8") - free == pytest.approx(2 * (bending("4") - free), rel=0.2)
    assert bending("computed") > bending("published"), "the fitted constant is far too small"


def test_set_changes_parameters_together() -> None:
    document = answer(
        "show", "slab-rectangle-low", "--set", "bottom_thickness=0.5cm",
        "--set", "chamber_height_mm=7", "--set", "roof_thickness_mm=2500um",
        "--set", "chamber_count=8", "--set", "planform=ellipse",
        "--set", "top_material=ecoflex-00-50",
    )["design"]  # fmt: skip
    assert document["bottom_thickness_mm"] == 5
    assert document["chamber_height_mm"] == 7
    assert document["roof_thickness_mm"] == 2.5
    assert document["chamber_count"] == 8
    assert document["planform"] == "ellipse"
    assert document["top_material"] == "ecoflex-00-50"
    # neither change alone can be built: 15 degrees needs room, which fewer chambers give
    both = answer("show", "oblique-90", "--set", "theta=15deg", "--set", "chamber_count=4")
    assert both["design"]["theta_deg"] == 15
    assert refusal("show", "oblique-90", "--set", "theta=15deg")["field"] == "length"


def test_a_design_file_reads_back_what_show_and_predict_print(tmp_path: Path) -> None:
    file = tmp_path / "mine"
    for printed in (
        preset("oblique-60").design.to_document(),
        answer("show", "oblique-60"),
        answer("predict", "oblique-60", "--pressure", "1kPa", "--steps", "1"),
    ):
        file.write_text(json.dumps(printed))
        assert answer("show", str(file))["digest"] == preset("oblique-60").design.digest


def test_a_scene_file_is_followed_and_pressure_replaces_its_end(tmp_path: Path) -> None:
    file = tmp_path / "scene.json"
    file.write_text('{"pressure_kPa": {"to": 3, "steps": 3}, "gravity_m_s2": null}')
    document = answer("predict", "slab-rectangle-low", "--scene", str(file))
    assert [p["pressure_kPa"] for p in document["path"]] == pytest.approx([0, 1, 2, 3])
    assert document["path"][0]["bending_angle_deg"] == pytest.approx(0), "no weight, no droop"
    further = answer("predict", "slab-rectangle-low", "--scene", str(file), "--pressure", "6kPa")
    assert further["path"][-1]["pressure_kPa"] == pytest.approx(6)
    assert further["scene"]["gravity_m_s2"] is None


@pytest.mark.parametrize(
    ("arguments", "field"),
    [
        (("--pressure", "30"), "pressure"),
        (("--pressure", "30mm"), "pressure"),
        (("--pressure", "-3kPa"), "pressure"),
        (("--pressure", "1e9kPa"), "pressure"),
        ((), "pressure"),
        (("--pressure", "3kPa", "--steps", "0"), "steps"),
        (("--pressure", "3kPa", "--steps", "many"), "steps"),
        (("--pressure", "3kPa", "--rung", "magic"), "rung"),
        (("--pressure", "3kPa", "--accuracy", "2%"), "accuracy"),
        (("--pressure", "3kPa", "--rung", "fe", "--accuracy", "0.02"), "accuracy"),
        (("--pressure", "3kPa", "--c", "soft"), "c"),
        (("--pressure", "3kPa", "--c", "-1"), "c"),
        (("--pressure", "3kPa", "--c", "nan"), "c"),
        (("--pressure", "3kPa", "--rung", "closed-form", "--c", "4"), "c"),
        (("--pressure", "3kPa", "--set", "bottom_thickness=4"), "bottom_thickness"),
        (("--pressure", "3kPa", "--set", "bottom_thickness=4kPa"), "bottom_thickness"),
        (("--pressure", "3kPa", "--set", "bottom_thickness=-4mm"), "bottom_thickness"),
        (("--pressure", "3kPa", "--set", "bottom_thickness_mm=-4"), "bottom_thickness"),
        (("--pressure", "3kPa", "--set", "botom_thickness=4mm"), "botom_thickness"),
        (("--pressure", "3kPa", "--set", "chamber_count=6.5"), "chamber_count"),
        (("--pressure", "3kPa", "--set", "chamber_count=6mm"), "chamber_count"),
        (("--pressure", "3kPa", "--set", "planform=star"), "planform"),
        (("--pressure", "3kPa", "--set", "top_material=butter"), "top_material"),
        (("--pressure", "3kPa", "--set", "bottom_thickness"), "set"),
        (("--pressure", "3kPa", "--set", "=4mm"), "set"),
        (("--pressure", "3kPa", "--scene", "/nowhere/scene.json"), "scene"),
        (("--unknown",), "--unknown"),
    ],
)  # fmt: skip
def test_bad_input_is_told_with_its_field(arguments: tuple[str, ...], field: str) -> None:
    error = refusal("predict", "slab-rectangle-low", *arguments)
    assert error["field"] == field
    assert error["mend"]


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (b"{", "cannot be read"),
        (b"", "cannot be read"),
        (b"[1, 2]", "object"),
        (b"3", "object"),
        (b'{"family": "slab", "length_mm": NaN}', "NaN"),
        (b'{"family": "slab", "length_mm": Infinity}', "Infinity"),
        (b'{"family": "slab", "length_mm": 1e999}', "finite"),
        (b'{"family": "slab", "length_mm": 80, "length_mm": 90}', "twice"),
        (b'{"family": "slab", "colour": 1}', "colour"),
        (b'{"length_mm": 80}', "family"),
        (b"\xff\xfe", "UTF-8"),
        (b"[" * 100_000, "cannot be read"),
    ],
)
def test_a_bad_design_file_is_told(tmp_path: Path, content: bytes, told: str) -> None:
    file = tmp_path / "design.json"
    file.write_bytes(content)
    assert told in refusal("show", str(file))["message"]


def test_a_missing_file_a_folder_and_a_misspelt_preset_are_told(tmp_path: Path) -> None:
    assert "does not exist" in refusal("show", str(tmp_path / "none.json"))["message"]
    assert "cannot be read" in refusal("show", str(tmp_path))["message"]
    assert "slab-rectangle-low" in refusal("show", "slab-rectangel-low")["message"]
    assert refusal("show")["field"] == "design"


def test_export_writes_every_kind_asked_for(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "files"
    document = answer(
        "export", "slab-rectangle-low", "--what", "mould-svg,actuator-stl", "--to", str(folder)
    )
    written = {f["name"]: f["bytes"] for f in document["files"]}
    assert written == {p.name: p.stat().st_size for p in folder.iterdir()}
    assert "actuator.stl" in written
    assert "mould-4mm.svg" in written
    assert document["notes"] == []
    text = run("export", "oblique-30", "--what", "actuator-stl", "--to", str(folder)).stdout
    assert "actuator.stl" in text
    text = run("export", "slab-ellipse-high", "--what", "mould-svg", "--to", str(folder)).stdout
    assert "channel_width is 0.5 mm" in text, "a maker reads about fragile cores before cutting"


def test_export_writes_nothing_when_one_kind_cannot_be_made(tmp_path: Path) -> None:
    folder = tmp_path / "files"
    for what in ("actuator-stl,mould-svg", "actuator-stl,brick", ""):
        error = refusal("export", "oblique-45", "--what", what, "--to", str(folder))
        assert error["field"] == "what"
        assert not folder.exists()


def test_export_into_a_file_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    for target in (tmp_path / "file", tmp_path / "file" / "below"):
        error = refusal("export", "oblique-45", "--what", "actuator-stl", "--to", str(target))
        assert error["field"] == "to"


def test_serve_hands_its_arguments_to_the_supervisor(monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[list[str]] = []
    monkeypatch.setattr(os, "execv", lambda path, arguments: started.append(arguments))
    assert run("serve", "--port", "8123", "--data", "/tmp/x").exit_code == 0
    assert started == [
        [sys.executable, "-m", "backend.supervisor", "--port", "8123", "--data", "/tmp/x"]
    ]


def test_help_names_every_command() -> None:
    text = run("--help").stdout
    for command in ("presets", "materials", "show", "predict", "export", "serve"):
        assert command in text
    assert run().exit_code == 2
    assert "presets" in run().stderr
    assert run("--version").stdout.startswith("pneustudio, version ")


def command() -> list[str]:
    return [sys.executable, "-c", "from actuators.cli import main; main()"]


def test_the_command_answers_as_a_process_of_its_own() -> None:
    done = subprocess.run(
        [*command(), "predict", "slab-rectangle-low", "--pressure", "2kPa", "--json"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["outcome"] == "converged"
    bad = subprocess.run(
        [*command(), "predict", "slab-rectangle-low", "--pressure", "2"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert bad.returncode == 2
    assert "without a unit" in bad.stderr
    assert "Traceback" not in bad.stderr


def test_a_reader_that_closes_the_pipe_early_causes_no_traceback() -> None:
    process = subprocess.Popen(
        [*command(), "presets", "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.close()
    complaint = process.stderr.read().decode()
    process.stderr.close()
    process.wait()
    assert "Traceback" not in complaint
    assert "BrokenPipe" not in complaint
