"""What the simulations feature takes and gives."""

from datetime import datetime
from typing import Annotated, Literal

from pydantic import ConfigDict, Field

from backend.documents import Answer, Body, DesignDocument, SceneDocument, Triple

InstantRung = Literal["closed-form", "energy", "cell-rod"]
JobState = Literal["queued", "running", "done", "failed", "cancelled"]


class PathPoint(Answer):
    """State at one pressure; null where the rung cannot know a quantity."""

    model_config = ConfigDict(extra="allow")

    pressure_kPa: float | None
    tip_mm: Triple = Field(description="Tip point X1, X2, X3 [mm]")
    tip_displacement_mm: Triple = Field(description="From the undeformed tip point [mm]")
    tip_rotation_deg: float | None = Field(description="Of the end face about X2 [deg]")
    bending_angle_deg: float | None = Field(
        description="Line clamp to tip point against X1, positive towards the bottom layer [deg]"
    )
    curvature_per_m: float | None
    torsion_per_m: float | None
    helix_radius_mm: float | None = None
    helix_pitch_mm: float | None = None
    cavity_volume_ml: float | None = None
    max_principal_stretch: float | None = None
    plate_force_N: float | None = Field(default=None, description="On the rigid plate [N]")
    cylinder_force_N: float | None = Field(default=None, description="On the rigid cylinder [N]")
    max_contact_pressure_kPa: float | None = Field(
        default=None, description="Largest on any touching surface [kPa]; null where none touches"
    )


class EffectNote(Answer):
    """One physical effect: on or off, and why."""

    name: str
    on: bool
    reason: str
    estimated_change_percent: float | None = Field(
        description="How much leaving it out would change the tip's way, estimated beforehand [%]"
    )
    cost_s: float | None = Field(
        description="What having it costs, or would cost, in this answer [s]; below 0: it saves"
    )
    cost_factor: float | None = Field(
        default=None, description="Time of an answer with it over one without, as measured"
    )
    forced: Literal["auto", "on", "off"] = Field(
        default="auto", description="The scene's own choice"
    )


class BodyFiles(Answer):
    """Fields in the whole body, kept beside a result as the file `result-body`."""

    points: int = Field(description="How many of the path's points they show, the last among them")
    bytes: int


class ResultDocument(Answer):
    """Answer of one rung, as `pneustudio predict --json` prints it."""

    model_config = ConfigDict(extra="allow")

    design: DesignDocument
    scene: SceneDocument
    rung: str
    outcome: str = Field(
        description="converged, limit_point, stalled, cancelled or budget_spent; of the part of a "
        "path that a job had found which broke off: failed or worker_lost"
    )
    advice: str | None = Field(description="What to do about an early end")
    path: list[PathPoint] = Field(description="From zero pressure on, after gravity")
    error_estimate_percent: float | None = Field(description="Of the tip's displacement [%]")
    error_estimates_percent: dict[str, float | None] = Field(
        default={}, description="Estimated errors by quantity: tip, angle, force, volume [%]"
    )
    limit_pressure_kPa: float | None = Field(
        default=None,
        description="There is no equilibrium above this pressure [kPa]; null: none was met",
    )
    trusted_to_kPa: float | None = Field(
        default=None,
        description="The rung's own assumptions hold up to here [kPa]; null: on the whole path",
    )
    wall_s: float | None = Field(description="Time of the solve [s]")
    unknowns: int
    newton_iterations: int
    effects: list[EffectNote]
    assumptions: list[str]
    notes: list[str] = Field(default=[], description="Findings a designer must read")
    body_files: BodyFiles | None = Field(
        default=None, description="Of a job's result: fields in the whole body, where kept"
    )


class PredictRequest(Body):
    """A question the instant rungs answer at once."""

    design: DesignDocument
    scene: SceneDocument
    rung: InstantRung = "energy"
    c: Literal["computed", "published"] | Annotated[float, Field(gt=0, le=10000)] = Field(
        default="computed",
        description="Constant of the energy model: computed from the cell, the published one, or "
        "a number (dimensionless)",
    )
    beyond: Literal["refuse", "leave out"] = Field(
        default="refuse",
        description="What to do with loads the rung cannot carry: refuse the question (422, naming "
        "the load and the rung that can), or answer without them and list them in `left_out`",
    )


class LeftOutLoad(Answer):
    """A load that the answer does not hold, because its rung cannot carry it."""

    field: str = Field(description="Entry of the scene: 'plate', 'tip_force', 'volume', ...")
    reason: str


class TypicalError(Answer):
    """How far off such an answer typically is: of the tip's displacement, in percent."""

    half_below_percent: float
    four_of_five_below_percent: float
    source: str = Field(description="Who measured it, on what")


class Prediction(Answer):
    """An instant answer and how long its stages took."""

    result: ResultDocument
    left_out: list[LeftOutLoad] = Field(
        description="Loads that were left out; the result's `scene` is the one answered. A volume "
        "to reach is replaced by the pressure at which the rung's own cavity has it"
    )
    typical_errors: list[TypicalError | None] = Field(
        description="For every point of the result's path; null where nobody has measured"
    )
    timings_ms: dict[str, float] = Field(description="Milliseconds by stage; `total` is all [ms]")


class NewJob(Body):
    """A question for the queue."""

    version_id: str
    scene: SceneDocument | None = Field(
        default=None, description="The version's own scene when left out"
    )
    rung: Literal["fe", "cell-rod"] = "fe"
    accuracy: float = Field(
        default=0.05, ge=0.001, le=0.5, description="Wanted accuracy as a fraction: 0.05 is 5 %"
    )
    mesh: str | None = Field(
        default=None,
        max_length=20,
        description="One mesh to solve on, in place of refining to the accuracy: coarse, medium, "
        "fine, finest, or thin layers along X1, X2 and X3 such as '1,0,1'",
    )


class Job(Answer):
    """A job: what was asked, how far it is, how it ended."""

    id: str
    version_id: str
    version_number: int
    design_id: str
    design_name: str
    rung: str
    accuracy: float = Field(description="Fraction: 0.05 is 5 %")
    mesh: str | None = Field(description="The one mesh asked for; null: the accuracy decides")
    pressure_to_kPa: float | None = Field(
        description="End of the path asked for [kPa]; null where a volume ends it"
    )
    volume_to_ml: float | None = Field(
        description="Cavity volume that ends the path [ml]; null where a pressure ends it"
    )
    pressure_kPa: float | None = Field(description="How far the solver is [kPa]")
    state: JobState
    outcome: str | None = Field(
        description="Of the answer, as in a result document; of a failed job why there is none, "
        "or but a part: refused, failed, worker_lost or budget_spent"
    )
    has_answer: bool = Field(
        description="Whether there is a result to read and to show; of a cancelled or failed job "
        "it is the part of the path that was found by then"
    )
    advice: str | None
    fraction: float = Field(description="Progress, 0 to 1")
    message: str
    created_at: datetime
    started_at: datetime | None
    finished_at: datetime | None
    elapsed_s: float | None = Field(description="Since the start, or from start to end [s]")
    attempt: int
    lost: int = Field(description="Attempts whose worker vanished; the job was taken up again")
    from_store: bool = Field(description="True when a stored result answered it without a solve")
    cancelling: bool = Field(description="True while a running job was asked to stop")
    author: str
    error: str | None = Field(description="Why a failed job failed")
