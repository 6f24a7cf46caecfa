"""A refused design names changes, each of which mends it."""

from typing import Any

import pytest

from actuators.design import parse_design, preset
from actuators.errors import DesignError


@pytest.mark.parametrize(
    ("name", "change", "fields"),
    [
        ("oblique-45", {"theta_deg": 35}, {"length_mm", "chamber_count"}),
        ("oblique-45", {"theta_deg": 15}, {"length_mm", "chamber_count"}),
        ("printed-14", {"length_mm": 90}, {"length_mm", "chamber_count"}),
        ("slab-triangle-low", {"tip_width_mm": 60}, {"tip_width_mm"}),
        ("slab-rectangle-low", {"length_mm": 5}, {"length_mm"}),
        ("slab-rectangle-low", {"chamber_count": 0}, {"chamber_count"}),
        ("bellows-9-1.6", {"total_height_mm": 8}, {"total_height_mm"}),
    ],
)
def test_each_change_proposed_gives_a_design_that_can_be_built(
    name: str, change: dict[str, Any], fields: set[str]
) -> None:
    document = preset(name).design.to_document() | change
    with pytest.raises(DesignError) as refused:
        parse_design(document)
    assert {each.field for each in refused.value.changes} == fields
    for each in refused.value.changes:
        assert _refused_at(document | {each.field: each.value}) not in (
            refused.value.field,
            each.field,
        )


def _refused_at(document: dict[str, Any]) -> str | None:
    """The entry at which the design is refused: another one may have to be mended next."""
    try:
        parse_design(document)
    except DesignError as error:
        return error.field
    return None
