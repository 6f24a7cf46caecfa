"""As far as an answer of cell and rod is worth reading, and how far off it is expected to be."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from actuators.design import Design, ObliqueDesign
from actuators.mechanics.cell.inflated import CellPath
from actuators.mechanics.cell.row import pitch_starts
from actuators.mechanics.crossing import first_below
from actuators.quantities import kilopascals

if TYPE_CHECKING:
    from actuators.mechanics.cell_rod.answer import Question

NEAR_THE_LIMIT = 0.8
"""Share of the cell's limit pressure up to which the rod's answer is worth reading: beyond it
chambers grow apart. In 3D the limit of slab-rectangle-low is 0.85 to 0.9 of the cell's."""

TRUSTED_CAVITY = {"slab": 3 / 4, "oblique": 2 / 3, "printed": 2 / 3, "bellows": 3 / 4}
"""Share of a cavity that suction must leave for the answer to be worth reading: as far as errors
stay within the estimate (benchmarks.cell_rod_suction; docs/cell_rod.md). Of slabs they double from
0.75 to 0.7 left, where one chamber collapses before the rest, and of bellows, whose walls meet in
the cavity; of the others they grow slowly, to 0.6 at least."""
BEYOND_TRUST = 1.0
"""Expected error of a path that goes on to where chambers give way: all of the tip's way."""
MEASURED = {"slab": 0.05, "oblique": 0.03, "printed": 0.03, "bellows": 0.075}
"""Largest deviation of the tip from 3D, over its way, on the paths of the presets whose 3D answer
has an estimated error of its own (benchmarks.cell_rod; docs/cell_rod.md) and of random designs of
5 and 6 chambers without weight, over what :func:`estimate` multiplies it with: slabs without weight
(4 % under weight alone), obliques under weight alone, bellows in contact. Estimates of those 3D
answers, 1 to 7 %, are not added."""
FEW = {"slab": 5, "oblique": 10, "printed": 12, "bellows": 5}
"""Chambers below which the ends' share grows: obliques of 6 chambers are 5 and 7 % off, printed
bodies of 5 3 to 7 %, presets of 8 to 15 chambers 3 %."""
MEASURED_SUCKED = {"slab": 0.1, "oblique": 0.075, "printed": 0.15, "bellows": 0.19}
"""As :data:`MEASURED`, under suction as far as it is trusted, of bodies of 5 chambers and more
(benchmarks.cell_rod_suction): up to 8 % of a slab's longest way (medium mesh), 15 % of a printed
body's and 13 % of bellows'; of obliques 16 %, where 17 are expected because chambers reach over
each other, and 8.5 of 10."""
FEW_SUCKED = 5
ALONE = 1.5
"""More for a single chamber, which has two ends and no neighbour: one of slab-rectangle-low at
5 kPa is 31 % off (3D within 2 %), where 5/n tells 25."""
SIDE_BY_SIDE = 5
"""Of what one skew chamber reaches over, how many the length must hold for ends not to grow."""


def trusted_to(design: Design, paths: Sequence[CellPath], pressures: np.ndarray) -> float | None:
    """Pressure [Pa] up to which chambers answer alike; None where the path stays below."""
    kept = TRUSTED_CAVITY[design.family]
    ends = [NEAR_THE_LIMIT * abs(p.limit_pressure) for p in paths if p.limit_pressure is not None]
    last = 0.0 if len(pressures) == 0 else float(pressures[-1])
    if last < 0.0:
        ends += [abs(found) for path in paths if (found := _closing(path, kept)) is not None]
    if not ends or abs(last) <= min(ends):
        return None
    return math.copysign(min(ends), last)


def _closing(path: CellPath, kept: float) -> float | None:
    """Suction [Pa] that leaves a share ``kept`` of the cavity; None where the path ends before."""
    return first_below(path.pressure, path.volume / path.volume[0], kept)


def estimate(design: Design, *, suction: bool) -> float:
    """Expected error of the tip's displacement, a fraction of its way: the largest found for the
    family against 3D finite elements (:data:`MEASURED`), more under suction and where the ends
    weigh more: where chambers are few, or so skew that each reaches over several. No bound."""
    starts, pitch = pitch_starts(design)
    skew = design.width / math.tan(design.theta) if isinstance(design, ObliqueDesign) else 0.0
    side_by_side = design.length / (pitch + skew) if skew > 0.0 else SIDE_BY_SIDE
    measured, few = (
        (MEASURED_SUCKED[design.family], FEW_SUCKED)
        if suction
        else (MEASURED[design.family], FEW[design.family])
    )
    ends = max(1.0, few / len(starts)) * max(1.0, SIDE_BY_SIDE / side_by_side)
    if len(starts) == 1:
        ends *= ALONE
    return min(measured * ends, BEYOND_TRUST)


def unlike(question: Question, trusted: float) -> str:
    """That chambers answer unequally beyond a pressure [Pa], and what the answer is worth."""
    limits = [p.limit_pressure for p in question.paths if p.limit_pressure is not None]
    known = ""
    if limits:
        limit = min(limits, key=abs)
        known = (
            f"One chamber among equals has its {'maximum' if limit > 0.0 else 'minimum'} of "
            f"pressure at {kilopascals(limit)} kPa. "
        )
    what = (
        f"Beyond {kilopascals(trusted, 3)} kPa chambers of a body may answer unequally and reach "
        "theirs sooner, and loads bend them far"
        if trusted > 0.0
        else f"Beyond {kilopascals(trusted, 3)} kPa more than {_gone(question.design)} of the "
        "chambers' volume is gone. In a body they may collapse one before the other, or wall "
        "against wall, well before one among equals does"
    )
    expected = 100 * estimate(question.design, suction=trusted < 0.0)
    return (
        f"{known}{what}: look with the rung fe. Up to there the tip is expected within "
        f"{expected:.2g} % of its way, beyond it may be anywhere."
    )


def _gone(design: Design) -> str:
    return "a quarter" if TRUSTED_CAVITY[design.family] == 3 / 4 else "a third"
