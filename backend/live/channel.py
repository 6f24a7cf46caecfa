"""How events reach a page (websocket) or a script (server-sent events)."""

import asyncio
from collections.abc import AsyncIterator

import anyio
from fastapi import WebSocket, WebSocketDisconnect

from backend.live.feed import EventFeed, Listener
from backend.live.schemas import LiveEvent

BEAT_S = 15.0


async def over_websocket(socket: WebSocket, feed: EventFeed, after: int | None) -> None:
    """Serve one socket until it closes."""
    await socket.accept()
    listener = await feed.listen(after)
    try:
        async with anyio.create_task_group() as group:
            group.start_soon(_drain, socket, group.cancel_scope)
            await _send(socket, feed, listener)
            group.cancel_scope.cancel()
    finally:
        feed.leave(listener)


async def as_server_sent_events(feed: EventFeed, after: int | None) -> AsyncIterator[str]:
    """Events in the text/event-stream format, until the client goes."""
    listener = await feed.listen(after)
    try:
        async for event in _events(feed, listener):
            yield f"id: {event.seq}\nevent: {event.kind}\ndata: {event.model_dump_json()}\n\n"
    finally:
        feed.leave(listener)


async def _send(socket: WebSocket, feed: EventFeed, listener: Listener) -> None:
    try:
        async for event in _events(feed, listener):
            await socket.send_text(event.model_dump_json())
        await socket.close(1001)
    except (WebSocketDisconnect, RuntimeError):
        return  # the page closed while an event was on its way


async def _events(feed: EventFeed, listener: Listener) -> AsyncIterator[LiveEvent]:
    while True:
        try:
            event = await asyncio.wait_for(listener.queue.get(), BEAT_S)
        except TimeoutError:
            yield LiveEvent(seq=feed.seq, kind="beat")
            continue
        if event is None:
            return
        yield event


async def _drain(socket: WebSocket, scope: anyio.CancelScope) -> None:
    """Pages say nothing here; reading notices that they close."""
    try:
        while (await socket.receive())["type"] != "websocket.disconnect":
            continue
    except RuntimeError:
        pass  # closed from our side meanwhile
    finally:
        scope.cancel()
