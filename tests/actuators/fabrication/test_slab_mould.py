"""Moulds: what is cast in them is the design."""

import itertools
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from actuators.design import PRESETS, SlabDesign, preset
from actuators.fabrication.sheet_layout import GAP_MM, lay_out
from actuators.fabrication.sheet_stack import STOCK_MM, stack
from actuators.fabrication.slab_mould import DOWEL_MM, slab_moulds
from actuators.fabrication.slab_outline import cavity_outline, planform_outline
from actuators.geometry.volumes import exact_volumes, slab_cavity_area, slab_planform_area
from tests.actuators.design_space import slabs

SLABS = [name for name in PRESETS if name.startswith("slab")]


def slab(name: str) -> SlabDesign:
    design = preset(name).design
    assert isinstance(design, SlabDesign)
    return design


@settings(max_examples=60, deadline=None, derandomize=True)
@given(slabs())
def test_outlines_have_the_exact_areas_and_the_core_fits(design: SlabDesign) -> None:
    window, core = planform_outline(design), cavity_outline(design)
    assert window.is_valid
    assert core.is_valid, "the core is one piece"
    # arcs within 2 micrometres; straight outlines to rounding
    arcs = 0.002 * 2 * design.length * 1e3 if design.planform == "ellipse" else 1e-6
    assert window.area == pytest.approx(slab_planform_area(design) * 1e6, abs=arcs)
    assert core.area == pytest.approx(slab_cavity_area(design) * 1e6, abs=arcs)
    assert core.within(window)
    gap = window.exterior.distance(core)
    ends = min(design.root_wall, design.tip_wall)
    assert 0 < gap <= min(design.side_wall, ends) * 1e3 + 1e-9


@pytest.mark.parametrize("name", ["slab-ellipse-low", "slab-ellipse-high"])
def test_arcs_bulge_less_than_a_hundredth_of_a_millimetre_past_their_chords(name: str) -> None:
    design = slab(name)
    points = list(planform_outline(design).exterior.coords)
    worst = 0.0
    for (x0, y0), (x1, y1) in itertools.pairwise(points):
        if x0 == x1:
            continue  # clamp and free end are straight
        middle = (x0 + x1) / 2
        on_arc = math.copysign(float(design.half_width(middle / 1e3)) * 1e3, y0)
        worst = max(worst, abs(on_arc - (y0 + y1) / 2))
    assert 0 < worst < 0.01


@pytest.mark.parametrize("name", SLABS)
def test_the_poured_volumes_are_those_of_the_design(name: str) -> None:
    design = slab(name)
    moulds = slab_moulds(design)
    exact = exact_volumes(design)
    bottom, top = moulds.moulds
    assert bottom.pour_ml == pytest.approx(exact.bottom * 1e6, rel=1e-4)
    assert top.pour_ml == pytest.approx(exact.top * 1e6, rel=1e-4)


@pytest.mark.parametrize("name", SLABS)
def test_layers_of_a_mould_lie_over_each_other(name: str) -> None:
    for mould in slab_moulds(slab(name)).moulds:
        base, *others = mould.parts
        frames = [p for p in others if " frame " in p.name]
        for frame in frames:
            assert list(frame.cut.exterior.coords) == list(base.cut.exterior.coords)
            assert frame.cut.within(base.cut), "dowel holes go through every layer"
            assert len(frame.cut.interiors) == 5
        assert len(base.cut.interiors) == 4
        for hole in base.cut.interiors:
            left, _, right, _ = hole.bounds
            assert right - left == pytest.approx(DOWEL_MM, abs=0.01)
        window = planform_outline(slab(name))
        assert all(base.cut.exterior.distance(window) > 10 for _ in frames)
        holes_to_window = min(window.distance(hole) for hole in base.cut.interiors)
        assert holes_to_window > 2, "no dowel hole breaks into the window"


def test_labels_name_each_part_and_cores_are_not_marked() -> None:
    moulds = slab_moulds(slab("slab-rectangle-low"))
    names = [p.name for p in moulds.parts]
    assert names == [
        "A1 base 5 mm", "A2 frame 4 mm", "B1 base 5 mm", "B2 frame 10 mm", "B3 frame 2 mm",
        "B4 core 6 mm",
    ]  # fmt: skip
    core = moulds.parts[-1]
    assert not core.label_engraved, "a mark on the core would print into the chambers"
    (mark,) = moulds.parts[2].engraved
    assert list(mark.coords) == list(core.cut.exterior.coords)
    for part in moulds.parts[:-1]:
        x, y = part.label.x, part.label.y
        window = planform_outline(slab("slab-rectangle-low"))
        assert window.bounds[1] > y + part.label.height, "labels stay out of the cast part"
        assert part.cut.bounds[0] < x < part.cut.bounds[2]


def test_a_thickness_that_stock_cannot_make_is_said() -> None:
    design = slab("slab-rectangle-low").changed(bottom_thickness=4.3)
    assert isinstance(design, SlabDesign)
    moulds = slab_moulds(design)
    assert moulds.bottom_thickness == pytest.approx(4.5)
    (note,) = moulds.notes
    assert "bottom_thickness is 4.3 mm" in note
    assert "4.5 mm (3 + 1.5)" in note


def test_the_roof_is_kept_when_the_chambers_change() -> None:
    design = slab("slab-rectangle-low").changed(chamber_height=6.2, roof_thickness=3.0)
    assert isinstance(design, SlabDesign)
    moulds = slab_moulds(design)
    assert moulds.chamber_height == pytest.approx(6.0)
    assert moulds.roof_thickness == pytest.approx(3.0)


def test_a_core_with_thin_links_is_warned_about() -> None:
    assert any("channel_width" in note for note in slab_moulds(slab("slab-ellipse-high")).notes)
    assert not slab_moulds(slab("slab-rectangle-high")).notes


@settings(max_examples=100, deadline=None, derandomize=True)
@given(st.integers(1, 200).map(lambda n: n / 2))
def test_stacks_reach_every_half_millimetre_with_the_fewest_sheets(height: float) -> None:
    sheets = stack(height)
    assert set(sheets) <= set(STOCK_MM)
    reachable = max(height, 1.0)
    assert sum(sheets) == pytest.approx(reachable)
    assert len(sheets) <= math.ceil(height / 10) + 2
    if any(math.isclose(height, a) for a in STOCK_MM):
        assert len(sheets) == 1


@settings(max_examples=60, deadline=None, derandomize=True)
@given(
    st.lists(st.sampled_from([1.8, 2.9, 3.8, 4.75, 7.7]), min_size=1),
    st.floats(0.01, 3.9), st.floats(0, 3.9),
)  # fmt: skip
def test_a_stack_is_the_nearest_there_is(stock: list[float], high: float, low: float) -> None:
    """Against brute force over stacks of up to four sheets, which reach these heights."""
    height, above = high * min(stock), low * min(stock)
    sheets = stack(height, stock, above=above)
    assert sum(sheets) > above - 0.005
    others = [
        sum(c) for n in range(1, 5) for c in itertools.combinations_with_replacement(set(stock), n)
    ]
    nearest = min(abs(t - height) for t in others if t > above + 0.005)
    assert abs(sum(sheets) - height) <= nearest + 0.005


def test_stock_without_thickness_is_refused() -> None:
    with pytest.raises(ValueError, match="stock"):
        stack(4.0, ())
    with pytest.raises(ValueError, match="stock"):
        stack(4.0, (0.0, 3.0))


@settings(max_examples=30, deadline=None, derandomize=True)
@given(slabs())
def test_parts_on_a_sheet_neither_overlap_nor_leave_it(design: SlabDesign) -> None:
    parts = slab_moulds(design).parts
    sheets = lay_out(parts)
    assert sorted(p.part.name for s in sheets for p in s.placed) == sorted(p.name for p in parts)
    for sheet in sheets:
        boxes = []
        for placed in sheet.placed:
            assert placed.part.thickness == sheet.thickness
            left, bottom, right, top = placed.part.box
            box = (left + placed.dx, bottom + placed.dy, right + placed.dx, top + placed.dy)
            assert box[0] >= GAP_MM - 1e-9
            assert box[1] >= GAP_MM - 1e-9
            assert box[2] <= sheet.width - GAP_MM + 1e-9
            assert box[3] <= sheet.height - GAP_MM + 1e-9
            for other in boxes:
                apart_x = max(other[0] - box[2], box[0] - other[2])
                apart_y = max(other[1] - box[3], box[1] - other[3])
                assert max(apart_x, apart_y) >= GAP_MM - 1e-9
            boxes.append(box)


def test_more_frames_than_fit_go_on_a_second_sheet() -> None:
    design = slab("slab-rectangle-low").changed(chamber_height=100, roof_thickness=50)
    assert isinstance(design, SlabDesign)
    thick = [s for s in lay_out(slab_moulds(design).parts) if s.thickness == 10]
    assert len(thick) > 1


def test_a_sheet_grows_for_a_part_that_is_longer() -> None:
    design = slab("slab-rectangle-low").changed(length=900)
    assert isinstance(design, SlabDesign)
    assert all(s.width >= 900 for s in lay_out(slab_moulds(design).parts))
