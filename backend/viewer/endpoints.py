"""Views of the 3D viewer."""

from fastapi import APIRouter, Request, Response
from fastapi.concurrency import run_in_threadpool

from backend.viewer import service
from backend.viewer.schemas import (
    AppearanceRequest,
    Content,
    ContentRequest,
    FrameRequest,
    NewView,
    View,
)
from backend.wiring import Helper, Rooms, Storage

router = APIRouter(tags=["viewer"])


@router.post("/views", status_code=201)
def create_view(body: NewView, request: Request, response: Response, rooms: Rooms) -> View:
    """Open a view; show its `url` in an iframe. It belongs to this browser's session."""
    return service.open_view(rooms, body, request, response)


@router.put("/views/{view_id}/content")
async def put_content(
    view_id: str,
    body: ContentRequest,
    request: Request,
    rooms: Rooms,
    store: Storage,
    helper: Helper,
) -> Content:
    """Choose what the view shows. `cell-rod` is answered as by `POST /api/predict`."""
    turn = await run_in_threadpool(service.turn, rooms, view_id, request)
    question = service.question(body)
    found = None if question is None else await helper.answer(question, request.is_disconnected)
    return await run_in_threadpool(service.show, turn, rooms.shelf, store, body, found)


@router.put("/views/{view_id}/frame", status_code=204)
def put_frame(view_id: str, body: FrameRequest, request: Request, rooms: Rooms) -> None:
    """Show another frame of the content."""
    service.show_frame(rooms, view_id, body.index, request)


@router.put("/views/{view_id}/appearance", status_code=204)
def put_appearance(view_id: str, body: AppearanceRequest, request: Request, rooms: Rooms) -> None:
    """Light or dark; move the camera to a named place."""
    service.set_appearance(rooms, view_id, body, request)


@router.delete("/views/{view_id}", status_code=204)
def delete_view(view_id: str, request: Request, rooms: Rooms) -> None:
    """Close a view. One nobody looks at closes by itself after a while."""
    service.close_view(rooms, view_id, request)
