"""All open rooms: found by their view's identifier and owner, closed when nobody looks."""

import asyncio
import logging
import secrets
import threading
import time

from backend.problems import Busy
from backend.viewer.film import Shelf
from backend.viewer.room import Room
from storage import NotFoundError

MOST_ROOMS = 32
IDLE_S = 120.0
"""A room without a connected page lives this long after its last use."""
SWEEP_S = 5.0

log = logging.getLogger(__name__)


class RoomKeeper:
    """Opens, finds and closes rooms. Methods block; call them in a thread from async code."""

    def __init__(self, *, most: int = MOST_ROOMS, idle_s: float = IDLE_S) -> None:
        self.shelf = Shelf()
        self._rooms: dict[str, Room] = {}
        self._lock = threading.Lock()
        self._most = most
        self._idle_s = idle_s

    def open(self, owner: str, *, dark: bool) -> Room:
        """A new room; the one longest unused makes way when there are too many."""
        with self._lock:
            if len(self._rooms) >= self._most:
                self._make_way()
            room = Room(secrets.token_urlsafe(18), owner, dark)
            self._rooms[room.view_id] = room
        return room

    def find(self, view_id: str, owner: str | None) -> Room:
        """The owner's room; for anybody else there is none."""
        room = self._rooms.get(view_id)
        if room is None or owner is None or not secrets.compare_digest(room.owner, owner):
            raise NotFoundError("view", view_id)
        room.used_at = time.monotonic()
        return room

    def close_room(self, room: Room) -> None:
        """End one room."""
        with self._lock:
            self._rooms.pop(room.view_id, None)
        room.stop()

    def sweep(self) -> int:
        """Close rooms that nobody looks at; returns how many."""
        now = time.monotonic()
        for room in list(self._rooms.values()):
            if room.guarded.connections:
                room.used_at = now
        idle = [r for r in list(self._rooms.values()) if now - r.used_at > self._idle_s]
        for room in idle:
            self.close_room(room)
        return len(idle)

    async def keep_sweeping(self) -> None:
        """Sweep until cancelled."""
        while True:
            await asyncio.sleep(SWEEP_S)
            try:
                await asyncio.to_thread(self.sweep)
            except Exception:  # one room's trouble must not keep the others open
                log.exception("closing idle viewer rooms failed; trying again")

    def close(self) -> None:
        """End every room."""
        for room in list(self._rooms.values()):
            self.close_room(room)

    def __len__(self) -> int:
        return len(self._rooms)

    def _make_way(self) -> None:
        unwatched = [r for r in self._rooms.values() if not r.guarded.connections]
        if not unwatched:
            raise Busy(
                f"{self._most} viewers are open, which is the most this studio keeps.",
                mend="Close other tabs of the studio and try again.",
            )
        oldest = min(unwatched, key=lambda room: room.used_at)
        del self._rooms[oldest.view_id]
        oldest.stop()
