"""Families, presets, checking, and designs kept under a name."""

from fastapi import APIRouter, Query

from backend.designs import catalogue, service
from backend.designs.schemas import (
    CheckRequest,
    CreatedDesign,
    DesignCheck,
    DesignDetail,
    DesignPatch,
    DesignSummary,
    FamilyInfo,
    NewDesign,
    NewVersion,
    PresetInfo,
)
from backend.history.schemas import VersionDetail
from backend.wiring import Author, Storage

router = APIRouter(tags=["designs"])


@router.get("/families")
def list_families() -> list[FamilyInfo]:
    """Families and every parameter with unit, limits and source."""
    return catalogue.families()


@router.get("/presets")
def list_presets() -> list[PresetInfo]:
    """The actuators of the source papers."""
    return catalogue.presets()


@router.post("/designs/check")
def check_design(body: CheckRequest) -> DesignCheck:
    """Whether a design can be built; what follows from it, and its drawing."""
    return service.check(body)


@router.get("/designs")
def list_designs(
    store: Storage,
    search: str = Query(default="", max_length=200, description="Part of a name"),
    archived: bool = Query(default=False, description="List archived designs instead"),
) -> list[DesignSummary]:
    """Designs kept, the latest changed first."""
    return service.summaries(store, search=search, archived=archived)


@router.post("/designs", status_code=201)
def create_design(body: NewDesign, store: Storage, author: Author) -> CreatedDesign:
    """Keep a design under a name."""
    return service.create(store, body, author)


@router.get("/designs/{design_id}")
def get_design(design_id: str, store: Storage) -> DesignDetail:
    """A design with every version, what changed in it and what it answered."""
    return service.detail(store, design_id)


@router.patch("/designs/{design_id}")
def patch_design(design_id: str, body: DesignPatch, store: Storage) -> DesignDetail:
    """Rename or archive a design."""
    return service.patch(store, design_id, body)


@router.post("/designs/{design_id}/versions", status_code=201)
def add_version(design_id: str, body: NewVersion, store: Storage, author: Author) -> VersionDetail:
    """Save a further version."""
    return service.add_version(store, design_id, body, author)
