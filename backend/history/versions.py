"""Versions of a design: details, history with changes and results, names, forks."""

from collections.abc import Mapping, Sequence

from backend.designs.schemas import CreatedDesign
from backend.history.changes import changes
from backend.history.schemas import (
    Change,
    ForkRequest,
    ResultSummary,
    VersionDetail,
    VersionPatch,
    VersionSummary,
)
from backend.simulations.jobs import as_job
from storage import JobRow, NotFoundError, Store, VersionRow

_MOST_JOBS = 1000


def detail(store: Store, version_id: str) -> VersionDetail:
    """A version with its design, scene and jobs, newest job first."""
    version = store.get_version(version_id)
    design = store.get_design(version.design_id)
    jobs = store.list_jobs(version_id=version_id, limit=_MOST_JOBS)
    return VersionDetail(
        id=version.id, number=version.number, parent_id=version.parent_id,
        design_id=design.id, design_name=design.name, archived=design.archived,
        label=version.label, author=version.author, created_at=version.created_at,
        note=version.note, design=version.document, scene=version.scene,
        jobs=[as_job(job) for job in jobs],
        answered_by=[
            as_job(job)
            for job in _same_content(store, version)
            if job.version_id != version_id
        ],
    )  # fmt: skip


def history(store: Store, design_id: str) -> list[VersionSummary]:
    """Every version, newest first: what changed against its parent, and what it answered."""
    rows = {row.id: row for row in store.list_versions(design_id)}
    jobs = store.list_jobs(design_id=design_id, states=["done"], limit=_MOST_JOBS)
    return [
        VersionSummary(
            id=row.id, number=row.number, parent_id=row.parent_id, label=row.label,
            author=row.author, created_at=row.created_at, note=row.note,
            changes=_changes(row, rows),
            results=_results(store, row, [job for job in jobs if job.version_id == row.id]),
        )
        for row in reversed(rows.values())
    ]  # fmt: skip


def name(store: Store, version_id: str, body: VersionPatch) -> VersionDetail:
    """Label a version, or take the label away."""
    store.name_version(version_id, body.label)
    return detail(store, version_id)


def fork(store: Store, version_id: str, body: ForkRequest, author: str) -> CreatedDesign:
    """A new design that starts from a version."""
    design, version = store.fork(version_id, body.name, author)
    return CreatedDesign(design_id=design.id, version=detail(store, version.id))


def _changes(row: VersionRow, rows: Mapping[str, VersionRow]) -> list[Change]:
    parent = rows.get(row.parent_id or "")
    if parent is None:
        return []
    return changes(parent, row)


def _same_content(store: Store, version: VersionRow) -> list[JobRow]:
    """Done jobs about the same design in the same scene, whichever version asked; newest first."""
    content = (version.design_digest, version.scene_digest)
    return store.list_jobs(states=["done"], content=content, limit=_MOST_JOBS)


def _results(store: Store, version: VersionRow, own: Sequence[JobRow]) -> list[ResultSummary]:
    """Answers of a version, newest first. A question asked again has the same answer: it stands
    once, under the first job that asked."""
    by_question = {job.digest: job for job in [*_same_content(store, version), *own]}
    jobs = sorted(by_question.values(), key=lambda job: job.created_at, reverse=True)
    return [_result(store, job) for job in jobs]


def _result(store: Store, job: JobRow) -> ResultSummary:
    """Last point of the path that a done job found."""
    try:
        document = store.get_result(job.digest).document
    except NotFoundError:
        document = {}
    path = document.get("path") or [{}]
    last = path[-1]
    return ResultSummary(
        job_id=job.id, rung=job.rung, accuracy=job.accuracy, mesh=job.mesh,
        outcome=job.outcome or "", plate_force_N=last.get("plate_force_N"),
        pressure_kPa=last.get("pressure_kPa"), bending_angle_deg=last.get("bending_angle_deg"),
        tip_mm=last.get("tip_mm"), error_estimate_percent=document.get("error_estimate_percent"),
        wall_s=document.get("wall_s"),
    )  # fmt: skip
