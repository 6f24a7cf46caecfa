"""The energy model's constant c: computed from a periodic cell, published, or given."""

import math
from typing import Literal

import numpy as np

from actuators.design import Design, ObliqueDesign
from actuators.errors import QuestionError

Constant = Literal["computed", "published"] | float

# G, Table 2
_THETA_DEG = np.array([15.0, 30.0, 45.0, 60.0, 75.0, 90.0])
_PUBLISHED = np.array([0.12, 1.0, 2.72, 3.0, 4.0, 5.0])


def computed_constant(cell: np.ndarray, energy: np.ndarray) -> float:
    """c for which the energy model turns as the periodic cell does, from the rod strains per
    pressure (..., 4) of both.

    At theta = 90 degrees it is the ratio of the two curvatures. Where chambers also twist, it is
    the least-squares ratio of (bending, torsion), which stays defined at the angle where the
    bending vanishes.
    """
    cell, energy = cell[..., 1:3], energy[..., 1:3]
    return float((cell * energy).sum() / (energy**2).sum())


def published_constant(design: Design) -> float:
    """c of G, Table 2, at the design's angle (linear between the rows)."""
    if not isinstance(design, ObliqueDesign):
        raise QuestionError(
            f"c is 'published', but the paper (G) fitted it for the oblique family only, not for "
            f"{design.family}. Use c = computed, or a number.",
            field="c", value="published", mend="Use c = computed, or a number.",
        )  # fmt: skip
    return float(np.interp(math.degrees(design.theta), _THETA_DEG, _PUBLISHED))


def check_constant(c: object) -> Constant:
    """``c`` as given at the border; raises :class:`QuestionError` for anything else."""
    if c == "computed":
        return "computed"
    if c == "published":
        return "published"
    if isinstance(c, (int, float)) and not isinstance(c, bool) and 0 < c <= 1e4:
        return float(c)
    raise QuestionError(
        f"c is {c!r}; it must be 'computed', 'published' or a number above 0, at most 10000.",
        field="c", value=repr(c), mend="Use computed, published or a number such as 5.",
    )  # fmt: skip
