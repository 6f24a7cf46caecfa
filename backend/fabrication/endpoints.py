"""Files to download."""

from typing import Annotated

from fastapi import APIRouter, Query, Request, Response

from backend.fabrication import service
from backend.fabrication.schemas import ExportRequest, FileInfo, FileKind
from backend.wiring import Storage

router = APIRouter(tags=["fabrication"])

BINARY = {
    200: {
        "description": "The file",
        "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}},
    }
}


OfJob = Annotated[
    str | None,
    Query(
        max_length=100,
        description="Job whose result is meant, of this version or of another that holds the same "
        "design in the same scene; the most accurate result when left out",
    ),
]


@router.get("/versions/{version_id}/files")
def list_files(version_id: str, store: Storage, job_id: OfJob = None) -> list[FileInfo]:
    """Files a version offers, and why one is not available."""
    return service.available(store, version_id, job_id)


@router.get("/versions/{version_id}/files/{what}", response_class=Response, responses={**BINARY})
def get_file(
    version_id: str, what: FileKind, request: Request, store: Storage, job_id: OfJob = None
) -> Response:
    """One file of a version. Several sheets, and fields at several pressures, come as one zip."""
    known_tag = request.headers.get("if-none-match")
    return service.of_version(store, version_id, what, job_id, known_tag)


@router.post("/export", response_class=Response, responses={**BINARY})
def export_design(body: ExportRequest) -> Response:
    """A file of a design that is not saved."""
    return service.of_design(body)
