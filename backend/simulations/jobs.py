"""Jobs: questions for the queue, as the page sees them."""

import logging
from contextlib import suppress

from backend.simulations.queue import TaskQueue
from backend.simulations.schemas import BodyFiles, Job, JobState, NewJob, ResultDocument
from storage import JobRow, NotFoundError, ResultRow, Store

log = logging.getLogger(__name__)


def submit(store: Store, queue: TaskQueue, body: NewJob, author: str) -> Job:
    """Put a question to the queue, and wake a worker for it."""
    version = store.get_version(body.version_id)
    scene = version.scene if body.scene is None else body.scene
    row = store.submit(version.id, scene, body.rung, body.accuracy, author, mesh=body.mesh)
    if row.state == "queued":
        queue.publish(store)
    return as_job(row)


def listing(
    store: Store, *, version_id: str | None, state: JobState | None, limit: int
) -> list[Job]:
    """Jobs, newest first."""
    states: list[JobState] | None = None if state is None else [state]
    rows = store.list_jobs(version_id=version_id, states=states, limit=limit)
    return [as_job(row) for row in rows]


def detail(store: Store, job_id: str) -> Job:
    """A job as it is now."""
    return as_job(store.get_job(job_id))


def cancel(store: Store, job_id: str) -> Job:
    """Ask a job to stop."""
    return as_job(store.cancel(job_id))


def result(store: Store, job_id: str) -> ResultDocument:
    """The stored answer of a job, or the part found before it was cancelled or failed; else 404."""
    job = store.get_job(job_id)
    if not job.has_answer:
        raise NotFoundError("result of job", job_id)
    row = store.get_result(job.digest)
    return ResultDocument.model_validate({**row.document, "body_files": _body_files(store, row)})


def _body_files(store: Store, row: ResultRow) -> BodyFiles | None:
    if row.body_files_sha256 is None or row.body_files_points is None:
        return None
    with suppress(NotFoundError):  # they may leave meanwhile, for those of a newer answer
        size = store.artifact_size(row.body_files_sha256)
        return BodyFiles(points=row.body_files_points, bytes=size)
    return None


def as_job(row: JobRow) -> Job:
    """A row in border units."""
    pressure = row.scene.get("pressure_kPa") or {}
    volume = row.scene.get("volume_ml") or {}
    return Job(
        id=row.id,
        version_id=row.version_id,
        version_number=row.version_number,
        design_id=row.design_id,
        design_name=row.design_name,
        rung=row.rung,
        accuracy=row.accuracy,
        mesh=row.mesh,
        pressure_to_kPa=pressure.get("to"),
        volume_to_ml=volume.get("to"),
        pressure_kPa=None if row.pressure is None else row.pressure / 1e3,
        state=row.state,
        outcome=row.outcome,
        has_answer=row.has_answer,
        advice=row.advice,
        fraction=row.fraction,
        message=row.message,
        created_at=row.created_at,
        started_at=row.started_at,
        finished_at=row.finished_at,
        elapsed_s=row.elapsed_s(),
        attempt=row.attempt,
        lost=row.lost,
        from_store=row.from_store,
        cancelling=row.cancel_requested and row.state == "running",
        author=row.author,
        error=row.error,
    )
