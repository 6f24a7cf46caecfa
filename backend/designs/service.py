"""Checking designs, and keeping them."""

from actuators.design import Design, ObliqueDesign, SlabDesign
from actuators.geometry.drawing import drawing
from actuators.geometry.volumes import exact_volumes, masses
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
from backend.history import versions
from backend.history.schemas import VersionDetail
from storage import DesignRow, Store

# properties of designs worth showing, in this order: (name, label, unit, units per SI unit)
_DERIVED = (
    ("height", "Total thickness", "mm", 1e3),
    ("pitch", "Chamber pitch", "mm", 1e3),
    ("chamber_length", "Chamber length", "mm", 1e3),
    ("wall_length", "Wall between chambers", "mm", 1e3),
    ("chamber_height", "Chamber height", "mm", 1e3),
    ("end_length", "End piece", "mm", 1e3),
)


def check(body: CheckRequest) -> DesignCheck:
    """What follows from a design that can be built."""
    design = read_design(body.design)
    return DesignCheck(
        design=design.to_document(),
        digest=design.digest,
        derived=derived(design),
        assumptions=list(design.assumptions()),
        drawing=Drawing.model_validate(drawing(design)),
    )


def derived(design: Design) -> list[DerivedValue]:
    """Lengths, volumes and masses that follow from the parameters."""
    own = {p.name for p in design.parameters()}
    values = [
        _value(label, getattr(design, name) * per_si, unit)
        for name, label, unit, per_si in _DERIVED
        if name not in own and hasattr(design, name)
    ]
    if isinstance(design, SlabDesign):
        values.append(_value("Shortest chamber arm", float(design.arm_spans().min()) * 1e3, "mm"))
    if isinstance(design, ObliqueDesign):
        values.append(_value("Side wall", design.side_wall * 1e3, "mm"))
    volumes = exact_volumes(design)
    values.append(_value("Cavity volume", volumes.cavity * 1e6, "ml"))
    values.append(_value("Rubber volume", volumes.rubber * 1e6, "ml"))
    if isinstance(design, SlabDesign | ObliqueDesign):
        bottom, top = masses(design)
        values.append(_value("Mass of bottom layer", bottom * 1e3, "g"))
        values.append(_value("Mass of top layer", top * 1e3, "g"))
    return values


def _value(label: str, value: float, unit: str) -> DerivedValue:
    return DerivedValue(label=label, value=float(f"{value:.6g}"), unit=unit)


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
