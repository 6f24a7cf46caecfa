"""Family ``slab`` (S, Fig. 3 and Table 1): a stiff bottom layer glued to a soft top layer.

Chambers are through-slots in the chamber layer, mirrored about a central channel that connects
them, closed by a thin roof. Axes: X1 from the clamp along the length, X2 across (0 in the middle),
X3 up from the underside.
"""

import math
from typing import ClassVar, Literal

import numpy as np

from actuators.design.base import Design
from actuators.design.parameter import parameter
from actuators.errors import Change, DesignError

NOT_GIVEN = "is not given in the paper (S); the studio's default is an assumption"
SMALLEST_WALL = 0.3e-3


class SlabDesign(Design):
    """Slab actuator, all values in SI.

    Half width of the planform at ``x``: rectangle ``width/2``; triangle linear from ``width/2`` at
    the clamp to ``tip_width/2``; ellipse two arcs of radius ``side_radius``, widest in the middle.
    The arms of every chamber end ``side_wall`` inside the outline and follow it.
    """

    title: ClassVar[str] = "Slab"
    family: Literal["slab"] = "slab"  # pyright: ignore[reportIncompatibleVariableOverride]

    planform: Literal["rectangle", "triangle", "ellipse"] = parameter(
        "rectangle", label="Planform", group="Outline", kind="choice",
        choices=("rectangle", "triangle", "ellipse"),
        help="Outline seen from above.", source="S, Fig. 3",
    )  # fmt: skip
    length: float = parameter(
        89.0, label="Length", symbol="h", group="Outline", kind="length", lower=10, upper=1000,
        step=1, help="From the clamp to the free end.", source="S, Table 1",
    )  # fmt: skip
    width: float = parameter(
        45.0, label="Width", symbol="w", group="Outline", kind="length", lower=3, upper=300,
        step=0.5, help="Largest width of the planform.", source="S, Table 1",
    )  # fmt: skip
    tip_width: float = parameter(
        15.0, label="Tip width", group="Outline", kind="length", lower=1, upper=300, step=0.5,
        help="Width at the free end; used by the triangle only.",
        assumed=f"tip_width {NOT_GIVEN}",
    )  # fmt: skip
    side_radius: float = parameter(
        126.0, label="Side arc radius", symbol="R", group="Outline", kind="length", lower=5,
        upper=10000, step=1, help="Radius of the side arcs; used by the ellipse only.",
        source="S, Table 1",
    )  # fmt: skip
    chamber_count: int = parameter(
        6, label="Chambers", symbol="n", group="Chambers", kind="count", lower=1, upper=60, step=1,
        help="Number of chambers along the length.", source="S, Table 1 (read off h1)",
    )  # fmt: skip
    root_wall: float = parameter(
        6.0, label="Root wall", symbol="h0", group="Chambers", kind="length", lower=0.5, upper=200,
        step=0.1, help="Solid rubber between the clamp and the first chamber.",
        source="S, Table 1",
    )  # fmt: skip
    tip_wall: float = parameter(
        3.0, label="Tip wall", group="Chambers", kind="length", lower=0.5, upper=200, step=0.1,
        help="Solid rubber between the last chamber and the free end.",
        source="S, Table 1 (remainder)",
    )  # fmt: skip
    wall_ratio: float = parameter(
        1.0, label="Wall to chamber ratio", symbol="h2/h1", group="Chambers", kind="ratio",
        lower=0.05, upper=10, step=0.05,
        help="Length of a wall between chambers over the length of a chamber.",
        source="S, Table 1 (h1 = h2)",
    )  # fmt: skip
    channel_width: float = parameter(
        4.0, label="Channel width", symbol="w0", group="Chambers", kind="length", lower=0.2,
        upper=100, step=0.1, help="Central channel that connects the chambers.",
        source="S, Table 1",
    )  # fmt: skip
    side_wall: float = parameter(
        3.5, label="Side wall", group="Chambers", kind="length", lower=0.3, upper=100, step=0.1,
        help="Rubber between the end of a chamber's arm and the outline.",
        source="S, Table 1 (w = 2 w1 + w0 + 2 side walls)",
    )  # fmt: skip
    bottom_thickness: float = parameter(
        4.0, label="Bottom layer", group="Layers", kind="length", lower=0.1, upper=50, step=0.1,
        help="Thickness of the layer under the chambers.",
        assumed=f"bottom_thickness {NOT_GIVEN}",
    )  # fmt: skip
    chamber_height: float = parameter(
        6.0, label="Chamber layer", group="Layers", kind="length", lower=0.1, upper=100, step=0.1,
        help="Height of the chambers.", assumed=f"chamber_height {NOT_GIVEN}",
    )  # fmt: skip
    roof_thickness: float = parameter(
        6.0, label="Roof", group="Layers", kind="length", lower=0.1, upper=50, step=0.1,
        help="Thickness of rubber above the chambers.", assumed=f"roof_thickness {NOT_GIVEN}",
    )  # fmt: skip
    bottom_material: str = parameter(
        "elastosil-m4601", label="Bottom material", group="Materials", kind="material",
        help="Stiff layer that keeps its length.", source="S, Table 2",
    )  # fmt: skip
    top_material: str = parameter(
        "ecoflex-00-30", label="Top material", group="Materials", kind="material",
        help="Soft layer with the chambers and the roof.", source="S, Table 2",
    )  # fmt: skip

    @property
    def chamber_length(self) -> float:
        """h1 [m]: what root wall, tip wall and walls between leave to each chamber."""
        n = self.chamber_count
        return (self.length - self.root_wall - self.tip_wall) / (n + (n - 1) * self.wall_ratio)

    @property
    def wall_length(self) -> float:
        """h2 [m]."""
        return self.wall_ratio * self.chamber_length

    @property
    def pitch(self) -> float:
        """Chamber and wall together [m]."""
        return self.chamber_length + self.wall_length

    @property
    def height(self) -> float:
        """Total thickness [m]."""
        return self.bottom_thickness + self.chamber_height + self.roof_thickness

    def chamber_starts(self) -> np.ndarray:
        """X1 where each chamber begins, shape (n,) [m]."""
        return self.root_wall + self.pitch * np.arange(self.chamber_count)

    def half_width(self, x: np.ndarray | float) -> np.ndarray:
        """Half width of the planform at X1 = ``x`` [m]; same shape as ``x``."""
        x = np.asarray(x, dtype=float)
        if self.planform == "rectangle":
            return np.full_like(x, self.width / 2)
        if self.planform == "triangle":
            return self.width / 2 + (self.tip_width - self.width) / 2 * x / self.length
        from_middle = x - self.length / 2
        return self.width / 2 - (
            self.side_radius - np.sqrt(np.maximum(self.side_radius**2 - from_middle**2, 0.0))
        )

    def check(self) -> None:
        if self.chamber_length < 0.3e-3:
            raise DesignError(
                f"chamber_count is {self.chamber_count}, which leaves chambers "
                f"{self.chamber_length * 1e3:.2f} mm long; they must be 0.30 mm or longer. "
                "Use fewer chambers, thinner walls or a longer body.",
                field="chamber_count", value=str(self.chamber_count),
                mend="Use fewer chambers, thinner walls or a longer body.",
            )  # fmt: skip
        if self.wall_length < SMALLEST_WALL and self.chamber_count > 1:
            raise DesignError(
                f"wall_ratio is {self.wall_ratio:g}, which leaves walls "
                f"{self.wall_length * 1e3:.2f} mm long; they must be 0.30 mm or longer. "
                "Raise wall_ratio or use fewer chambers.",
                field="wall_ratio", value=f"{self.wall_ratio:g}",
                mend="Raise wall_ratio or use fewer chambers.",
            )  # fmt: skip
        if self.planform == "triangle" and self.tip_width > self.width:
            raise DesignError(
                f"tip_width is {self.tip_width * 1e3:.4g} mm, wider than the clamp "
                f"({self.width * 1e3:.4g} mm). Lower tip_width or raise width.",
                field="tip_width", value=f"{self.tip_width * 1e3:.4g} mm",
                mend="Lower tip_width or raise width.",
                changes=(Change("tip_width_mm", self.width * 1e3),),
            )  # fmt: skip
        if self.planform == "ellipse" and self.side_radius <= self.length / 2:
            raise DesignError(
                f"side_radius is {self.side_radius * 1e3:.4g} mm, but arcs over a length of "
                f"{self.length * 1e3:.4g} mm need more than {self.length * 500:.4g} mm. "
                "Raise side_radius or shorten the body.",
                field="side_radius", value=f"{self.side_radius * 1e3:.4g} mm",
                mend="Raise side_radius or shorten the body.",
            )  # fmt: skip
        narrowest = 2 * float(self.half_width(np.array([0.0, self.length])).min())
        if narrowest < 1e-3:
            raise DesignError(
                f"side_radius is {self.side_radius * 1e3:.4g} mm, whose arcs leave the ends "
                f"{narrowest * 1e3:.2f} mm wide; they must be 1.00 mm or wider. "
                "Raise side_radius or width, or shorten the body.",
                field="side_radius", value=f"{self.side_radius * 1e3:.4g} mm",
                mend="Raise side_radius or width, or shorten the body.",
            )  # fmt: skip
        arm = float(self.arm_spans().min())
        if not math.isfinite(arm) or arm < 0.3e-3:
            raise DesignError(
                f"side_wall is {self.side_wall * 1e3:.2f} mm, which leaves the narrowest chamber "
                f"arms {arm * 1e3:.2f} mm; they must be 0.30 mm or longer. Reduce side_wall or "
                "channel_width, or widen the body.",
                field="side_wall", value=f"{self.side_wall * 1e3:.2f} mm",
                mend="Reduce side_wall or channel_width, or widen the body.",
            )  # fmt: skip

    def assumptions(self) -> tuple[str, ...]:
        unused = "" if self.planform == "triangle" else "tip_width"
        return tuple(p.assumed for p in self.parameters() if p.assumed and p.name != unused)

    def arm_spans(self) -> np.ndarray:
        """w1 at both ends of every chamber, shape (n, 2) [m]."""
        starts = self.chamber_starts()
        ends = np.stack([starts, starts + self.chamber_length], axis=-1)
        return self.half_width(ends) - self.side_wall - self.channel_width / 2
