"""How far off an instant rung typically is: a map over strain and pressure for each family.

``typical_errors.json`` holds quantiles of the error of the tip's displacement over random designs,
by the largest strain of the linear cell and by what, of the few numbers tried, tells most of the
rest in that family (:data:`TRAITS`). ``python -m benchmarks.instant_error`` measures it; the file
says against what.
"""

import json
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib.resources import files
from typing import Any, cast

import numpy as np

from actuators.design import Design
from actuators.mechanics.cell.row import chamber_row
from actuators.mechanics.ladder.points import Typical
from actuators.mechanics.response import Response

FILE = "typical_errors.json"
FEW = 5
"""Chambers of the shortest bodies measured; below, the ends weigh more, in proportion: slabs of one
to three were 17 to 77 % off on the energy rung, one of one chamber 23 % on cell-rod."""


@dataclass(frozen=True)
class ErrorCurve:
    """Quantiles of an error over strain: half and four fifths of all designs lie below ``half`` and
    ``most`` (fractions) at the levels ``strain``, ascending."""

    strain: tuple[float, ...]
    half: tuple[float, ...]
    most: tuple[float, ...]
    source: str

    def at(self, strain: float) -> Typical | None:
        """Between the levels linear in the logarithms; below the first one as there; None above 1.5
        times the last one, where nobody measured."""
        if strain > 1.5 * self.strain[-1]:
            return None
        where = math.log(max(strain, self.strain[0]))

        def value(levels: tuple[float, ...]) -> float:
            return math.exp(float(np.interp(where, np.log(self.strain), np.log(levels))))

        return Typical(value(self.half), value(self.most), self.source)


def _pressure_per_strain(design: Design) -> float:
    return 1e-3 / chamber_row(design).largest_strain


def _length_over_width(design: Design) -> float:
    return design.length / float(getattr(design, "width"))  # noqa: B009 (every family has one)


def _meeting_strain(design: Design) -> float:
    row = chamber_row(design)
    return min(row.largest_strain / max(row.gap_closing, 1e-9), 1.0)


TRAITS: Mapping[str, Callable[[Design], float]] = {
    "pressure_per_strain_kPa": _pressure_per_strain,
    "length_over_width": _length_over_width,
    "meeting_strain": _meeting_strain,
}
"""What designs of one family are told apart by: the pressure over the largest strain that it makes
in the linear cell [kPa]; how slender the body is; the largest strain of the linear cell at which
neighbouring walls would meet in it (1 at most)."""


@lru_cache(maxsize=32)
def _trait(name: str, design: Design) -> float:
    # asked for at every point of a path, while a slider moves; designs are frozen
    return TRAITS[name](design)


@dataclass(frozen=True)
class ErrorMap:
    """Curves of as many groups of designs, each at its ``middle`` value of a trait, ascending."""

    trait: str
    middle: tuple[float, ...]
    curves: tuple[ErrorCurve, ...]

    def at(self, strain: float, value: float) -> Typical | None:
        """At a ``value`` of the trait: between the groups linear in the logarithms, beyond the
        first and last as there."""
        found = [curve.at(strain) for curve in self.curves]
        known = [each for each in found if each is not None]
        if len(known) < len(found):
            return None
        where = math.log(min(max(value, self.middle[0]), self.middle[-1]))

        def between(levels: list[float]) -> float:
            return math.exp(float(np.interp(where, np.log(self.middle), np.log(levels))))

        half, most = between([t.half for t in known]), between([t.most for t in known])
        return Typical(half, most, known[0].source)


@cache
def error_maps() -> Mapping[tuple[str, str], ErrorMap]:
    """Maps by (rung, family) as shipped."""
    return read_maps(
        json.loads((files("actuators.mechanics.ladder") / FILE).read_text(encoding="utf-8"))
    )


def read_maps(document: Mapping[str, Any]) -> Mapping[tuple[str, str], ErrorMap]:
    """Maps from their document (percent; traits as :data:`TRAITS` give them)."""
    return {
        (rung, family): _map(entry)
        for rung, families in document["rungs"].items()
        for family, entry in families.items()
    }


def _map(entry: Mapping[str, Any]) -> ErrorMap:
    def fractions(values: list[float]) -> tuple[float, ...]:
        return tuple(value / 100 for value in values)

    return ErrorMap(
        entry["trait"],
        tuple(group["middle"] for group in entry["groups"]),
        tuple(
            ErrorCurve(
                tuple(group["strain"]),
                fractions(group["half_below_percent"]),
                fractions(group["four_of_five_below_percent"]),
                entry["source"],
            )
            for group in entry["groups"]
        ),
    )


def typical_at(
    rung: str, design: Design, strain: float, *, suction: bool = False, obstacle: bool = False
) -> Typical | None:
    """Typical error of ``rung`` for a design's family at a largest ``strain`` of its linear cell;
    None where nothing is known, as under ``suction`` and beside an ``obstacle``: nobody measured.
    """
    maps = error_maps()
    found = maps.get((rung, design.family)) or maps.get((rung, "any"))
    if found is None or suction or obstacle:
        return None
    typical = found.at(strain, _trait(found.trait, cast(Any, design)))
    chambers = int(getattr(design, "chamber_count"))  # noqa: B009 (every family has one)
    if typical is None or chambers >= FEW:
        return typical
    more = FEW / chambers
    return Typical(more * typical.half, more * typical.most, typical.source)


def typical_error(design: Design, response: Response) -> tuple[Typical | None, ...]:
    """Typical error of an instant ``response`` at every point of its path; None where nothing is
    known. Solves the periodic cell, unless it is kept from the response."""
    per_pressure = 1e-3 / _trait("pressure_per_strain_kPa", cast(Any, design))
    return tuple(
        typical_at(
            response.rung,
            design,
            per_pressure * abs(point.pressure),
            suction=point.pressure < 0.0,
            obstacle=response.scene.has_obstacle,
        )
        for point in response.path
    )
