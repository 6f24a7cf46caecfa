"""One poller of the event table feeds every open page and script."""

import asyncio
import logging
from dataclasses import dataclass, field

from backend.live.schemas import LiveEvent
from backend.simulations.jobs import as_job
from storage import EventRow, Store

POLL_S = 0.1
_BATCH = 1000
_REPLAY = 5000
_LARGEST_BACKLOG = 10_000

log = logging.getLogger(__name__)


@dataclass(eq=False)
class Listener:
    """A queue of events for one socket or stream."""

    queue: asyncio.Queue[LiveEvent | None] = field(
        default_factory=lambda: asyncio.Queue(_LARGEST_BACKLOG)
    )

    def put(self, event: LiveEvent) -> bool:
        """False when this listener does not keep up."""
        try:
            self.queue.put_nowait(event)
        except asyncio.QueueFull:
            return False
        return True


class EventFeed:
    """Events after ``seq``, for as many listeners as there are; one query each 0.1 s for all."""

    def __init__(self, store: Store) -> None:
        self._store = store
        self._listeners: set[Listener] = set()
        self._task: asyncio.Task[None] | None = None
        self.seq = 0

    async def start(self) -> None:
        """Begin to poll, from the newest event on."""
        self.seq = await asyncio.to_thread(self._store.last_event_seq)
        self._task = asyncio.create_task(self._poll())

    async def stop(self) -> None:
        """End the poll, and tell every listener."""
        if self._task is not None:
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)
        for listener in self._listeners:
            self._end(listener)

    async def listen(self, after: int | None) -> Listener:
        """A new listener. Its queue first holds `hello`, then what happened since ``after``."""
        listener = Listener()
        # joined before the replay, so that nothing falls between replay and poll; what comes
        # twice is harmless, for every event carries the present state
        self._listeners.add(listener)
        start = self.seq if after is None else min(after, self.seq)
        listener.put(LiveEvent(seq=start, kind="hello"))
        if start < self.seq:
            rows = await asyncio.to_thread(self._store.events_after, start, limit=_REPLAY)
            for event in await asyncio.to_thread(self._read, rows):
                listener.put(event)
        return listener

    def leave(self, listener: Listener) -> None:
        """A listener is gone."""
        self._listeners.discard(listener)

    async def _poll(self) -> None:
        while True:
            await asyncio.sleep(POLL_S)
            try:
                rows = await asyncio.to_thread(self._store.events_after, self.seq, limit=_BATCH)
                if not rows:
                    continue
                events = await asyncio.to_thread(self._read, rows) if self._listeners else []
            except Exception:  # a database that is away must not end the feed
                log.exception("reading events failed; trying again")
                await asyncio.sleep(1.0)
                continue
            self.seq = rows[-1].seq
            for event in events:
                self._tell_all(event)

    def _tell_all(self, event: LiveEvent) -> None:
        for listener in [one for one in self._listeners if not one.put(event)]:
            self.leave(listener)
            self._end(listener)

    def _end(self, listener: Listener) -> None:
        while listener.queue.full():
            listener.queue.get_nowait()
        listener.queue.put_nowait(None)

    def _read(self, rows: list[EventRow]) -> list[LiveEvent]:
        """Of several events about one job only the last: each carries the job as it is now."""
        last = {(row.kind, row.subject): row for row in rows}
        jobs = self._store.get_jobs([row.subject for row in last.values() if row.kind == "job"])
        events: list[LiveEvent] = []
        for row in sorted(last.values(), key=lambda row: row.seq):
            if row.kind == "history":
                events.append(LiveEvent(seq=row.seq, kind="history", design_id=row.subject))
            elif row.subject in jobs:
                events.append(LiveEvent(seq=row.seq, kind="job", job=as_job(jobs[row.subject])))
        return events
