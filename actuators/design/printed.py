"""Family ``printed`` (P): a pneu-net printed in one piece, with a layer that keeps its length.

Separate chamber blocks on a foot, their thin walls facing each other across narrow gaps; an air
channel runs through the foot; a thin layer in the bottom cannot stretch along the axis. The thesis
gives the length, the width, the number of chambers and the layer; every other dimension is
assumed.
"""

import math
from typing import ClassVar, Literal

from actuators.design.base import Design
from actuators.design.blocks import BlockBar, Sheet
from actuators.design.mends import fitting
from actuators.design.parameter import parameter
from actuators.errors import DesignError

NOT_GIVEN = "is not known from the thesis (P); the studio's default is an assumption"
MEASURED = (
    "with the preset's dimensions 3D finite elements bend 0.56 to 0.81 times as far, by the law of "
    "its material, as the thesis (P) measured up to 70 kPa; dimensions that it does not give can "
    "explain it, see docs/validation.md"
)
SMALLEST = 0.3e-3
LEAST_COVER = 0.1e-3
"""Rubber above an embedded layer, and below it unless it lies on the underside [m]."""


class PrintedDesign(Design):
    """Printed pneu-net, all values in SI."""

    title: ClassVar[str] = "Printed pneu-net"
    layer_materials: ClassVar[tuple[str, str]] = ("material", "material")
    family: Literal["printed"] = "printed"  # pyright: ignore[reportIncompatibleVariableOverride]

    length: float = parameter(
        103.0, label="Length", group="Outline", kind="length", lower=10, upper=1000, step=1,
        help="From the clamp to the free end.", source="P",
    )  # fmt: skip
    width: float = parameter(
        17.0, label="Width", group="Outline", kind="length", lower=2, upper=200, step=0.5,
        help="Outer width of the bar.", source="P",
    )  # fmt: skip
    chamber_count: int = parameter(
        14, label="Chambers", symbol="n", group="Chambers", kind="count", lower=1, upper=60,
        step=1, help="Number of chambers along the length.", source="P",
    )  # fmt: skip
    gap: float = parameter(
        1.0, label="Gap", group="Chambers", kind="length", lower=0.1, upper=50, step=0.05,
        help="Open distance between the facing walls of neighbouring chamber blocks.",
        assumed=f"gap {NOT_GIVEN}",
    )  # fmt: skip
    wall_thickness: float = parameter(
        1.2, label="Facing wall", group="Chambers", kind="length", lower=0.1, upper=50, step=0.05,
        help="Thin wall between a chamber and the gap.", assumed=f"wall_thickness {NOT_GIVEN}",
    )  # fmt: skip
    chamber_length: float = parameter(
        3.5, label="Chamber length", group="Chambers", kind="length", lower=0.2, upper=100,
        step=0.05, help="Inner length of a chamber, along the axis.",
        assumed=f"chamber_length {NOT_GIVEN}",
    )  # fmt: skip
    side_wall: float = parameter(
        1.6, label="Side wall", group="Chambers", kind="length", lower=0.3, upper=50, step=0.05,
        help="Wall on either side of the chambers.", assumed=f"side_wall {NOT_GIVEN}",
    )  # fmt: skip
    channel_width: float = parameter(
        3.0, label="Air channel width", group="Chambers", kind="length", lower=0, upper=50,
        step=0.1, help="Channel through the foot that connects the chambers; 0 leaves them "
        "separate, each under the same pressure.", assumed=f"channel_width {NOT_GIVEN}",
    )  # fmt: skip
    channel_height: float = parameter(
        1.5, label="Air channel height", group="Chambers", kind="length", lower=0.1, upper=50,
        step=0.1, help="Height of the channel, from the bottom up; the rest of the foot closes it "
        "under the gaps.", assumed=f"channel_height {NOT_GIVEN}",
    )  # fmt: skip
    bottom_thickness: float = parameter(
        2.5, label="Bottom", group="Layers", kind="length", lower=0.2, upper=50, step=0.1,
        help="Rubber under the chambers, the embedded layer included.",
        assumed=f"bottom_thickness {NOT_GIVEN}",
    )  # fmt: skip
    foot_height: float = parameter(
        2.5, label="Foot", group="Layers", kind="length", lower=0.1, upper=50, step=0.1,
        help="Height over which neighbouring blocks are connected.",
        assumed=f"foot_height {NOT_GIVEN}",
    )  # fmt: skip
    wall_height: float = parameter(
        8.5, label="Free wall height", group="Layers", kind="length", lower=0.1, upper=100,
        step=0.1, help="Height of the separate chamber walls above the foot.",
        assumed=f"wall_height {NOT_GIVEN}",
    )  # fmt: skip
    roof_thickness: float = parameter(
        1.5, label="Roof", group="Layers", kind="length", lower=0.1, upper=50, step=0.1,
        help="Thickness of rubber above the chambers.", assumed=f"roof_thickness {NOT_GIVEN}",
    )  # fmt: skip
    layer: Literal["inextensible", "none"] = parameter(
        "inextensible", label="Embedded layer", group="Embedded layer", kind="choice",
        choices=("inextensible", "none"),
        help="A sheet in the bottom that bends freely but resists stretch along the axis 1000 "
        "times as strongly as as much of the printed rubber would; none leaves it out.",
        source="P", assumed="the stiffness of the embedded layer is not known from the thesis (P), "
        "which calls it inextensible along the axis; it is taken as 1000 times that of as much of "
        "the printed rubber",
    )  # fmt: skip
    layer_thickness: float = parameter(
        0.5, label="Layer thickness", group="Embedded layer", kind="length", lower=0.01, upper=5,
        step=0.05, help="Thickness of the embedded layer; it sets the sheet's stiffness.",
        source="P",
    )  # fmt: skip
    layer_height: float = parameter(
        0.75, label="Layer height", group="Embedded layer", kind="length", lower=0, upper=50,
        step=0.05, help="Middle of the embedded layer above the underside; 0 puts it on the "
        "underside.", assumed=f"layer_height {NOT_GIVEN}",
    )  # fmt: skip
    material: str = parameter(
        "ninjaflex-linear", label="Material", group="Materials", kind="material",
        help="The one material that the body is printed from.", source="P",
    )  # fmt: skip

    @property
    def bottom_material(self) -> str:
        """Material of the bottom."""
        return self.material

    @property
    def top_material(self) -> str:
        """Material of foot, walls and roof."""
        return self.material

    @property
    def bar(self) -> BlockBar:
        """The chamber blocks, straight across the axis."""
        sheet = Sheet(self.layer_height, self.layer_thickness)
        return BlockBar(
            theta=math.pi / 2, chamber_count=self.chamber_count, length=self.length,
            width=self.width, chamber_width=self.width - 2 * self.side_wall,
            half_gap=self.gap / 2, wall_thickness=self.wall_thickness,
            half_chamber=self.chamber_length / 2, channel_width=self.channel_width,
            channel_height=self.channel_height, bottom_thickness=self.bottom_thickness,
            foot_height=self.foot_height, wall_height=self.wall_height,
            roof_thickness=self.roof_thickness, bottom_material=self.material,
            top_material=self.material, sheet=sheet if self.layer == "inextensible" else None,
        )  # fmt: skip

    @property
    def height(self) -> float:
        """Total height [m]."""
        return self.bar.height

    def assumptions(self) -> tuple[str, ...]:
        unused = {"layer", "layer_height"} if self.layer == "none" else set[str]()
        given = tuple(p.assumed for p in self.parameters() if p.assumed and p.name not in unused)
        return (*given, MEASURED)

    def check(self) -> None:
        bar = self.bar
        if bar.chamber_width < SMALLEST:
            raise DesignError(
                f"side_wall is {_mm(self.side_wall)}, which leaves chambers "
                f"{_mm(bar.chamber_width)} wide in a bar of {_mm(self.width)}; they must be "
                "0.30 mm or wider. Reduce side_wall or raise width.",
                field="side_wall", value=_mm(self.side_wall),
                mend="Reduce side_wall or raise width.",
            )  # fmt: skip
        if self.channel_width >= bar.chamber_width:
            raise DesignError(
                f"channel_width is {_mm(self.channel_width)}, but the channel must be narrower "
                f"than the chambers ({_mm(bar.chamber_width)}). Reduce it.",
                field="channel_width", value=_mm(self.channel_width), mend="Reduce channel_width.",
            )  # fmt: skip
        if self.channel_width > 0 and self.channel_height > self.foot_height - SMALLEST + 1e-9:
            raise DesignError(
                f"channel_height is {_mm(self.channel_height)}, which leaves "
                f"{_mm(self.foot_height - self.channel_height)} of the foot "
                f"({_mm(self.foot_height)}) between the channel and the gaps; it must be 0.30 mm "
                "or more. Reduce channel_height, raise foot_height, or set channel_width to 0.",
                field="channel_height", value=_mm(self.channel_height),
                mend="Reduce channel_height, raise foot_height, or set channel_width to 0.",
            )  # fmt: skip
        self._check_layer()
        needed = self.chamber_count * bar.pitch + 1e-3
        if self.length < needed:
            raise DesignError(
                f"length is {_mm(self.length)}, but {self.chamber_count} chambers of pitch "
                f"{_mm(bar.pitch)} and two ends need {_mm(needed)}. Lengthen the bar, use fewer "
                "chambers, or shorten chamber_length, wall_thickness or gap.",
                field="length", value=_mm(self.length),
                mend="Lengthen the bar, use fewer chambers, or shorten chamber_length, "
                "wall_thickness or gap.",
                changes=fitting(needed, self.length, self.chamber_count, bar.pitch),
            )  # fmt: skip

    def _check_layer(self) -> None:
        if self.layer == "none":
            return
        highest = self.bottom_thickness - LEAST_COVER + 1e-9
        buried = LEAST_COVER - 1e-9 <= self.layer_height <= highest
        if self.layer_height != 0.0 and not buried:
            mend = f"Use 0, or 0.10 mm to {_mm(self.bottom_thickness - LEAST_COVER)}."
            raise DesignError(
                f"layer_height is {_mm(self.layer_height)}; the embedded layer must lie on the "
                f"underside or in the bottom ({_mm(self.bottom_thickness)} thick), at least "
                f"0.10 mm from its faces. {mend}",
                field="layer_height", value=_mm(self.layer_height), mend=mend,
            )  # fmt: skip


def _mm(value: float) -> str:
    return f"{value * 1e3:.4g} mm"
