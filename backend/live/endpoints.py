"""The live channel: one websocket per tab, server-sent events for scripts."""

from fastapi import APIRouter, Query, WebSocket
from fastapi.responses import StreamingResponse

from backend.live import channel
from backend.live.schemas import LiveEvent
from backend.wiring import Feed

router = APIRouter(tags=["live"])

STREAM = {
    200: {
        "model": LiveEvent,
        "description": "Server-sent events: `id` is the sequence number, `event` the kind, `data` "
        "one LiveEvent as JSON. The websocket /api/live sends the same LiveEvents as text.",
    }
}


@router.websocket("/live")
async def live(socket: WebSocket, after: int | None = None) -> None:
    """LiveEvents as JSON text; ?after= continues where an earlier connection ended."""
    await channel.over_websocket(socket, socket.app.state.feed, after)


@router.get("/events", response_class=StreamingResponse, responses={**STREAM})
def events(
    feed: Feed,
    after: int | None = Query(default=None, ge=0, description="Sequence number already seen"),
) -> StreamingResponse:
    """The same as a stream of server-sent events, for scripts."""
    return StreamingResponse(
        channel.as_server_sent_events(feed, after),
        media_type="text/event-stream",
        headers={"Cache-Control": "no-store", "X-Accel-Buffering": "no"},
    )
