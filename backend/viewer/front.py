"""The viewer's door: viser's page under our own policy, and its websocket through our own checks.

viser follows `?websocket=` and `?playbackPath=` anywhere and runs scripts from messages; the policy
of the page lets none of it leave this origin.
"""

from functools import cache

import anyio
import websockets
from fastapi import APIRouter, Request, WebSocket
from fastapi.responses import HTMLResponse, RedirectResponse, Response
from starlette.websockets import WebSocketDisconnect, WebSocketState

from backend.viewer.page_scripts import HIDING, LOADED, QUIET
from backend.viewer.rooms import RoomKeeper
from backend.viewer.schemas import LoadedBodies
from backend.viewer.service import SESSION_COOKIE, note_loaded
from backend.viewer.viser_door import KEY_HEADER, SUBPROTOCOL, client_page
from storage import NotFoundError

POLICY = (
    "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob: data:; "
    "worker-src blob: data:; style-src 'unsafe-inline'; img-src data: blob:; font-src data:; "
    "connect-src 'self' data: blob:; frame-ancestors 'self'; base-uri 'none'; form-action 'none'"
)
HEADERS = {
    "Content-Security-Policy": POLICY,
    "Cache-Control": "no-store",
    "X-Frame-Options": "SAMEORIGIN",
}


def router() -> APIRouter:
    """/viewer/{view_id}/ as page and as websocket; the slash may be missing, as viser's client
    leaves it out."""
    front = APIRouter(include_in_schema=False)

    @front.get("/viewer/{view_id}/")
    def page(view_id: str, request: Request) -> Response:
        rooms: RoomKeeper = request.app.state.rooms
        rooms.find(view_id, request.cookies.get(SESSION_COOKIE))
        if request.query_params.keys() & {"websocket", "playbackPath"}:
            return RedirectResponse(request.url.path, headers=HEADERS)
        return HTMLResponse(_page(), headers=HEADERS)

    @front.post("/viewer/{view_id}/loaded", status_code=204)
    def loaded(view_id: str, body: LoadedBodies, request: Request) -> None:
        note_loaded(request.app.state.rooms, view_id, body.take, body.bodies, body.page, request)

    @front.get("/viewer/{view_id}")
    def page_without_slash(view_id: str) -> Response:
        return RedirectResponse(f"/viewer/{view_id}/")

    front.add_api_websocket_route("/viewer/{view_id}", _socket)
    front.add_api_websocket_route("/viewer/{view_id}/", _socket)
    return front


@cache
def _page() -> str:
    page = client_page().replace("<title>Viser</title>", "<title>Pneustudio viewer</title>")
    head, found, rest = page.partition("</head>")
    if not found:
        raise RuntimeError("viser's page has no head")
    return f"{head}{HIDING}{QUIET}{LOADED}{found}{rest}"


async def _socket(socket: WebSocket, view_id: str) -> None:
    """Join a page of the room's owner to the room. The Origin was checked by the guard."""
    rooms: RoomKeeper = socket.app.state.rooms
    try:
        room = rooms.find(view_id, socket.cookies.get(SESSION_COOKIE))
    except NotFoundError:
        await socket.close(1008)
        return
    if SUBPROTOCOL not in socket.scope.get("subprotocols", []):
        await socket.close(1002)
        return
    try:
        upstream = await websockets.connect(
            room.guarded.address,
            subprotocols=[websockets.Subprotocol(SUBPROTOCOL)],
            additional_headers={KEY_HEADER: room.guarded.key},
            max_size=None,
            compression=None,
            proxy=None,
        )
    except (OSError, websockets.WebSocketException):
        await socket.close(1011)
        return
    async with upstream:
        await socket.accept(subprotocol=SUBPROTOCOL)
        async with anyio.create_task_group() as group:
            group.start_soon(_to_page, upstream, socket, group.cancel_scope)
            group.start_soon(_to_room, socket, upstream, group.cancel_scope)
    if socket.client_state is WebSocketState.CONNECTED:
        await socket.close(1001)


async def _to_page(
    upstream: websockets.ClientConnection, socket: WebSocket, scope: anyio.CancelScope
) -> None:
    try:
        async for message in upstream:
            if isinstance(message, bytes):
                await socket.send_bytes(message)
    except (WebSocketDisconnect, RuntimeError, websockets.ConnectionClosed):
        pass  # one side is gone; the other is closed below
    finally:
        scope.cancel()


async def _to_room(
    socket: WebSocket, upstream: websockets.ClientConnection, scope: anyio.CancelScope
) -> None:
    try:
        while (message := await socket.receive())["type"] == "websocket.receive":
            if message.get("bytes") is not None:
                await upstream.send(message["bytes"])
    except (RuntimeError, websockets.ConnectionClosed):
        pass  # one side is gone; the other is closed below
    finally:
        scope.cancel()
