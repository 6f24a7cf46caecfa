"""Family ``oblique`` (G, Fig. 2 and Table 1): chambers at an angle theta to the axis.

The t's are measured along the axis (t2 = 1 mm / sin theta in every row of Table 1). Below
``h1 + h2`` the body is connected; above it every chamber stands in its own block, with open gaps
2*t1 between blocks (physics: bottom [0, h1], foot [h1, h1+h2], walls up to h1+h2+h3, roof h4).
"""

import math
from typing import ClassVar, Literal

import numpy as np

from actuators.design.base import Design
from actuators.design.blocks import BlockBar
from actuators.design.mends import fitting
from actuators.design.parameter import parameter
from actuators.errors import DesignError


class ObliqueDesign(Design):
    """Oblique-chamber actuator, all values in SI, theta in radians."""

    title: ClassVar[str] = "Oblique chambers"
    family: Literal["oblique"] = "oblique"  # pyright: ignore[reportIncompatibleVariableOverride]

    theta: float = parameter(
        45.0, label="Chamber angle", symbol="theta", group="Chambers", kind="angle", lower=15,
        upper=90, step=1, help="Angle between the chambers and the axis; 90 bends without twist.",
        source="G, Table 1",
    )  # fmt: skip
    chamber_count: int = parameter(
        11, label="Chambers", symbol="n", group="Chambers", kind="count", lower=1, upper=60,
        step=1, help="Number of chambers along the length.", source="G, Table 1",
    )  # fmt: skip
    length: float = parameter(
        107.0, label="Length", symbol="l", group="Outline", kind="length", lower=10, upper=1000,
        step=1, help="From the clamp to the free end.", source="G, Table 1",
    )  # fmt: skip
    width: float = parameter(
        15.0, label="Width", symbol="w_o", group="Outline", kind="length", lower=2, upper=200,
        step=0.5, help="Outer width of the bar.", source="G, Table 1",
    )  # fmt: skip
    chamber_width: float = parameter(
        11.0, label="Chamber width", symbol="w", group="Chambers", kind="length", lower=0.5,
        upper=200, step=0.5, help="Inner width of the chambers across the bar.",
        source="G, Table 1",
    )  # fmt: skip
    half_gap: float = parameter(
        1.5, label="Half gap", symbol="t1", group="Chambers", kind="length", lower=0.05, upper=50,
        step=0.05, help="Half the open distance between chamber blocks, along the axis.",
        source="G, Table 1",
    )  # fmt: skip
    wall_thickness: float = parameter(
        1.415, label="Chamber wall", symbol="t2", group="Chambers", kind="length", lower=0.1,
        upper=50, step=0.05, help="Wall between chamber and gap, along the axis.",
        source="G, Table 1",
    )  # fmt: skip
    half_chamber: float = parameter(
        1.085, label="Half chamber length", symbol="t3", group="Chambers", kind="length",
        lower=0.1, upper=50, step=0.05, help="Half the inner length of a chamber, along the axis.",
        source="G, Table 1",
    )  # fmt: skip
    channel_width: float = parameter(
        2.0, label="Air channel width", group="Chambers", kind="length", lower=0, upper=50,
        step=0.1, help="Channel through the foot that connects the chambers; 0 leaves them "
        "separate, each under the same pressure.",
        assumed="channel_width is not given in the paper (G); the studio's default is an "
        "assumption",
    )  # fmt: skip
    channel_height: float = parameter(
        1.0, label="Air channel height", group="Chambers", kind="length", lower=0.1, upper=50,
        step=0.1, help="Height of the channel, from the bottom layer up; the rest of the foot "
        "closes it under the open gaps.",
        assumed="channel_height is not given in the paper (G); the studio's default is an "
        "assumption",
    )  # fmt: skip
    bottom_thickness: float = parameter(
        3.5, label="Bottom layer", symbol="h1", group="Layers", kind="length", lower=0.1, upper=50,
        step=0.1, help="Solid layer under the chambers.", source="G, Table 1",
    )  # fmt: skip
    foot_height: float = parameter(
        2.0, label="Foot", symbol="h2", group="Layers", kind="length", lower=0.1, upper=50,
        step=0.1, help="Height over which neighbouring blocks are connected.",
        source="G, Table 1",
    )  # fmt: skip
    wall_height: float = parameter(
        7.0, label="Free wall height", symbol="h3", group="Layers", kind="length", lower=0.1,
        upper=100, step=0.1, help="Height of the separate chamber walls above the foot.",
        source="G, Table 1",
    )  # fmt: skip
    roof_thickness: float = parameter(
        2.0, label="Roof", symbol="h4", group="Layers", kind="length", lower=0.1, upper=50,
        step=0.1, help="Thickness of rubber above the chambers.", source="G, Table 1",
    )  # fmt: skip
    inlet_height: float = parameter(
        4.0, label="Inlet height", symbol="h5", group="Layers", kind="length", lower=0, upper=100,
        step=0.1, help="h5 of Table 1. The text does not say what it measures; it is kept with "
        "the design as the height of the air inlet above the underside and does not enter the "
        "mechanics.",
        source="G, Table 1", assumed="the meaning of h5 is not stated in the paper (G); it is "
        "recorded and does not enter the mechanics",
    )  # fmt: skip
    bottom_material: str = parameter(
        "elastosil-m4601", label="Bottom material", group="Materials", kind="material",
        help="Material of the bottom layer.", source="G, Table 1",
    )  # fmt: skip
    top_material: str = parameter(
        "elastosil-m4601", label="Top material", group="Materials", kind="material",
        help="Material of foot, chamber walls and roof.", source="G, Table 1",
    )  # fmt: skip

    @property
    def bar(self) -> BlockBar:
        """The chamber blocks."""
        return BlockBar(
            theta=self.theta, chamber_count=self.chamber_count, length=self.length,
            width=self.width, chamber_width=self.chamber_width, half_gap=self.half_gap,
            wall_thickness=self.wall_thickness, half_chamber=self.half_chamber,
            channel_width=self.channel_width, channel_height=self.channel_height,
            bottom_thickness=self.bottom_thickness, foot_height=self.foot_height,
            wall_height=self.wall_height, roof_thickness=self.roof_thickness,
            bottom_material=self.bottom_material, top_material=self.top_material,
        )  # fmt: skip

    @property
    def pitch(self) -> float:
        """2 (t1 + t2 + t3), along the axis [m]."""
        return self.bar.pitch

    @property
    def height(self) -> float:
        """Total height h = h1 + h2 + h3 + h4 [m]."""
        return self.bar.height

    @property
    def chamber_height(self) -> float:
        """h2 + h3 [m]."""
        return self.bar.chamber_height

    @property
    def cot_theta(self) -> float:
        """Skew of the chambers: dX1/dX2 along a chamber wall; exactly 0 at 90 degrees."""
        return self.bar.cot_theta

    @property
    def side_wall(self) -> float:
        """Wall on either side of the chambers [m] (2 mm in Table 1)."""
        return self.bar.side_wall

    @property
    def end_length(self) -> float:
        """Solid end piece at either end, measured on the middle plane [m]."""
        return self.bar.end_length

    def chamber_centres(self) -> np.ndarray:
        """X1 of each chamber's middle on the plane X2 = 0, shape (n,) [m]."""
        return self.bar.chamber_centres()

    def check(self) -> None:
        if self.side_wall < 0.3e-3:
            raise DesignError(
                f"chamber_width is {self.chamber_width * 1e3:.2f} mm, which leaves side walls of "
                f"{self.side_wall * 1e3:.2f} mm in a bar {self.width * 1e3:.2f} mm wide; they must "
                "be 0.30 mm or thicker. Reduce chamber_width or raise width.",
                field="chamber_width", value=f"{self.chamber_width * 1e3:.2f} mm",
                mend="Reduce chamber_width or raise width.",
            )  # fmt: skip
        if self.channel_width >= self.chamber_width:
            raise DesignError(
                f"channel_width is {self.channel_width * 1e3:.2f} mm, but the channel must be "
                f"narrower than the chambers ({self.chamber_width * 1e3:.2f} mm). Reduce it.",
                field="channel_width", value=f"{self.channel_width * 1e3:.2f} mm",
                mend="Reduce channel_width.",
            )  # fmt: skip
        if self.channel_width > 0 and self.channel_height > self.foot_height - 0.3e-3 + 1e-9:
            raise DesignError(
                f"channel_height is {self.channel_height * 1e3:.4g} mm, which leaves "
                f"{(self.foot_height - self.channel_height) * 1e3:.4g} mm of the foot "
                f"({self.foot_height * 1e3:.4g} mm) between the channel and the open gaps; it must "
                "be 0.30 mm or more. Reduce channel_height, raise foot_height, or set "
                "channel_width to 0.",
                field="channel_height", value=f"{self.channel_height * 1e3:.4g} mm",
                mend="Reduce channel_height, raise foot_height, or set channel_width to 0.",
            )  # fmt: skip
        needed = self.chamber_count * self.pitch + self.width * self.cot_theta + 1e-3
        if self.length < needed:
            raise DesignError(
                f"length is {self.length * 1e3:.4g} mm, but {self.chamber_count} chambers of pitch "
                f"{self.pitch * 1e3:.4g} mm at {math.degrees(self.theta):.4g} degrees need "
                f"{needed * 1e3:.4g} mm. Lengthen the bar, use fewer chambers or a larger angle.",
                field="length", value=f"{self.length * 1e3:.4g} mm",
                mend="Lengthen the bar, use fewer chambers or a larger angle.",
                changes=fitting(needed, self.length, self.chamber_count, self.pitch),
            )  # fmt: skip
