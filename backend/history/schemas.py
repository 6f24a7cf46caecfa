"""What the history feature takes and gives."""

from datetime import datetime

from pydantic import Field

from backend.documents import Answer, Body, DesignDocument, Name, SceneDocument
from backend.simulations.schemas import Job, ResultDocument


class Change(Answer):
    """One parameter that differs from the parent version. `from`/`to` are in `unit`."""

    name: str
    label: str
    unit: str
    from_: float | str | None = Field(alias="from", description="Value in the parent, in `unit`")
    to: float | str | None = Field(description="Value in this version, in `unit`")


class ResultSummary(Answer):
    """An answer to this version's design: found by its own jobs, or for another version that holds
    the same design in the same scene. Each answer stands once."""

    job_id: str
    rung: str
    accuracy: float = Field(description="Fraction: 0.05 is 5 %")
    mesh: str | None = Field(description="The one mesh asked for; null: the accuracy decided")
    outcome: str
    pressure_kPa: float | None = Field(description="Last pressure of the path [kPa]")
    bending_angle_deg: float | None = Field(description="Bending angle there [deg]")
    tip_mm: list[float | None] | None = Field(description="Tip point there, X1 X2 X3 [mm]")
    plate_force_N: float | None = Field(description="On a rigid plate there [N]")
    error_estimate_percent: float | None
    wall_s: float | None = Field(description="Time of the solve [s]")


class VersionSummary(Answer):
    """One line of a design's history."""

    id: str
    number: int
    parent_id: str | None
    label: str | None
    author: str
    created_at: datetime
    note: str
    changes: list[Change] = Field(description="Against the parent; empty for a first version")
    results: list[ResultSummary]


class VersionDetail(Answer):
    """One version, complete."""

    id: str
    number: int
    parent_id: str | None
    design_id: str
    design_name: str
    archived: bool
    label: str | None
    author: str
    created_at: datetime
    note: str
    design: DesignDocument
    scene: SceneDocument
    jobs: list[Job]
    answered_by: list[Job] = Field(
        description="Done jobs of other versions that hold the same design in the same scene (a "
        "fork's origin): their answers are this version's as well; newest first"
    )


class VersionPatch(Body):
    """A name for a version; null takes it away."""

    label: Name | None


class ForkRequest(Body):
    """The new design's name."""

    name: Name


class ParameterPair(Answer):
    """One parameter in two versions, in `unit`; null where a family does not have it."""

    name: str
    label: str
    unit: str
    left: float | str | None
    right: float | str | None
    differs: bool


class ComparedSide(Answer):
    """One of two compared versions."""

    version: VersionDetail
    design: DesignDocument
    instant_result: ResultDocument | None = Field(
        description="Answer of the energy model to the version's own scene"
    )
    instant_left_out: list[str] = Field(
        description="Loads of that scene which the energy model cannot carry and its answer does "
        "not hold"
    )
    instant_error: str | None = Field(description="Why there is no instant answer")
    fe_result: ResultDocument | None = Field(
        description="Answer of the newest finished finite-element job; null when there is none"
    )


class Comparison(Answer):
    """Two versions side by side."""

    parameters: list[ParameterPair]
    left: ComparedSide
    right: ComparedSide
