"""Instant answers, and jobs."""

from fastapi import APIRouter, Query, Request
from fastapi.concurrency import run_in_threadpool

from backend.simulations import jobs, service
from backend.simulations import ladder as rungs
from backend.simulations.ladder_schemas import LadderAnswer, LadderRequest, Range
from backend.simulations.schemas import (
    Job,
    JobState,
    NewJob,
    Prediction,
    PredictRequest,
    ResultDocument,
)
from backend.wiring import Author, Helper, Queue, Storage

router = APIRouter(tags=["simulations"])


@router.post("/predict")
async def predict(body: PredictRequest, request: Request, helper: Helper) -> Prediction:
    """Ask an instant rung; nothing is stored. `cell-rod` takes some tenths of a second where its
    chambers are new, in a process of its own: questions wait for their turn, and one whose asker
    has gone away is dropped."""
    if body.rung == "cell-rod":
        return (await helper.answer(body, request.is_disconnected)).given()
    return await run_in_threadpool(service.predict, body)


@router.post("/ladder")
async def ladder(
    body: LadderRequest, request: Request, store: Storage, helper: Helper
) -> LadderAnswer:
    """What every rung costs in seconds and how far off it is. Instant rungs are answered now,
    finite elements are looked up in the store; those that have not run are predicted."""
    question = PredictRequest(design=body.design, scene=body.scene, rung="cell-rod")
    if "cell-rod" in body.run:
        found = await helper.answer(question, request.is_disconnected)
    else:
        found = helper.kept(question)
    return await run_in_threadpool(rungs.ladder, store, body, found)


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


@router.get("/jobs/{job_id}/expected")
def get_expected_seconds(job_id: str, store: Storage) -> Range | None:
    """Seconds that a job under way is expected to take, as the ladder of its question says, with
    the range that holds four of five; null once it has ended."""
    return rungs.expected_seconds(store, job_id)


@router.get("/jobs/{job_id}/result")
def get_job_result(job_id: str, store: Storage) -> ResultDocument:
    """The result document of a job that has an answer."""
    return jobs.result(store, job_id)
