"""Files to download."""

from fastapi import APIRouter, Request, Response

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


@router.get("/versions/{version_id}/files")
def list_files(version_id: str, store: Storage) -> list[FileInfo]:
    """Files a version offers, and why one is not available."""
    return service.available(store, version_id)


@router.get("/versions/{version_id}/files/{what}", response_class=Response, responses={**BINARY})
def get_file(version_id: str, what: FileKind, request: Request, store: Storage) -> Response:
    """One file of a version. Several sheets come as one zip."""
    return service.of_version(store, version_id, what, request.headers.get("if-none-match"))


@router.post("/export", response_class=Response, responses={**BINARY})
def export_design(body: ExportRequest) -> Response:
    """A file of a design that is not saved."""
    return service.of_design(body)
