"""A bar of separate chamber blocks on a common foot: the numbers that the families share."""

import math
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Sheet:
    """A thin embedded layer that cannot stretch along the axis: its ``height`` above the underside
    and its ``thickness`` [m]."""

    height: float
    thickness: float


@dataclass(frozen=True)
class BlockBar:
    """Chamber blocks at ``theta`` [rad] to the axis; lengths in m, the last four along the axis
    measured half a pitch at a time: a pitch is two half gaps, two walls and two half chambers.

    Bottom layer over the whole length; foot, in which neighbours are connected (the air channel
    runs through it, from the bottom layer up); free walls above; roof.
    """

    theta: float
    chamber_count: int
    length: float
    width: float
    chamber_width: float
    half_gap: float
    wall_thickness: float
    half_chamber: float
    channel_width: float
    channel_height: float
    bottom_thickness: float
    foot_height: float
    wall_height: float
    roof_thickness: float
    bottom_material: str
    top_material: str
    sheet: Sheet | None = None

    @property
    def pitch(self) -> float:
        """From one chamber to the next along the axis [m]."""
        return 2 * (self.half_gap + self.wall_thickness + self.half_chamber)

    @property
    def chamber_height(self) -> float:
        """Foot and free wall together [m]."""
        return self.foot_height + self.wall_height

    @property
    def height(self) -> float:
        """Total height [m]."""
        return self.bottom_thickness + self.chamber_height + self.roof_thickness

    @property
    def cot_theta(self) -> float:
        """Skew of the chambers: dX1/dX2 along a chamber wall; exactly 0 at 90 degrees."""
        return 0.0 if abs(self.theta - math.pi / 2) < 1e-12 else 1 / math.tan(self.theta)

    @property
    def side_wall(self) -> float:
        """Wall on either side of the chambers [m]."""
        return (self.width - self.chamber_width) / 2

    @property
    def end_length(self) -> float:
        """Solid end piece at either end, measured on the middle plane [m]."""
        return (self.length - self.chamber_count * self.pitch) / 2

    def chamber_centres(self) -> np.ndarray:
        """X1 of each chamber's middle on the plane X2 = 0, shape (n,) [m]."""
        return self.end_length + self.pitch * (np.arange(self.chamber_count) + 0.5)
