"""What rung 3 expects to be off by under suction, against 3D answers kept."""

import pytest

from benchmarks.cell_rod_suction import compared, read

KEPT = {f"{entry['case']}, {entry['mesh']}": entry for entry in read()}
QUICK = ("random slab 5, medium", "random oblique 2, medium")
JUDGED = [
    name
    for name, entry in KEPT.items()
    # on coarse meshes of 3D chambers of slabs collapse too soon
    if entry["design"]["family"] != "slab" or entry["mesh"] != "coarse"
]


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=() if name in QUICK else pytest.mark.slow) for name in JUDGED],
)
def test_suction_stays_within_what_is_expected_as_far_as_it_is_trusted(name: str) -> None:
    """While 95 to 70 % of the cavity are left, over the longest way; rounded to a percent, as the
    estimates are."""
    found = compared(KEPT[name])
    assert found.trusted.any()
    assert 100 * found.error[found.trusted].max() < 100 * found.expected + 0.5
