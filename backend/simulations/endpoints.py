"""Instant answers, and jobs."""

from fastapi import APIRouter, Query

from backend.simulations import jobs, service
from backend.simulations.schemas import (
    Job,
    JobState,
    NewJob,
    Prediction,
    PredictRequest,
    ResultDocument,
)
from backend.wiring import Author, Queue, Storage

router = APIRouter(tags=["simulations"])


@router.post("/predict")
def predict(body: PredictRequest) -> Prediction:
    """Ask an instant rung; nothing is stored."""
    return service.predict(body)


@router.post("/jobs", status_code=201)
def submit_job(body: NewJob, store: Storage, author: Author, queue: Queue) -> Job:
    """Ask a question of the queue. One that was answered before is answered from the store at
    once; one that is being solved is joined."""
    return jobs.submit(store, queue, body, author)


@router.get("/jobs")
def list_jobs(
    store: Storage,
    version_id: str | None = Query(default=None, max_length=100),
    state: JobState | None = None,
    limit: int = Query(default=100, ge=1, le=1000),
) -> list[Job]:
    """Jobs, newest first."""
    return jobs.listing(store, version_id=version_id, state=state, limit=limit)


@router.get("/jobs/{job_id}")
def get_job(job_id: str, store: Storage) -> Job:
    """A job as it is now."""
    return jobs.detail(store, job_id)


@router.post("/jobs/{job_id}/cancel")
def cancel_job(job_id: str, store: Storage) -> Job:
    """Ask a job to stop; a finished one stays as it is."""
    return jobs.cancel(store, job_id)


@router.get("/jobs/{job_id}/result")
def get_job_result(job_id: str, store: Storage) -> ResultDocument:
    """The result document of a done job."""
    return jobs.result(store, job_id)
