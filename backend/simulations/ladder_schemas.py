"""What the ladder takes and gives."""

from typing import Annotated, Literal

from pydantic import Field

from backend.documents import Answer, Body, DesignDocument, SceneDocument, Triple


class LadderRequest(Body):
    """A question, and what the designer would put up with."""

    design: DesignDocument
    scene: SceneDocument
    run: list[str] = Field(
        default=["closed-form", "energy", "cell-rod"],
        max_length=8,
        description="Instant rungs to answer now, as far as there are such; the others are looked "
        "up in the store or predicted. `cell-rod` takes about a second for chambers that are new",
    )
    at_most_percent: list[Annotated[float, Field(gt=0, le=1000)]] = Field(
        default=[], max_length=8, description="For each, the cheapest rung within this error [%]"
    )
    at_most_s: list[Annotated[float, Field(gt=0, le=1e6)]] = Field(
        default=[], max_length=8, description="For each, the most accurate rung in this time [s]"
    )


class Range(Answer):
    """A value with the range it is expected in; the three are equal where it was measured."""

    value: float
    low: float
    high: float


class Apart(Answer):
    """How far an answer lies from the best one, in percent of the best one."""

    tip: float = Field(description="Tip's displacement")
    turn: float | None = Field(description="Turn of the free end")
    force: float | None = Field(description="Force on the plate or cylinder")
    limit_pressure: float | None


class LadderPoint(Answer):
    """One rung: a point of error against seconds."""

    rung: str = Field(description="closed-form, energy, cell-rod or fe")
    accuracy_percent: float | None = Field(description="Accuracy asked for (fe) [%]")
    mesh: str | None = Field(description="The one mesh asked for instead of an accuracy")
    label: str = Field(description="As people read it: 'fe 5 %'")
    state: Literal["measured", "predicted", "refused"] = Field(
        description="`measured`: it has run, though its `outcome` may be stalled; `predicted`: it "
        "has not; `refused`: it cannot carry this scene, `reason` says why"
    )
    seconds: Range | None = Field(
        description="Measured, or predicted with the range that holds four of five jobs [s]"
    )
    error_percent: Range | None = Field(
        description="Of the tip's displacement [%]; `low` and `high` are its band. Draw at `value`"
    )
    error_kind: Literal["against best", "own estimate", "typical", "asked for"] | None = Field(
        description="`against best`: distance from the best answer so far, its band that answer's "
        "own estimate; `own estimate`: at most this much by the answer's own estimate; `typical`: "
        "half of such designs below `value`, four of five below `high`; `asked for`: finite "
        "elements end within it"
    )
    error_source: str | None = Field(description="The best answer's label, or who measured it")
    apart_percent: Apart | None
    compared_at_kPa: float | None = Field(description="Last pressure that both answers have")
    is_best: bool = Field(description="The best answer so far")
    outcome: str | None = Field(
        description="How its path ended, as in a result document; of a predicted rung that of a "
        "run cut short (cancelled, budget_spent)"
    )
    advice: str | None
    reason: str | None = Field(description="Why it is refused, or that it was stopped early")
    same_as: str | None = Field(
        description="Label of a rung whose answer is this accurate already: running this one "
        "would repeat it"
    )
    tip_displacement_mm: Triple | None = Field(description="At the end of its path [mm]")
    ends_at_kPa: float | None = Field(description="Where its path ends, or was cut short [kPa]")
    leaves_out: list[str] = Field(description="What of the physics it never holds")
    is_older: bool = Field(description="Computed by an older version of the science")
    job_id: str | None = Field(description="Job that is computing it now")


class LadderChoice(Answer):
    """The rung for one limit."""

    rung: str | None = Field(description="Label of its point; null where none will do")
    why: str = Field(description="One sentence")


class LadderAnswer(Answer):
    """Error against seconds for one design in one scene, cheapest rung first."""

    design: DesignDocument
    scene: SceneDocument
    points: list[LadderPoint]
    best: str | None = Field(description="Label of the best answer so far")
    expected_strain_percent: float = Field(
        description="Largest strain that the linear periodic chamber expects at the end [%]"
    )
    learned_from_jobs: int = Field(
        description="Past jobs of this machine that predicted seconds rest on, beside the "
        "package's record"
    )
    choices: list[LadderChoice] = Field(
        description="For each of `at_most_percent`, then for each of `at_most_s`"
    )
