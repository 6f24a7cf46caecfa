"""What the designs feature takes and gives."""

from datetime import datetime
from typing import Literal

from pydantic import Field

from actuators.design.parameter import Kind
from backend.documents import Answer, Body, DesignDocument, Name, Note, Point, SceneDocument
from backend.history.schemas import VersionDetail, VersionSummary


class ParameterInfo(Answer):
    """One parameter of a family, in the order a designer reads them."""

    name: str = Field(description="Plain name, as errors and dimension lines use it")
    border_name: str = Field(description="Key in design documents, with the unit")
    label: str
    symbol: str = Field(description="Symbol of the source paper, or empty")
    group: str
    kind: Kind
    unit: str = Field(description="Unit of value, limits and step: 'mm', 'deg' or empty")
    lower: float | None = Field(description="Smallest value, in `unit`")
    upper: float | None = Field(description="Largest value, in `unit`")
    step: float | None = Field(description="Step of a slider, in `unit`")
    choices: list[str]
    help: str
    source: str
    assumed: str = Field(description="Sentence, when no source gives this dimension; else empty")
    default: float | str = Field(description="Default value, in `unit`")


class FamilyInfo(Answer):
    """A family of actuators and its parameters."""

    family: str
    title: str
    parameters: list[ParameterInfo]


class PresetInfo(Answer):
    """An actuator of the source papers."""

    name: str
    title: str
    description: str
    source: str
    design: DesignDocument
    pressure_to_kPa: float = Field(description="Top of the pressure range to show [kPa]")


class CheckRequest(Body):
    """A design to check."""

    design: DesignDocument


class DerivedValue(Answer):
    """A number that follows from the parameters."""

    label: str
    value: float
    unit: str


class DrawingShape(Answer):
    """One filled area, of rubber, cavity or open air between blocks."""

    kind: str
    region: str | None = Field(description="Name of the region; null where there is no rubber")
    material: str | None = Field(description="Key of the material; null where there is none")
    rings: list[list[Point]] = Field(description="Rings, not closed; fill by the even-odd rule")


class DrawingView(Answer):
    """One view, in millimetres; shapes are drawn in this order."""

    title: str
    horizontal: str = Field(description="Axis to the right: 'X1'")
    vertical: str = Field(description="Axis upwards: 'X3' or 'X2'")
    bounds: list[float] = Field(
        min_length=4, max_length=4, description="left, bottom, right, top of all drawn [mm]"
    )
    shapes: list[DrawingShape]


class DrawingViews(Answer):
    """Section on the middle plane and planform at the height of the chambers."""

    section: DrawingView
    planform: DrawingView


class DimensionLine(Answer):
    """Where a parameter is measured, to be highlighted while it is edited."""

    parameter: str = Field(description="Plain name of the parameter")
    view: Literal["section", "planform"]
    kind: Literal["distance", "angle", "radius"] = Field(
        description="An angle turns from `from` to `to` about `centre`; a radius points from "
        "`from` to the arc at `to`"
    )
    label: str = Field(description="Symbol and value, with the unit")
    from_: Point = Field(alias="from", description="Arrow tip")
    to: Point = Field(description="Arrow tip")
    anchors: list[Point] = Field(description="Points on the body, for witness lines")
    centre: Point | None = Field(default=None, description="Of an angle or a radius")


class DrawingRegion(Answer):
    """Which material parameter colours which region."""

    name: str
    parameter: str = Field(description="Plain name of the material parameter")
    material: str = Field(description="Key of the material")


class Drawing(Answer):
    """Two views and their dimension lines."""

    unit: Literal["mm"]
    views: DrawingViews
    dimensions: list[DimensionLine]
    regions: list[DrawingRegion]


class DesignCheck(Answer):
    """A design that can be built, with what follows from it."""

    design: DesignDocument
    digest: str = Field(description="sha256 of the design: equal for equal designs")
    derived: list[DerivedValue]
    assumptions: list[str] = Field(description="Dimensions no source gives, as sentences")
    drawing: Drawing
    unavailable_files: dict[str, str] = Field(
        description="Kinds of files that this family does not have, each with the reason"
    )


class NewDesign(Body):
    """A design to keep under a name; becomes version 1."""

    name: Name
    design: DesignDocument
    scene: SceneDocument
    note: Note = ""


class CreatedDesign(Answer):
    """The design's identifier and its first version."""

    design_id: str
    version: VersionDetail


class DesignSummary(Answer):
    """One line of the list of designs."""

    id: str
    name: str
    family: str
    author: str
    archived: bool
    created_at: datetime
    updated_at: datetime = Field(description="When the latest version was saved")
    version_count: int
    latest_version_id: str


class DesignDetail(Answer):
    """A design and all its versions, newest first."""

    id: str
    name: str
    author: str
    archived: bool
    created_at: datetime
    versions: list[VersionSummary]


class DesignPatch(Body):
    """What to change of a design; what is left out stays."""

    name: Name | None = None
    archived: bool | None = None


class NewVersion(Body):
    """A further version of a design."""

    design: DesignDocument
    scene: SceneDocument
    parent_version_id: str | None = Field(
        default=None, description="Version it was made from; the latest when left out"
    )
    note: Note = ""
