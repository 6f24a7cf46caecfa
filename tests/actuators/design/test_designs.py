"""Designs: documents round trip, limits are named, the hash stays."""

import json
import math
import subprocess
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from actuators.design import (
    FAMILIES,
    PRESETS,
    Design,
    DesignError,
    ObliqueDesign,
    SlabDesign,
    parse_design,
    preset,
)
from tests.actuators.design_space import designs


@settings(max_examples=100, deadline=None, derandomize=True)
@given(designs())
def test_a_document_reads_back_as_the_same_design(design: Design) -> None:
    text = json.dumps(design.to_document(), allow_nan=False)
    again = parse_design(json.loads(text))
    assert again.to_document() == design.to_document()
    assert again.digest == design.digest
    for p in design.parameters():
        value = getattr(design, p.name)
        if isinstance(value, float):
            assert getattr(again, p.name) == pytest.approx(value, rel=1e-11)


@pytest.mark.parametrize("name", PRESETS)
def test_presets_are_buildable_and_round_trip(name: str) -> None:
    design = preset(name).design
    assert parse_design(design.to_document()).digest == design.digest


def test_all_presets_differ() -> None:
    assert len({p.design.digest for p in PRESETS.values()}) == len(PRESETS)


def test_the_digest_is_the_same_in_another_process_and_key_order() -> None:
    design = preset("oblique-45").design
    document = dict(reversed(design.to_document().items()))
    code = (
        "import json, sys; from actuators.design import parse_design;"
        "print(parse_design(json.loads(sys.argv[1])).digest)"
    )
    printed = subprocess.run(
        [sys.executable, "-c", code, json.dumps(document)],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert printed.stdout.strip() == design.digest


def test_every_numeric_parameter_changes_the_digest() -> None:
    for family in FAMILIES.values():
        base = family()
        for p in family.parameters():
            if p.kind in ("choice", "material"):
                continue
            border = base.to_document()[p.border_name]
            step = p.step or 1
            for value in (border + step, border - step):
                try:
                    changed = base.changed(**{p.name: value})
                except DesignError:
                    continue
                assert changed.digest != base.digest
                break
            else:
                pytest.fail(f"{p.name} has no neighbour of its default")


def _limits() -> list[tuple[str, str, float]]:
    cases: list[tuple[str, str, float]] = []
    for name, family in FAMILIES.items():
        for p in family.parameters():
            if p.lower is not None:
                cases.append((name, p.name, p.lower - 0.01 if p.kind != "count" else p.lower - 1))
            if p.upper is not None:
                cases.append((name, p.name, p.upper + 1))
    return cases


@pytest.mark.parametrize(("family", "name", "value"), _limits())
def test_a_value_out_of_its_limits_is_refused_with_field_value_and_mend(
    family: str, name: str, value: float
) -> None:
    with pytest.raises(DesignError) as caught:
        FAMILIES[family]().changed(**{name: value})
    error = caught.value
    assert error.field == name
    assert error.value
    assert error.mend
    assert name in str(error)


@pytest.mark.parametrize(
    ("document", "field"),
    [
        ({"family": "slab", "chamber_count": 60, "length_mm": 20}, "chamber_count"),
        ({"family": "slab", "wall_ratio": 0.05, "chamber_count": 20}, "wall_ratio"),
        ({"family": "slab", "planform": "triangle", "tip_width_mm": 46}, "tip_width"),
        ({"family": "slab", "planform": "ellipse", "side_radius_mm": 44}, "side_radius"),
        ({"family": "slab", "planform": "ellipse", "side_radius_mm": 45}, "side_radius"),
        ({"family": "slab", "side_wall_mm": 21}, "side_wall"),
        ({"family": "oblique", "chamber_width_mm": 14.9}, "chamber_width"),
        ({"family": "oblique", "channel_width_mm": 11}, "channel_width"),
        ({"family": "oblique", "channel_height_mm": 1.8}, "channel_height"),
        ({"family": "oblique", "theta_deg": 15}, "length"),
        ({"family": "slab", "planform": "hexagon"}, "planform"),
        ({"family": "printed", "side_wall_mm": 8.4}, "side_wall"),
        ({"family": "printed", "channel_width_mm": 13.8}, "channel_width"),
        ({"family": "printed", "channel_height_mm": 2.3}, "channel_height"),
        ({"family": "printed", "layer_height_mm": 0.05}, "layer_height"),
        ({"family": "printed", "layer_height_mm": 2.45}, "layer_height"),
        ({"family": "printed", "chamber_count": 15}, "length"),
        ({"family": "cube"}, "family"),
        ({"family": ["slab"]}, "family"),
        ({"family": "slab", "lenght_mm": 80}, "lenght_mm"),
        ({"family": "slab", "length_mm": "80"}, "length"),
        ({"family": "slab", "length_mm": math.nan}, "length"),
        ({"family": "slab", "length_mm": math.inf}, "length"),
        ({"family": "slab", "length_mm": None}, "length"),
        ({"family": "slab", "length_mm": True}, "length"),
        ({"family": "slab", "chamber_count": 5.5}, "chamber_count"),
    ],
)
def test_impossible_combinations_are_refused(document: dict[str, object], field: str) -> None:
    with pytest.raises(DesignError) as caught:
        parse_design(document)
    assert caught.value.field == field


def test_a_misspelt_parameter_is_answered_with_the_near_one() -> None:
    with pytest.raises(DesignError, match="Did you mean length_mm"):
        parse_design({"family": "slab", "lenght_mm": 80})


def test_a_misspelt_preset_is_answered_with_near_ones() -> None:
    with pytest.raises(DesignError, match="slab-rectangle-low"):
        preset("slab-rectangel-low")


def test_chambers_and_walls_fill_the_length() -> None:
    """S, Table 1: h1 = 80/11 mm for six chambers, 80/21 mm for eleven."""
    low, high = preset("slab-rectangle-low").design, preset("slab-rectangle-high").design
    assert isinstance(low, SlabDesign)
    assert isinstance(high, SlabDesign)
    assert low.chamber_length == pytest.approx(80e-3 / 11)
    assert high.chamber_length == pytest.approx(80e-3 / 21)


@pytest.mark.parametrize(
    ("name", "chamber"),
    [("slab-triangle-low", 7.0), ("slab-triangle-high", 3.2), ("slab-rectangle-low", 7.3),
     ("slab-rectangle-high", 3.8)],
)  # fmt: skip
def test_chamber_lengths_round_to_those_of_the_paper(name: str, chamber: float) -> None:
    design = preset(name).design
    assert isinstance(design, SlabDesign)
    assert round(design.chamber_length * 1e3, 1) == chamber


@settings(max_examples=50, deadline=None, derandomize=True)
@given(st.floats(15, 90))
def test_skew_follows_the_angle(theta: float) -> None:
    design = ObliqueDesign().changed(theta=theta, chamber_count=1, length=200)
    assert isinstance(design, ObliqueDesign)
    assert design.cot_theta == pytest.approx(1 / math.tan(math.radians(theta)), abs=1e-12)


def test_the_layer_carries_its_assumptions_with_it() -> None:
    printed = preset("printed-14").design
    assert any("1000 times" in sentence for sentence in printed.assumptions())
    plain = printed.changed(layer="none").assumptions()
    assert not any("layer" in sentence for sentence in plain)
    assert any("chamber_length" in sentence for sentence in plain)
    # where nothing reads it, its height may be anything within its limits
    assert printed.changed(layer="none", layer_height=20).digest != printed.digest


@pytest.mark.parametrize("name", ["printed-14", "bellows-9-1.6"])
def test_a_known_mismatch_with_measurements_is_carried_along(name: str) -> None:
    design = preset(name).design
    assert "docs/validation.md" in design.assumptions()[-1]
    assert "docs/validation.md" in design.changed(width=18).assumptions()[-1]
