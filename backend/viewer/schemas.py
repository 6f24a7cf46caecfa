"""What the viewer feature takes and gives."""

from typing import Annotated, Literal

from pydantic import Field

from backend.documents import Answer, Body, DesignDocument, SceneDocument
from backend.simulations.schemas import InstantRung

Colour = Literal["displacement", "stretch", "stress", "contact", "none"]
Camera = Literal["three-quarter", "side", "top", "below", "front"]


class NewView(Body):
    """How a view begins."""

    dark: bool = Field(default=False, description="Dark background")


class View(Answer):
    """A view: show `url` in an iframe."""

    view_id: str
    url: str


class InstantSource(Body):
    """Show the answer of an instant rung: the undeformed body, bent along its centreline."""

    kind: Literal["instant"]
    design: DesignDocument
    scene: SceneDocument
    rung: InstantRung = Field(
        default="energy",
        description="`cell-rod` answers the scene as it stands, or refuses; the others leave out "
        "loads that they cannot carry",
    )


class JobSource(Body):
    """Show the stored result of a job; of a path that ended early, the part that was found."""

    kind: Literal["job"]
    job_id: str


class ContentRequest(Body):
    """What a view shows. Sending the same again is harmless."""

    source: Annotated[InstantSource | JobSource, Field(discriminator="kind")]
    colour: Colour = "displacement"
    undeformed: bool = Field(default=True, description="Show the undeformed body as well")
    frame: int | None = Field(
        default=None, ge=0, le=1000,
        description="Index to show first; the one shown before, or the last, when left out",
    )  # fmt: skip


class Legend(Answer):
    """Colour scale of what is shown."""

    label: str
    unit: str
    lower: float = Field(description="Value at position 0, in `unit`")
    upper: float = Field(description="Value at position 1, in `unit`")
    clipped: bool = Field(
        description="Whether a few values lie beyond the scale and take the colour of its end"
    )
    stops: list[tuple[float, str]] = Field(description="[position 0..1, '#rrggbb']")


class Content(Answer):
    """What a view shows as soon as its page has loaded it."""

    rung: str = Field(description="Model whose shape it is")
    take: str = Field(
        description="Name of these bodies: the view's page posts `{shown: take}` to the page "
        "around it once they are in view"
    )
    pressures_kPa: list[float] = Field(description="Pressure of every frame [kPa]")
    volumes_ml: list[float | None] = Field(
        description="Cavity volume of every frame [ml]; null where the source does not know it"
    )
    frame: int = Field(description="Index now visible")
    colour: Colour = Field(
        description="Colour used: 'displacement' when the source lacks the one asked"
    )
    colours: list[Colour] = Field(description="Colours this source can show")
    legend: Legend | None = Field(description="Null for colour 'none'")
    vertices: int = Field(description="Vertices of one frame")
    timings_ms: dict[str, float] = Field(description="Milliseconds by stage [ms]")


class FrameRequest(Body):
    """Which frame to show."""

    index: int = Field(ge=0, le=1000, description="Index into `pressures_kPa`")


class AppearanceRequest(Body):
    """Light or dark, and where the camera stands; what is left out stays."""

    dark: bool | None = None
    camera: Camera | None = None


class LoadedBodies(Body):
    """What a page of a view says about the bodies it was sent."""

    take: str = Field(max_length=40, description="Which content they belong to")
    bodies: int = Field(ge=0, le=1000, description="How many of them it has loaded")
    page: str = Field(max_length=60, description="Tells pages of one view apart")
