"""How far off an instant rung typically is, by family and by the strain it is asked to reach.

``typical_errors.json`` holds quantiles of the error of the tip's displacement over random designs,
by the largest strain of the linear cell. ``python -m benchmarks.instant_error`` measures it; the
file says against what.
"""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np

from actuators.design import Design
from actuators.mechanics.cell.row import chamber_row
from actuators.mechanics.ladder.points import Typical
from actuators.mechanics.response import Response

FILE = "typical_errors.json"


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


@cache
def error_curves() -> Mapping[tuple[str, str], ErrorCurve]:
    """Curves by (rung, family) as shipped."""
    return read_curves(
        json.loads((files("actuators.mechanics.ladder") / FILE).read_text(encoding="utf-8"))
    )


def read_curves(document: Mapping[str, Any]) -> Mapping[tuple[str, str], ErrorCurve]:
    """Curves from their document (percent)."""

    def fractions(values: list[float]) -> tuple[float, ...]:
        return tuple(value / 100 for value in values)

    return {
        (rung, family): ErrorCurve(
            tuple(entry["strain"]),
            fractions(entry["half_below_percent"]),
            fractions(entry["four_of_five_below_percent"]),
            entry["source"],
        )
        for rung, families in document["rungs"].items()
        for family, entry in families.items()
    }


def typical_at(rung: str, design: Design, strain: float) -> Typical | None:
    """Typical error of ``rung`` for a design's family at a largest ``strain`` of its linear cell;
    None where nothing is known."""
    curves = error_curves()
    curve = curves.get((rung, design.family)) or curves.get((rung, "any"))
    return None if curve is None else curve.at(strain)


def typical_error(design: Design, response: Response) -> tuple[Typical | None, ...]:
    """Typical error of an instant ``response`` at every point of its path; None where nothing is
    known. Solves the periodic cell, unless it is kept from the response."""
    per_pressure = chamber_row(design).largest_strain
    return tuple(
        typical_at(response.rung, design, per_pressure * abs(point.pressure))
        for point in response.path
    )
