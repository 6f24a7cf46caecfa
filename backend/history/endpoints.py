"""Versions: read, name, fork, compare."""

from fastapi import APIRouter, Query

from backend.designs.schemas import CreatedDesign
from backend.history import comparison, versions
from backend.history.schemas import Comparison, ForkRequest, VersionDetail, VersionPatch
from backend.wiring import Author, Storage

router = APIRouter(tags=["history"])


@router.get("/versions/{version_id}")
def get_version(version_id: str, store: Storage) -> VersionDetail:
    """A version with its design, scene and jobs."""
    return versions.detail(store, version_id)


@router.patch("/versions/{version_id}")
def patch_version(version_id: str, body: VersionPatch, store: Storage) -> VersionDetail:
    """Give a version a name, or take it away."""
    return versions.name(store, version_id, body)


@router.post("/versions/{version_id}/fork", status_code=201)
def fork_version(
    version_id: str, body: ForkRequest, store: Storage, author: Author
) -> CreatedDesign:
    """Start a new design from a version."""
    return versions.fork(store, version_id, body, author)


@router.get("/compare")
def compare_versions(
    store: Storage,
    left: str = Query(description="Version"),
    right: str = Query(description="Version"),
) -> Comparison:
    """Two versions side by side: parameters and answers."""
    return comparison.compare(store, left, right)
