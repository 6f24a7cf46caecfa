"""Rigid, frictionless bodies that an actuator can press against."""

import math
from dataclasses import dataclass

from actuators.errors import SceneError

Triple = tuple[float, float, float]
FARTHEST = 10.0
"""Largest distance [m] of an obstacle that a scene may name."""


@dataclass(frozen=True)
class Plate:
    """Half space below the plane n.x = (least n.x of the undeformed body) - ``gap`` [m].

    ``normal``: n, from the plate towards the actuator; scaled to length 1.
    """

    gap: float
    normal: Triple = (0.0, 0.0, 1.0)

    def __post_init__(self) -> None:
        if not 0 <= self.gap <= FARTHEST:
            raise SceneError(
                f"plate gap is {self.gap * 1e3:g} mm; it must lie between 0 and "
                f"{FARTHEST * 1e3:g} mm.",
                field="plate.gap", value=f"{self.gap * 1e3:g} mm",
                mend="Give the distance from the undeformed body to the plate.",
            )  # fmt: skip
        object.__setattr__(self, "normal", _unit(self.normal, "plate.normal"))

    @property
    def symmetric(self) -> bool:
        """Whether it is its own mirror image in the plane X2 = 0."""
        return self.normal[1] == 0.0


@dataclass(frozen=True)
class Cylinder:
    """Endless round bar of ``radius`` [m] along ``axis`` (scaled to length 1) through ``centre``
    [m]."""

    radius: float
    centre: Triple
    axis: Triple = (0.0, 1.0, 0.0)

    def __post_init__(self) -> None:
        if not 1e-4 <= self.radius <= FARTHEST:
            raise SceneError(
                f"cylinder radius is {self.radius * 1e3:g} mm; it must lie between 0.1 and "
                f"{FARTHEST * 1e3:g} mm.",
                field="cylinder.radius", value=f"{self.radius * 1e3:g} mm",
                mend="Give a radius between 0.1 mm and 10 m.",
            )  # fmt: skip
        if not all(math.isfinite(x) and abs(x) <= FARTHEST for x in self.centre):
            raise SceneError(
                f"cylinder centre is {self.centre}; its coordinates must be finite and at most "
                f"{FARTHEST * 1e3:g} mm in size.",
                field="cylinder.centre", value=str(self.centre), mend="Give a point near the body.",
            )  # fmt: skip
        object.__setattr__(self, "axis", _unit(self.axis, "cylinder.axis"))

    @property
    def symmetric(self) -> bool:
        """Whether it is its own mirror image in the plane X2 = 0."""
        across = self.axis[0] == 0.0 and self.axis[2] == 0.0
        return across or (self.axis[1] == 0.0 and self.centre[1] == 0.0)


def _unit(direction: Triple, field: str) -> Triple:
    size = math.hypot(*direction)
    if not math.isfinite(size) or size == 0.0:
        across = field == "cylinder.axis"
        mend = (
            "Use for example [0, 1, 0]: a bar across the body."
            if across
            else "Use for example [0, 0, 1]: a plate below the body."
        )
        raise SceneError(
            f"{field} is {list(direction)}; it must be a direction: three finite numbers, not all "
            f"0. {mend}",
            field=field, value=str(direction), mend=mend,
        )  # fmt: skip
    if abs(size - 1) < 1e-12:
        return direction
    return (direction[0] / size, direction[1] / size, direction[2] / size)
