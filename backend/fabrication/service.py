"""Files: what there is, under which name, and the bytes."""

import csv
import hashlib
import io
import json
import re
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any
from urllib.parse import quote

from fastapi import Response

from actuators.design import Design, parse_design
from actuators.errors import InputError, QuestionError
from actuators.export import ModelQuestion, write
from actuators.export import available as family_files
from actuators.mechanics.scene import Scene
from backend.designs.question import read_design, read_scene
from backend.fabrication.schemas import (
    ExportKind,
    ExportRequest,
    FileInfo,
    FileKind,
    ResultKind,
)
from storage import NotFoundError, ResultRow, Store, VersionRow
from storage.response_arrays import unpack


@dataclass(frozen=True)
class _Kind:
    title: str
    suffix: str
    media_type: str


_ZIP = "application/zip"
_KINDS: Mapping[FileKind, _Kind] = {
    "mould-svg": _Kind("Mould, laser-cut layers", "svg", "image/svg+xml"),
    "actuator-stl": _Kind("Actuator, surface in mm", "stl", "model/stl"),
    "inp": _Kind("Finite-element model, deck for CalculiX and Abaqus", "inp", "text/plain"),
    "result-body": _Kind("Finite-element result, whole-body fields for ParaView", "zip", _ZIP),
    "result-vtu": _Kind("Finite-element result, surface fields for ParaView", "zip", _ZIP),
    "result-json": _Kind("Finite-element result, complete", "json", "application/json"),
    "result-csv": _Kind("Finite-element result, path", "csv", "text/csv; charset=utf-8"),
}
# two zips of one version must not have one name
_PART: Mapping[FileKind, str] = {"result-body": "-whole-body", "result-vtu": "-surface"}


def available(store: Store, version_id: str, job_id: str | None) -> list[FileInfo]:
    """Every kind of file, and why one cannot be had. ``job_id``: whose result is meant."""
    version = store.get_version(version_id)
    stem, result = _stem(store, version), _result(store, version, job_id)
    return [_info(version, stem, what, result) for what in _KINDS]


def of_version(
    store: Store, version_id: str, what: FileKind, job_id: str | None, known_tag: str | None
) -> Response:
    """One file. A version never changes, so that a browser asks again only for its tag."""
    version = store.get_version(version_id)
    result = _result(store, version, job_id)
    reason = _reason(version, what, result)
    if reason:
        raise QuestionError(reason, field="what", value=what, mend="Choose another file.")
    stem = _stem(store, version)
    if what == "mould-svg" or what == "actuator-stl" or what == "inp":
        design, scene = read_design(version.document), read_scene(version.scene)
        name, media_type, body = _exported(design, scene, what, stem, result)
    else:
        name = f"{stem}{_PART.get(what, '')}.{_KINDS[what].suffix}"
        media_type = _KINDS[what].media_type
        body = _of_result(store, result, what)
    return _download(name, media_type, body, known_tag)


def of_design(body: ExportRequest) -> Response:
    """A file of a design that is not saved."""
    design = read_design(body.design)
    scene = None if body.scene is None else read_scene(body.scene)
    name, media_type, data = _exported(design, scene, body.what, _slug(body.name))
    return _download(name, media_type, data, None)


def _info(version: VersionRow, stem: str, what: FileKind, result: ResultRow | None) -> FileInfo:
    kind, reason = _KINDS[what], _reason(version, what, result)
    return FileInfo(
        what=what, title=kind.title, file_name=f"{stem}{_PART.get(what, '')}.{kind.suffix}",
        media_type=kind.media_type, url=f"/api/versions/{version.id}/files/{what}",
        available=not reason, reason=reason or None,
    )  # fmt: skip


def _reason(version: VersionRow, what: FileKind, result: ResultRow | None) -> str:
    if what.startswith("result-"):
        if result is None:
            return "There is no finite-element result of this version yet."
        if what == "result-body" and result.body_files_sha256 is None:
            return (
                "The fields in the whole body are not kept with this result: it is an old one, or "
                "they are too large. `pneustudio export --what vtu` solves again and writes them."
            )
        return ""
    try:
        design, scene = read_design(version.document), read_scene(version.scene)
        if what == "inp":
            _made(design, scene, what, result)
    except InputError as error:
        return str(error)
    return unavailable(design).get(what, "")


def unavailable(design: Design) -> dict[str, str]:
    """Files that a family does not have, by kind, each with the reason."""
    reasons: dict[str, str] = {}
    if "mould-svg" not in family_files(design):
        try:
            write(design, "mould-svg")
        except QuestionError as error:
            reasons["mould-svg"] = str(error)
    return reasons


def _result(store: Store, version: VersionRow, job_id: str | None) -> ResultRow | None:
    """Of one job, which must have answered this very question; else the most accurate."""
    if job_id is None:
        return store.best_result(version.document, version.scene, "fe")
    job = store.get_job(job_id)
    asked = (job.rung, job.design_digest, job.scene_digest)
    if not job.has_answer or asked != ("fe", version.design_digest, version.scene_digest):
        raise NotFoundError("result of job", job_id)
    return store.get_result(job.digest)


def _of_result(store: Store, result: ResultRow | None, what: ResultKind) -> bytes:
    if result is None:
        raise NotFoundError("result", what)
    if what == "result-json":
        return _json(result.document)
    if what == "result-csv":
        return _csv(result.document)
    if what == "result-body":
        return store.get_artifact(result.body_files_sha256 or "")
    if result.artifact_sha256 is None:
        raise NotFoundError("surface of result", result.digest)
    arrays = unpack(store.get_artifact(result.artifact_sha256))
    if arrays.surface is None:
        raise NotFoundError("surface of result", result.digest)
    # loads the solver's kernels: only when asked for
    from actuators.export.vtu import surface_series

    design = read_design(result.document["design"])
    title = f"{design.title}, design {result.design_digest[:12]}, scene {result.scene_digest[:12]}"
    return _zipped(surface_series(arrays.surface, list(arrays.pressures), title))


@lru_cache(maxsize=8)
def _files(design: str, scene: str, what: ExportKind, solved: str) -> dict[str, bytes]:
    loads = None
    if scene != "null":
        loads = ModelQuestion(read_scene(json.loads(scene)), solved=json.loads(solved))
    return write(parse_design(json.loads(design)), what, loads)


def _made(
    design: Design, scene: Scene | None, what: ExportKind, result: ResultRow | None = None
) -> dict[str, bytes]:
    """Files by name; only a model depends on the scene, and only one for a volume on a result."""
    loads = scene if what == "inp" else None
    solved = None
    if loads is not None and loads.volume_to is not None and result is not None:
        solved = result.document
    asked = None if loads is None else loads.to_document()
    return _files(json.dumps(design.to_document()), json.dumps(asked), what, json.dumps(solved))


def _exported(
    design: Design, scene: Scene | None, what: ExportKind, stem: str,
    result: ResultRow | None = None,
) -> tuple[str, str, bytes]:  # fmt: skip
    """File name, media type and bytes; several files come as one zip."""
    files = _made(design, scene, what, result)
    if len(files) == 1:
        return f"{stem}.{_KINDS[what].suffix}", _KINDS[what].media_type, next(iter(files.values()))
    return f"{stem}-{what}.zip", _ZIP, _zipped(files)


def _zipped(files: Mapping[str, bytes]) -> bytes:
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            # a fixed date: equal designs give equal files
            archive.writestr(
                zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED
            )
    return target.getvalue()


def _json(document: Mapping[str, Any]) -> bytes:
    return (json.dumps(document, indent=1, allow_nan=False) + "\n").encode()


def _csv(document: Mapping[str, Any]) -> bytes:
    """The path, one line per pressure; vectors in columns of their own."""
    rows = [_flat(point) for point in document["path"]]
    columns = list(dict.fromkeys(name for row in rows for name in row))
    target = io.StringIO()
    lines = csv.DictWriter(target, columns, lineterminator="\n")
    lines.writeheader()
    lines.writerows(rows)
    return target.getvalue().encode()


def _flat(point: Mapping[str, Any]) -> dict[str, Any]:
    row: dict[str, Any] = {}
    for name, value in point.items():
        if isinstance(value, list):
            quantity, _, unit = name.rpartition("_")
            row |= {f"{quantity}_x{axis}_{unit}": v for axis, v in enumerate(value, start=1)}
        else:
            row[name] = value
    return row


def _download(name: str, media_type: str, body: bytes, known_tag: str | None) -> Response:
    tag = f'"{hashlib.sha256(body).hexdigest()[:32]}"'
    headers = {
        "ETag": tag,
        "Cache-Control": "private, no-cache",
        "Content-Disposition": f"attachment; filename=\"{name}\"; filename*=UTF-8''{quote(name)}",
    }
    if known_tag == tag:
        return Response(status_code=304, headers=headers)
    return Response(body, media_type=media_type, headers=headers)


def _stem(store: Store, version: VersionRow) -> str:
    return f"{_slug(store.get_design(version.design_id).name)}-v{version.number}"


def _slug(name: str) -> str:
    """Letters, digits and dashes: a name for every file system."""
    return re.sub(r"[^A-Za-z0-9]+", "-", name).strip("-")[:80].lower() or "actuator"
