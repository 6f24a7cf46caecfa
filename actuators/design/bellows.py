"""Family ``bellows`` (B): rounded bellows printed sideways, one next to the other.

Seen from the side the top is one wavy skin of constant thickness: it runs around the rounded crown
of a bellows, straight down, around a tight valley and up again; neighbours almost touch. The same
profile stands over the whole width, closed by a side wall on either side. Air is connected under
the valleys.
"""

from typing import ClassVar, Literal

from actuators.design.base import Design
from actuators.design.mends import up_to_tenths
from actuators.design.parameter import parameter
from actuators.design.wave import Wave
from actuators.errors import Change, DesignError

NOT_GIVEN = "is not known from the paper (B); the studio's default is an assumption"
MEASURED = (
    "with these dimensions 3D finite elements bend the nine presets 1.9 to 4.7 times as far as the "
    "paper (B) measured its bodies; why is not resolved, see docs/validation.md"
)
SMALLEST = 0.3e-3


class BellowsDesign(Design):
    """Printed bellows, all values in SI."""

    title: ClassVar[str] = "Printed bellows"
    layer_materials: ClassVar[tuple[str, str]] = ("material", "material")
    family: Literal["bellows"] = "bellows"  # pyright: ignore[reportIncompatibleVariableOverride]

    length: float = parameter(
        115.0, label="Length", group="Outline", kind="length", lower=10, upper=1000, step=1,
        help="From the clamp to the free end.", source="B, Table 1",
    )  # fmt: skip
    width: float = parameter(
        17.0, label="Width", group="Outline", kind="length", lower=2, upper=200, step=0.5,
        help="Outer width; the bellows are as wide.", source="B, Table 1",
    )  # fmt: skip
    total_height: float = parameter(
        20.0, label="Height", group="Outline", kind="length", lower=2, upper=200, step=0.5,
        help="From the underside to the top of the bellows.", source="B, Table 1",
    )  # fmt: skip
    chamber_count: int = parameter(
        11, label="Bellows", symbol="N", group="Bellows", kind="count", lower=1, upper=60, step=1,
        help="Number of bellows along the length.", source="B, Table 1",
    )  # fmt: skip
    wall_thickness: float = parameter(
        2.0, label="Wall", symbol="S", group="Bellows", kind="length", lower=0.2, upper=20,
        step=0.1, help="Thickness of the bellows' skin and of the side walls.",
        source="B, Table 1",
    )  # fmt: skip
    gap: float = parameter(
        0.4, label="Gap", group="Bellows", kind="length", lower=0.1, upper=20, step=0.05,
        help="Distance between neighbouring bellows, which almost touch; the valley between them "
        "is a half circle of this diameter.",
        assumed="gap is not known from the paper (B), whose neighbouring bellows touch; the "
        "studio's default is an assumption",
    )  # fmt: skip
    channel_height: float = parameter(
        2.0, label="Air channel height", group="Bellows", kind="length", lower=0.3, upper=100,
        step=0.1, help="Height of the air under the valleys, which connects the bellows.",
        assumed=f"channel_height {NOT_GIVEN}",
    )  # fmt: skip
    end_length: float = parameter(
        4.0, label="End piece", group="Outline", kind="length", lower=0.3, upper=200, step=0.5,
        help="Solid piece at either end, as high as the valleys.",
        assumed=f"end_length {NOT_GIVEN}",
    )  # fmt: skip
    bottom_thickness: float = parameter(
        2.0, label="Bottom", group="Layers", kind="length", lower=0.2, upper=50, step=0.1,
        help="Rubber under the bellows.",
        assumed="bottom_thickness is not known from the paper (B); the presets assume that the "
        "bottom is as thick as the walls",
    )  # fmt: skip
    material: str = parameter(
        "ninjaflex-ogden-002", label="Material", group="Materials", kind="material",
        help="The one material that the body is printed from.", source="B, Table 4",
    )  # fmt: skip

    @property
    def wave(self) -> Wave:
        """One pitch of the skin."""
        return Wave(
            pitch=self.pitch, gap=self.gap, thickness=self.wall_thickness,
            floor=self.bottom_thickness, channel=self.channel_height, height=self.total_height,
        )  # fmt: skip

    @property
    def pitch(self) -> float:
        """From one bellows to the next [m]."""
        return (self.length - 2 * self.end_length) / self.chamber_count

    @property
    def height(self) -> float:
        """Total height [m]."""
        return self.total_height

    @property
    def end_height(self) -> float:
        """Height of the solid ends: bottom, channel and skin together [m]."""
        return self.bottom_thickness + self.channel_height + self.wall_thickness

    @property
    def inner_width(self) -> float:
        """Width of the air between the side walls [m]."""
        return self.width - 2 * self.wall_thickness

    def assumptions(self) -> tuple[str, ...]:
        return (*super().assumptions(), MEASURED)

    def check(self) -> None:
        wave = self.wave
        wall = _mm(self.wall_thickness)
        if self.inner_width < SMALLEST:
            raise DesignError(
                f"wall_thickness is {wall}, which leaves {_mm(self.inner_width)} of air in a body "
                f"{_mm(self.width)} wide; it must be 0.30 mm or more. Thin the walls or raise "
                "width.",
                field="wall_thickness", value=wall, mend="Thin the walls or raise width.",
            )  # fmt: skip
        if wave.crown < SMALLEST:
            mend = "Use fewer bellows, a thinner wall, a smaller gap or a longer body."
            raise DesignError(
                f"chamber_count is {self.chamber_count}, which leaves a pitch of "
                f"{_mm(self.pitch)} and an inner radius of {_mm(wave.crown)} in the crown of each "
                f"bellows ({wall} wall, {_mm(self.gap)} gap); it must be 0.30 mm or more. {mend}",
                field="chamber_count", value=str(self.chamber_count), mend=mend,
            )  # fmt: skip
        if wave.straight < SMALLEST:
            least = self.total_height - wave.straight + SMALLEST
            mend = f"Raise total_height to {_mm(least)} or more, or use more or thinner bellows."
            raise DesignError(
                f"total_height is {_mm(self.total_height)}, but bottom, channel, valley and crown "
                f"of bellows with a pitch of {_mm(self.pitch)} need {_mm(least)}. {mend}",
                field="total_height", value=_mm(self.total_height), mend=mend,
                changes=(Change("total_height_mm", up_to_tenths(least)),),
            )  # fmt: skip


def _mm(value: float) -> str:
    return f"{value * 1e3:.4g} mm"
