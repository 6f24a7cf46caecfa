"""Views: opened, filled, scrubbed and closed by the session they belong to."""

import secrets

import numpy as np
from fastapi import Request, Response

from backend.designs.question import read_design, read_scene
from backend.simulations.aside import Kept
from backend.simulations.schemas import PredictRequest
from backend.viewer.film import Film, Shelf, instant_film, stored_film
from backend.viewer.picture import picture
from backend.viewer.room import Room
from backend.viewer.rooms import RoomKeeper
from backend.viewer.schemas import (
    AppearanceRequest,
    Content,
    ContentRequest,
    InstantSource,
    JobSource,
    NewView,
    View,
)
from backend.viewer.stopwatch import milliseconds
from storage import NotFoundError, Store

SESSION_COOKIE = "pneustudio_session"


def open_view(rooms: RoomKeeper, body: NewView, request: Request, response: Response) -> View:
    """A room for this browser's session, which begins with its first view."""
    owner = request.cookies.get(SESSION_COOKIE, "")
    if len(owner) < 32:
        owner = secrets.token_urlsafe(32)
        response.set_cookie(
            SESSION_COOKIE, owner, httponly=True, samesite="strict", path="/",
            secure=request.url.scheme == "https",
        )  # fmt: skip
    room = rooms.open(owner, dark=body.dark)
    return View(view_id=room.view_id, url=f"/viewer/{room.view_id}/")


def question(body: ContentRequest) -> PredictRequest | None:
    """What must be asked of the helper process first, where the source is an answer of its."""
    source = body.source
    if isinstance(source, JobSource) or source.rung != "cell-rod":
        return None
    return PredictRequest(design=source.design, scene=source.scene, rung=source.rung)


def turn(rooms: RoomKeeper, view_id: str, request: Request) -> tuple[Room, int]:
    """The room, and this request's place among those that fill it."""
    room = _own(rooms, view_id, request)
    return room, room.ticket()


def show(
    turn: tuple[Room, int], shelf: Shelf, store: Store, body: ContentRequest, answered: Kept | None
) -> Content:
    """Build what was asked for and put it into the room. ``answered``: the helper's answer to
    :func:`question`."""
    room, ticket = turn
    stages: dict[str, float] = {}
    stamp = milliseconds(stages)
    if isinstance(body.source, JobSource):
        film = _job_film(store, shelf, body.source.job_id)
        rung = store.get_job(body.source.job_id).rung
        stamp("load")
    elif answered is not None:
        film, rung = _answered_film(body.source, answered), body.source.rung
        stamp("sweep")
    else:
        rung = body.source.rung
        design, scene = read_design(body.source.design), read_scene(body.source.scene)
        film = instant_film(design, scene, stamp, rung=rung)
    shown = picture(film, body.colour, undeformed=body.undeformed)
    stamp("colour")
    last = len(shown.pressures) - 1
    frame = last if body.frame is None else min(body.frame, last)
    room.show(shown.bodies, frame, ticket)
    stamp("send")
    return Content(
        rung=rung,
        take=shown.bodies.take,
        pressures_kPa=[float(f"{p / 1e3:.6g}") for p in shown.pressures],
        volumes_ml=[None if np.isnan(v) else float(f"{v * 1e6:.6g}") for v in shown.volumes],
        frame=frame,
        colour=shown.colour,
        colours=shown.colours,
        legend=shown.legend,
        vertices=shown.vertices,
        timings_ms=stages | {"total": round(sum(stages.values()), 2)},
    )


def show_frame(rooms: RoomKeeper, view_id: str, index: int, request: Request) -> None:
    """Show another frame."""
    _own(rooms, view_id, request).show_frame(index)


def note_loaded(
    rooms: RoomKeeper, view_id: str, take: str, bodies: int, page: str, request: Request
) -> None:
    """A page of the view has loaded so many bodies of a take."""
    _own(rooms, view_id, request).loaded(take, bodies, page)


def set_appearance(
    rooms: RoomKeeper, view_id: str, body: AppearanceRequest, request: Request
) -> None:
    """Background and camera."""
    room = _own(rooms, view_id, request)
    if body.dark is not None:
        room.set_dark(body.dark)
    if body.camera is not None:
        room.move_camera(body.camera)


def close_view(rooms: RoomKeeper, view_id: str, request: Request) -> None:
    """Close a room."""
    rooms.close_room(_own(rooms, view_id, request))


def _own(rooms: RoomKeeper, view_id: str, request: Request) -> Room:
    return rooms.find(view_id, request.cookies.get(SESSION_COOKIE))


def _answered_film(source: InstantSource, answered: Kept) -> Film:
    path = answered.given().result.path
    volumes = [point.cavity_volume_ml for point in path]
    design, scene = read_design(source.design), read_scene(source.scene)
    return stored_film(answered.arrays, design, scene, volumes)


def _job_film(store: Store, shelf: Shelf, job_id: str) -> Film:
    job = store.get_job(job_id)
    if not job.has_answer:
        raise NotFoundError("result of job", job_id)
    result = store.get_result(job.digest)
    sha256 = result.artifact_sha256
    if sha256 is None:
        raise NotFoundError("surface of job", job_id)
    return shelf.film(
        sha256,
        lambda: stored_film(
            store.get_artifact(sha256),
            read_design(result.document["design"]),
            read_scene(result.document["scene"]),
            [point.get("cavity_volume_ml") for point in result.document["path"]],
        ),
    )
