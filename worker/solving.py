"""One job from claim to answer."""

import logging
import time
from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

from actuators.design import parse_design
from actuators.errors import InputError
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.scene import Scene
from storage import BodyFiles, ClaimedJob, Store, StoreAway
from storage.body_files import BODY_FILES_AT_MOST
from storage.parts import came_to_its_end, run_again
from storage.question import science_version
from storage.response_arrays import pack
from worker.keeper import Keeper, Stop, budget
from worker.rungs import RUNGS, Solved

_logger = logging.getLogger(__name__)
_AFTER_A_BREAKDOWN = "Run it again with a slightly different design or mesh. The worker's log: job "
_INSIST_S = (1.0, 2.0, 4.0, 8.0, 15.0, 30.0)
T = TypeVar("T")


def solve_job(store: Store, job_id: str, *, worker: str) -> None:
    """Claim the job, compute it, store how it ended. Does nothing if there is nothing to claim."""
    job = store.claim(job_id, worker=worker, science_version=science_version())
    if job is None:
        _logger.info("job %s: nothing to do", job_id)
        return
    _logger.info("job %s: attempt %d, rung %s", job.id, job.attempt, job.rung)
    with Keeper(store, job) as keeper:
        ending = _compute(store, job, keeper)
        keeper.solved()
        how = ending() if keeper.stop != "gone" else False
        _logger.info("job %s: %s", job.id, "closed" if how else "given up, another one has it")


def _compute(store: Store, job: ClaimedJob, keeper: Keeper) -> Callable[[], bool]:
    """Solve, and return the write that closes the job."""
    try:
        solved = _solve(job, keeper)
        response = solved.response
        if response.outcome is Outcome.CANCELLED:
            if keeper.stop != "budget" and len(response.path) < 2:
                return lambda: _insist(lambda: store.confirm_cancel(job.id, job.attempt))
            response = part_found(response, job, keeper.stop)
        document, arrays = response.to_document(), pack(response)
    except InputError as error:
        message, mend = str(error), error.mend
        return lambda: _insist(
            lambda: store.fail(job.id, job.attempt, message, why="refused", advice=mend)
        )
    except Exception as error:
        _logger.exception("job %s: the solver failed", job.id)
        message = f"The solver broke down ({type(error).__name__}: {str(error)[:200]})."
        advice, part = _AFTER_A_BREAKDOWN + job.id, keeper.part()
        return lambda: _insist(
            lambda: store.fail(job.id, job.attempt, message, advice=advice, part=part)
        )
    keeper.solved()
    close = store.confirm_cancel if response.outcome is Outcome.CANCELLED else store.finish
    files = _body_files(job, solved)
    return lambda: _insist(lambda: close(job.id, job.attempt, document, arrays, files))


def _body_files(job: ClaimedJob, solved: Solved) -> BodyFiles | None:
    """Fields in the whole body; an answer without them is an answer still."""
    if solved.body_files is None:
        return None
    started = time.perf_counter()
    try:
        found = solved.body_files(BODY_FILES_AT_MOST)
    except Exception:
        _logger.exception("job %s: no fields of the whole body", job.id)
        return None
    size = "none" if found is None else f"{len(found.zipped) / 1e6:.1f} MB, {found.points} points"
    _logger.info(
        "job %s: fields of the whole body: %s, %.1f s",
        job.id, size, time.perf_counter() - started,
    )  # fmt: skip
    return found


def _solve(job: ClaimedJob, keeper: Keeper) -> Solved:
    return RUNGS[job.rung](
        parse_design(job.design),
        Scene.from_document(job.scene),
        accuracy=job.accuracy,
        mesh=job.mesh,
        progress=keeper.report,
        cancelled=keeper.cancelled,
        found=keeper.found,
    )


def part_found(response: Response, job: ClaimedJob, stop: Stop | None) -> Response:
    """An answer that was stopped, with what is missing of it and how to have that."""
    document = response.to_document()
    if stop != "budget":
        return replace(response, advice=run_again(document))
    found, ways = (
        ("this is the path on a coarser mesh than asked for", "a coarser accuracy")
        if came_to_its_end(document)
        else (
            "this is the part of the path found by then",
            "a coarser accuracy or a lower pressure",
        )
    )
    return replace(
        response, outcome=Outcome.BUDGET_SPENT,
        advice=f"The time budget of {budget(job)} was spent; {found}. Ask for {ways}.",
    )  # fmt: skip


def _insist(write: Callable[[], T]) -> T:
    """A finished computation is worth waiting for a store that is away for a minute."""
    for pause in _INSIST_S:
        try:
            return write()
        except StoreAway:
            _logger.exception("the store does not answer, trying again in %g s", pause)
            time.sleep(pause)
    return write()
