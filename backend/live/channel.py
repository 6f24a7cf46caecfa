"""How events reach a page (websocket) or a script (server-sent events)."""

import asyncio
from collections.abc import AsyncIterator

from fastapi import WebSocket, WebSocketDisconnect

from backend.live.feed import EventFeed, Listener
from backend.live.schemas import LiveEvent

BEAT_S = 15.0


async def over_websocket(socket: WebSocket, feed: EventFeed, after: int | None) -> None:
    """Serve one socket until it closes."""
    await socket.accept()
    listener = await feed.listen(after)
    sending = asyncio.create_task(_send(socket, feed, listener))
    receiving = asyncio.create_task(_drain(socket))
    try:
        await asyncio.wait([sending, receiving], return_when=asyncio.FIRST_COMPLETED)
    finally:
        feed.leave(listener)
        sending.cancel()
        receiving.cancel()
        await asyncio.gather(sending, receiving, return_exceptions=True)


async def as_server_sent_events(feed: EventFeed, after: int | None) -> AsyncIterator[str]:
    """Events in the text/event-stream format, until the client goes."""
    listener = await feed.listen(after)
    try:
        async for event in _events(feed, listener):
            yield f"id: {event.seq}\nevent: {event.kind}\ndata: {event.model_dump_json()}\n\n"
    finally:
        feed.leave(listener)


async def _send(socket: WebSocket, feed: EventFeed, listener: Listener) -> None:
    async for event in _events(feed, listener):
        await socket.send_text(event.model_dump_json())
    await socket.close(1001)


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


async def _drain(socket: WebSocket) -> None:
    """Pages say nothing here; reading notices that they close."""
    try:
        while True:
            await socket.receive_text()
    except (WebSocketDisconnect, KeyError):
        return
