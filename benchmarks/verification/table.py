"""The verification table: closed form, ours, difference."""

import math
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

from benchmarks.verification.beams import Flexure, bent_cantilever, bent_to_circle, elastica_tip
from benchmarks.verification.cook import (
    LINEAR_REFERENCE,
    NEO_HOOKE_REFERENCE,
    linear_corner,
    neo_hooke_corner,
)
from benchmarks.verification.inflation import (
    cylinder_pressure,
    found_extreme,
    inflated_cylinder,
    inflated_sphere,
    sphere_limit,
    sphere_pressure,
)

STRETCHES = (1.1, 1.25, 1.5, 2.0)
LOADS = (1.0, 2.0, 5.0, 10.0)
RING = 8.0
"""Length over height of the block that is bent to a ring."""


@dataclass(frozen=True)
class Row:
    """``expected`` by ``source``, and ``ours`` on ``mesh``."""

    problem: str
    quantity: str
    expected: float
    ours: float
    mesh: str
    source: str = "closed form"

    @property
    def difference(self) -> float:
        return self.ours / self.expected - 1

    def document(self) -> dict[str, Any]:
        return {**asdict(self), "difference_percent": 100 * self.difference}


def rows() -> Iterator[Row]:
    """Every line of the table. Half a minute."""
    yield from _spheres()
    yield from _cylinder()
    yield from _balloons()
    yield from _beams()
    yield from _cook()


def _spheres() -> Iterator[Row]:
    problem = "thick sphere A/B = 0.5, neo-Hooke"
    ours = inflated_sphere(0.5, 0.5, 0.0, STRETCHES, (2, 2, 4))
    for stretch, found in zip(STRETCHES, ours, strict=True):
        yield Row(problem, f"p/mu at inner stretch {stretch}",
                  sphere_pressure(stretch, 0.5, 0.5), found, "2 x 2 x 4")  # fmt: skip
    for ratio in (0.5, 0.8):
        stretch, pressure = sphere_limit(ratio, 0.5)
        at, found = found_extreme(ratio, 0.5, 0.0, stretch, (2, 2, 4))
        problem = f"thick sphere A/B = {ratio}, neo-Hooke"
        yield Row(problem, "limit p/mu", pressure, found, "2 x 2 x 4")
        yield Row(problem, "inner stretch at the limit", stretch, at, "2 x 2 x 4")


def _cylinder() -> Iterator[Row]:
    stretches = (*STRETCHES, 3.0)
    ours = inflated_cylinder(0.5, 1.0, stretches, (8, 4))
    for stretch, found in zip(stretches, ours, strict=True):
        yield Row("thick cylinder A/B = 0.5, plane strain, neo-Hooke",
                  f"p/mu at inner stretch {stretch}", cylinder_pressure(stretch, 0.5, 1.0), found,
                  "8 x 4")  # fmt: skip


def _balloons() -> Iterator[Row]:
    thick = [_balloon_limit(ratio) for ratio in (0.96, 0.98)]
    thin = thick[1] + (thick[1] - thick[0]) / 3  # the thickness enters squared
    at = 7 ** (1 / 6)
    yield Row("balloon, neo-Hooke, thickness to zero", "limit p R/(mu h)",
              2 * (1 / at - at**-7), thin, "h/R = 1/49, 1/24")  # fmt: skip
    problem = "balloon h/R = 1/49, Mooney c2/c1 = 0.1"
    for name, near, between in (("maximum", False, (1.1, 2.2)), ("minimum", True, (2.3, 4.5))):
        stretch, pressure = sphere_limit(0.98, 1.0, 0.1, between=between, minimum=near)
        found_at, found = found_extreme(0.98, 1.0, 0.1, stretch, (3, 3, 1), step=0.05)
        yield Row(problem, f"{name} p/c1", pressure, found, "3 x 3 x 1")
        yield Row(problem, f"inner stretch at the {name}", stretch, found_at, "3 x 3 x 1")


def _balloon_limit(ratio: float) -> float:
    stretch, _ = sphere_limit(ratio, 0.5)
    _, pressure = found_extreme(ratio, 0.5, 0.0, stretch, (3, 3, 1))
    return pressure * (1 + ratio) / 2 / (1 - ratio)


def _beams() -> Iterator[Row]:
    for load, ours in zip(LOADS, bent_cantilever(LOADS, 100.0, (50, 1)), strict=True):
        for name, expected, found in zip(("v/L", "u/L"), elastica_tip(load), ours, strict=True):
            yield Row("elastica, dead tip load, L/h = 100", f"{name} at P L^2/EI = {load:g}",
                      expected, found, "50 x 1")  # fmt: skip
    exact = Flexure(2 * math.pi, RING)
    moment, inner = bent_to_circle(RING, (24, 4))
    problem = "block L/h = 8 bent to a full ring, neo-Hooke"
    yield Row(problem, "moment / (mu h^2) per width", exact.moment, moment, "24 x 4 on a half")
    yield Row(problem, "stretch of the inner side", exact.inner, inner, "24 x 4 on a half")


def _cook() -> Iterator[Row]:
    source = "NGSolve, order 4, small at the corners"
    yield Row("Cook's membrane, neo-Hooke, K/G = 5000", "corner u_y [mm]", NEO_HOOKE_REFERENCE,
              neo_hooke_corner(16), "16 x 16", source)  # fmt: skip
    yield Row("Cook's membrane, linear, nu = 1/3, plane strain", "corner u_y [mm]",
              LINEAR_REFERENCE, linear_corner(16), "16 x 16", source)  # fmt: skip
