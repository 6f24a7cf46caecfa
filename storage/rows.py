"""What comes out of the database: frozen rows, times in UTC, SI."""

from dataclasses import dataclass
from datetime import UTC, datetime
from enum import StrEnum
from typing import Any, Literal

JobState = Literal["queued", "running", "done", "failed", "cancelled"]


@dataclass(frozen=True)
class DesignRow:
    """A named design. ``updated_at``: time of its newest version, ``latest_version_id``."""

    id: str
    name: str
    author: str
    created_at: datetime
    archived_at: datetime | None
    forked_from: str | None
    updated_at: datetime
    latest_version_id: str
    version_count: int
    family: str

    @property
    def archived(self) -> bool:
        return self.archived_at is not None


@dataclass(frozen=True)
class VersionRow:
    """One state in a design's history; never changed except for its label.

    ``document`` and ``scene`` are in border units, canonical, so that equal ones compare equal.
    """

    id: str
    design_id: str
    number: int
    parent_id: str | None
    author: str
    created_at: datetime
    note: str
    label: str | None
    document: dict[str, Any]
    scene: dict[str, Any]
    design_digest: str
    scene_digest: str


@dataclass(frozen=True)
class JobRow:
    """A question put to the queue. ``pressure`` [Pa] is how far the solver got; ``mesh`` is the
    one mesh asked for, None where the accuracy decides.

    ``digest`` names the question and, once done, its result (:meth:`Store.get_result`).
    ``from_store``: answered by a result that another job had computed. ``follows``: the job that
    computes the same question for another version. ``lost``: attempts whose worker vanished.
    ``outcome``: how the answer ended, of a job that failed why there is none
    (:data:`storage.question.Failure`). ``kept_part``: of such a job, whether the part of the path
    that was found by then is its result.
    """

    id: str
    version_id: str
    version_number: int
    design_id: str
    design_name: str
    author: str
    scene: dict[str, Any]
    rung: str
    accuracy: float
    science_version: str
    design_digest: str
    scene_digest: str
    digest: str
    budget_s: float
    mesh: str | None
    state: JobState
    created_at: datetime
    started_at: datetime | None
    finished_at: datetime | None
    fraction: float
    message: str
    pressure: float | None
    outcome: str | None
    advice: str | None
    error: str | None
    from_store: bool
    follows: str | None
    attempt: int
    lost: int
    worker: str | None
    cancel_requested: bool
    kept_part: bool

    @property
    def active(self) -> bool:
        return self.state in ("queued", "running")

    @property
    def has_answer(self) -> bool:
        """Whether there is a result: of a job that was cancelled or failed, the part found by
        then."""
        if self.state == "cancelled":
            return self.outcome is not None
        return self.state == "done" or (self.state == "failed" and self.kept_part)

    def elapsed_s(self, now: datetime | None = None) -> float | None:
        """Seconds computed so far, or in all; None before the start."""
        if self.started_at is None:
            return None
        return ((self.finished_at or now or datetime.now(UTC)) - self.started_at).total_seconds()


@dataclass(frozen=True)
class ClaimedJob:
    """What a worker needs to compute a job it holds. Every write names ``attempt``."""

    id: str
    attempt: int
    design: dict[str, Any]
    scene: dict[str, Any]
    rung: str
    accuracy: float
    digest: str
    budget_s: float
    mesh: str | None


class Hold(StrEnum):
    """What a worker's claim is worth: still held, to be given up for a cancel, or gone."""

    HELD = "held"
    CANCEL = "cancel"
    GONE = "gone"


@dataclass(frozen=True)
class ResultRow:
    """A stored answer; ``document`` as ``predict --json``, ``artifact_sha256`` its arrays,
    ``body_files_sha256`` fields in the whole body of ``body_files_points`` of its points, as long
    as they are kept."""

    digest: str
    design_digest: str
    scene_digest: str
    rung: str
    accuracy: float
    science_version: str
    outcome: str
    document: dict[str, Any]
    artifact_sha256: str | None
    created_at: datetime
    mesh: str | None
    body_files_sha256: str | None
    body_files_points: int | None


@dataclass(frozen=True)
class TimingRow:
    """How long a worker took over a question. ``design`` and ``scene`` in border units; ``mesh``:
    the one asked for, None where the accuracy decided; ``seconds``: on the clock or, where fewer,
    of the processor, for a machine busy with other work is not slow; ``unknowns`` of the mesh it
    ended on, ``estimates_percent`` of its errors there; ``stopped``: by somebody or by its budget,
    before its end; ``worker`` is ``name@machine``, None of one that somebody stopped."""

    digest: str
    design: dict[str, Any]
    scene: dict[str, Any]
    accuracy: float
    mesh: str | None
    seconds: float
    unknowns: int
    estimates_percent: dict[str, float | None]
    outcome: str
    stopped: bool
    worker: str | None
    finished_at: datetime


@dataclass(frozen=True)
class EventRow:
    """Something that happened. ``kind`` "job": ``subject`` is a job id; "history": a design id."""

    seq: int
    at: datetime
    kind: Literal["job", "history"]
    subject: str
    data: dict[str, Any]


@dataclass(frozen=True)
class WorkerRow:
    """A worker process that has reported itself."""

    name: str
    science_version: str
    started_at: datetime
    last_seen: datetime
