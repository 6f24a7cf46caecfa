"""Checking designs, and keeping them."""

from actuators.geometry.derived import derived
from actuators.geometry.drawing import drawing
from backend.designs.question import read_design, read_scene
from backend.designs.schemas import (
    CheckRequest,
    CreatedDesign,
    DerivedValue,
    DesignCheck,
    DesignDetail,
    DesignPatch,
    DesignSummary,
    Drawing,
    NewDesign,
    NewVersion,
)
from backend.fabrication.service import unavailable
from backend.history import versions
from backend.history.schemas import VersionDetail
from storage import DesignRow, Store


def check(body: CheckRequest) -> DesignCheck:
    """What follows from a design that can be built."""
    design = read_design(body.design)
    return DesignCheck(
        design=design.to_document(),
        digest=design.digest,
        derived=[
            DerivedValue(label=each.label, value=each.value, unit=each.unit)
            for each in derived(design)
        ],
        assumptions=list(design.assumptions()),
        drawing=Drawing.model_validate(drawing(design)),
        unavailable_files=unavailable(design),
    )


def summaries(store: Store, *, search: str, archived: bool) -> list[DesignSummary]:
    """Designs kept, the latest changed first."""
    return [_summary(row) for row in store.list_designs(search, archived=archived)]


def create(store: Store, body: NewDesign, author: str) -> CreatedDesign:
    """Keep a design that can be built."""
    design, scene = read_design(body.design), read_scene(body.scene)
    row, version = store.create_design(
        body.name, author, design.to_document(), scene.to_document(), body.note
    )
    return CreatedDesign(design_id=row.id, version=versions.detail(store, version.id))


def detail(store: Store, design_id: str) -> DesignDetail:
    """A design with its history, newest version first."""
    row = store.get_design(design_id)
    return DesignDetail(
        id=row.id,
        name=row.name,
        author=row.author,
        archived=row.archived,
        created_at=row.created_at,
        versions=versions.history(store, design_id),
    )


def patch(store: Store, design_id: str, body: DesignPatch) -> DesignDetail:
    """Rename, archive or restore; what the body leaves out stays."""
    store.get_design(design_id)
    if body.name is not None:
        store.rename(design_id, body.name)
    if body.archived is not None:
        store.archive(design_id, archived=body.archived)
    return detail(store, design_id)


def add_version(store: Store, design_id: str, body: NewVersion, author: str) -> VersionDetail:
    """Save a further version; content equal to its parent's gives the one there is."""
    design, scene = read_design(body.design), read_scene(body.scene)
    version = store.add_version(
        design_id, body.parent_version_id, author, design.to_document(), scene.to_document(),
        body.note,
    )  # fmt: skip
    return versions.detail(store, version.id)


def _summary(row: DesignRow) -> DesignSummary:
    return DesignSummary(
        id=row.id, name=row.name, family=row.family, author=row.author, archived=row.archived,
        created_at=row.created_at, updated_at=row.updated_at, version_count=row.version_count,
        latest_version_id=row.latest_version_id,
    )  # fmt: skip
