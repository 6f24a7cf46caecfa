"""Exported files, read back by programs that know nothing of the design."""

import io
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from shapely.geometry import Polygon

from actuators.design import PRESETS, Design, SlabDesign, preset
from actuators.errors import QuestionError
from actuators.export import KINDS, available, write
from actuators.export.mould_svg import INKSCAPE, LAYERS, SVG
from actuators.geometry.volumes import exact_volumes, slab_cavity_area, slab_planform_area
from tests.actuators.design_space import designs, slabs


def sheets_of(design: Design) -> dict[str, ET.Element]:
    files = write(design, "mould-svg")
    return {name: ET.fromstring(data) for name, data in files.items() if name.endswith(".svg")}


def rings_of(path: ET.Element) -> list[Polygon]:
    return [
        Polygon([tuple(map(float, p.split(","))) for p in ring.strip(" Z").split(" L ")])
        for ring in path.attrib["d"].split("M ")
        if ring.strip()
    ]


def layer_of(sheet: ET.Element, name: str) -> ET.Element:
    (found,) = [g for g in sheet.findall(f"{{{SVG}}}g") if g.get(f"{{{INKSCAPE}}}label") == name]
    return found


def paths_of(sheet: ET.Element, layer: str) -> dict[str, list[Polygon]]:
    return {p.attrib["id"]: rings_of(p) for p in layer_of(sheet, layer).iter(f"{{{SVG}}}path")}


@pytest.mark.parametrize("name", [n for n in PRESETS if n.startswith("slab")])
def test_a_sheet_is_in_true_millimetres(name: str) -> None:
    design = preset(name).design
    assert isinstance(design, SlabDesign)
    for file, sheet in sheets_of(design).items():
        width, height = sheet.attrib["width"], sheet.attrib["height"]
        assert width.endswith("mm")
        assert sheet.attrib["viewBox"] == f"0 0 {width[:-2]} {height[:-2]}", "1 unit is 1 mm"
        thickness = re.fullmatch(r"mould-([\d.]+)mm(-\d+)?\.svg", file)
        assert thickness
        assert f"sheet {thickness[1]} mm" in sheet.findtext(f"{{{SVG}}}title", "")
        for rings in paths_of(sheet, "cut outline").values():
            left, top, right, bottom = rings[0].bounds
            assert left >= 0
            assert top >= 0
            assert right <= float(width[:-2])
            assert bottom <= float(height[:-2])


@settings(max_examples=25, deadline=None, derandomize=True)
@given(slabs())
def test_windows_and_cores_measure_as_the_design(design: SlabDesign) -> None:
    planform, cavity = slab_planform_area(design) * 1e6, slab_cavity_area(design) * 1e6
    slack = 0.003 * 4 * (1 + design.chamber_count) * design.length * 1e3
    frames = cores = 0
    for sheet in sheets_of(design).values():
        inside, outline = paths_of(sheet, "cut inside"), paths_of(sheet, "cut outline")
        for label in sheet.iter(f"{{{SVG}}}text"):
            assert label.text
            key = label.text.split()[0]
            if " frame " in label.text:
                window = max(inside[f"{key}-inside"], key=lambda p: p.area)
                assert window.area == pytest.approx(planform, abs=slack)
                left, _, right, _ = window.bounds
                assert right - left == pytest.approx(design.length * 1e3, abs=1e-3)
                frames += 1
            if " core " in label.text:
                (core,) = outline[f"{key}-outline"]
                assert core.area == pytest.approx(cavity, abs=slack)
                cores += 1
    assert frames >= 2
    assert cores >= 1


def test_layers_are_told_apart_by_name_and_colour() -> None:
    for sheet in sheets_of(preset("slab-ellipse-low").design).values():
        groups = sheet.findall(f"{{{SVG}}}g")
        assert [g.get(f"{{{INKSCAPE}}}label") for g in groups] == list(LAYERS)
        colours = [g.get("stroke") if g.get("stroke") != "none" else g.get("fill") for g in groups]
        assert colours == list(LAYERS.values())
        assert len(set(colours)) == len(colours)


def test_every_part_is_labelled_once_over_all_sheets() -> None:
    texts = [
        text.text
        for sheet in sheets_of(preset("slab-rectangle-low").design).values()
        for text in sheet.iter(f"{{{SVG}}}text")
    ]
    assert sorted(str(t) for t in texts) == [
        "A1 base 5 mm", "A2 frame 4 mm", "B1 base 5 mm", "B2 frame 10 mm", "B3 frame 2 mm",
        "B4 core 6 mm",
    ]  # fmt: skip


def test_the_guide_tells_the_amounts_and_what_the_stock_changes() -> None:
    files = write(preset("slab-rectangle-low").design.changed(bottom_thickness=4.3), "mould-svg")
    guide = files["mould-guide.txt"].decode()
    assert "18.0 ml" in guide, "45 x 89 x 4.5 mm as the sheets make it"
    assert "bottom_thickness is 4.3 mm; stock sheets make 4.5 mm" in guide
    for name in files:
        if name.endswith(".svg"):
            assert name in guide


@settings(max_examples=25, deadline=None, derandomize=True)
@given(designs())
def test_the_stl_is_watertight_and_of_the_exact_volume(design: Design) -> None:
    (data,) = write(design, "actuator-stl").values()
    solid = trimesh.load(io.BytesIO(data), file_type="stl")
    assert isinstance(solid, trimesh.Trimesh)
    assert solid.is_watertight
    assert solid.is_winding_consistent
    # float32 corners: 1e-7 of the size, on volumes of thin walls 1e-4; arcs bulge 0.01 mm
    curved = getattr(design, "planform", "") == "ellipse" or design.family == "bellows"
    tolerance = 5e-3 if curved else 1e-4
    assert solid.volume == pytest.approx(exact_volumes(design).rubber * 1e9, rel=tolerance)
    assert solid.bounds[1][0] == pytest.approx(design.length * 1e3, rel=1e-6)


def test_the_stl_is_the_binary_form_with_unit_normals_outward() -> None:
    (data,) = write(preset("oblique-45").design, "actuator-stl").values()
    assert not data.startswith(b"solid"), "readers take that for the text form"
    count = int.from_bytes(data[80:84], "little")
    assert len(data) == 84 + 50 * count
    records = np.frombuffer(data[84:], dtype=np.dtype([("v", "<f4", 12), ("a", "<u2")]))
    normals, corners = records["v"][:, :3], records["v"][:, 3:].reshape(-1, 3, 3)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)
    wound = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert np.all((wound * normals).sum(axis=1) > 0)


def test_an_oblique_mould_is_refused_with_the_reason() -> None:
    design = preset("oblique-45").design
    assert available(design) == ("actuator-stl",)
    with pytest.raises(QuestionError, match="oblique") as caught:
        write(design, "mould-svg")
    assert caught.value.field == "what"
    assert "actuator-stl" in caught.value.mend


def test_a_printed_actuator_needs_no_mould() -> None:
    design = preset("printed-14").design
    assert available(design) == ("actuator-stl",)
    with pytest.raises(QuestionError, match="printed in one piece, not cast") as caught:
        write(design, "mould-svg")
    assert "actuator-stl" in caught.value.mend


def test_an_unknown_kind_is_refused_with_those_there_are() -> None:
    with pytest.raises(QuestionError, match="mould-svg, actuator-stl"):
        write(preset("oblique-45").design, "step")


@pytest.mark.parametrize("name", PRESETS)
def test_every_available_kind_is_written_and_written_alike(name: str) -> None:
    design = preset(name).design
    for what in available(design):
        assert what in KINDS
        files = write(design, what)
        assert files
        assert files == write(design, what), "the same design gives the same bytes"
