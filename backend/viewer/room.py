"""A room: what one view shows, on one viser server."""

import threading
import time
from dataclasses import dataclass, field

import numpy as np
import viser

from backend.viewer import stage
from backend.viewer.viser_door import GuardedServer

LATEST_S = 60.0
"""New bodies replace the old ones after this time though a page has not said that it has loaded
them: one that cannot must not keep the others waiting."""


@dataclass(eq=False)
class _Take:
    """The bodies of one content: a node per frame, and the undeformed body."""

    name: str
    bodies: int
    parent: viser.FrameHandle
    frames: list[viser.GlbHandle]
    shown: int
    box: np.ndarray
    clamp: np.ndarray

    def remove(self) -> None:
        self.parent.remove()  # and all below it


@dataclass(frozen=True, eq=False)
class Bodies:
    """What to show: GLBs in mm, one per frame and one per obstacle, each with the name ``take`` in
    its extras, and the box around all of them (2, 3) [mm]."""

    take: str
    frames: list[bytes]
    undeformed: bytes | None
    obstacles: list[bytes]
    box: np.ndarray
    clamp: np.ndarray


@dataclass(eq=False)
class Room:
    """One view's scene. Its methods may be called from any thread."""

    view_id: str
    owner: str
    dark: bool
    guarded: GuardedServer = field(default_factory=GuardedServer)
    used_at: float = field(default_factory=time.monotonic)

    def __post_init__(self) -> None:
        self._lock = threading.Lock()
        self._take: _Take | None = None
        self._waiting: _Take | None = None
        self._loaded_by: dict[str, set[str]] = {}
        self._next: tuple[Bodies, int] | None = None
        self._timer: threading.Timer | None = None
        self._serial = 0
        self._tickets = 0
        self._newest = 0
        self._stage = stage.Stage(self.guarded.server, dark=self.dark)

    def ticket(self) -> int:
        """To be drawn before content is built: of two requests at once the later one wins."""
        with self._lock:
            self._tickets += 1
            return self._tickets

    def show(self, bodies: Bodies, frame: int, ticket: int) -> None:
        """Replace the content without a gap: new bodies are sent hidden, and take the old ones'
        place when every page says that it has loaded them. Content that comes meanwhile is sent
        after that; of several only the newest."""
        with self._lock:
            if ticket < self._newest:
                return
            self._newest = ticket
            if self._take is None:
                self._take = self._send(bodies, frame, visible=True)
                return
            self._next = (bodies, frame)
            if self._waiting is None:
                self._send_next()

    def loaded(self, take: str, bodies: int, page: str) -> None:
        """A page has loaded so many bodies of a take. The old ones must be there as well before
        they go: what viser's page is told to remove while it loads it may stay for ever."""
        with self._lock:
            for each in (self._take, self._waiting):
                if each is not None and each.name == take:
                    pages = self._loaded_by.setdefault(take, set())
                    (pages.add if bodies >= each.bodies else pages.discard)(page)
            if self._waiting is not None and self._is_loaded(self._take, self._waiting):
                self._swap()

    def show_frame(self, index: int) -> None:
        """Toggle two nodes; 0.1 kB to the page."""
        with self._lock:
            for take in (self._take, self._waiting):
                if take is None or not take.frames:
                    continue
                index_there = min(index, len(take.frames) - 1)
                if index_there != take.shown:
                    with self.guarded.server.atomic():
                        take.frames[index_there].visible = True
                        take.frames[take.shown].visible = False
                    take.shown = index_there
            if self._next is not None:
                bodies, _ = self._next
                self._next = bodies, min(index, len(bodies.frames) - 1)

    def set_dark(self, dark: bool) -> None:
        """Light or dark surroundings."""
        with self._lock, self.guarded.server.atomic():
            self.dark = dark
            self._stage.set_dark(dark)

    def move_camera(self, name: str) -> None:
        """Move every page's camera to a named place."""
        with self._lock:
            self._stage.move_camera(name)

    def stop(self) -> None:
        """End the room; pages that still look at it lose it."""
        with self._lock:
            if self._timer is not None:
                self._timer.cancel()
            self._waiting = self._take = self._next = None
        self.guarded.stop()

    def _send(self, bodies: Bodies, frame: int, *, visible: bool) -> _Take:
        scene = self.guarded.server.scene
        self._serial += 1
        with self.guarded.server.atomic():
            parent = scene.add_frame(f"/take{self._serial}", show_axes=False, visible=visible)
            # the frame to be seen comes first, so that pages load it first
            order = sorted(range(len(bodies.frames)), key=lambda k: k != frame)
            frames = {k: self._add(f"{parent.name}/frame{k}", bodies.frames[k]) for k in order}
            for k in order[1:]:
                frames[k].visible = False
            others = [] if bodies.undeformed is None else [bodies.undeformed]
            others += bodies.obstacles
            for k, body in enumerate(others):
                self._add(f"{parent.name}/other{k}", body)
            if visible:
                self._stage.fit(bodies.box, bodies.clamp)
        count = len(frames) + len(others)
        in_order = [frames[k] for k in sorted(frames)]
        return _Take(bodies.take, count, parent, in_order, frame, bodies.box, bodies.clamp)

    def _add(self, name: str, glb: bytes) -> viser.GlbHandle:
        scene = self.guarded.server.scene
        return scene.add_glb(name, glb, cast_shadow=False, receive_shadow=False)

    def _send_next(self) -> None:
        """Send the newest content hidden; with no page to wait for it is shown at once."""
        if self._next is None:
            return
        bodies, frame = self._next
        self._next = None
        take = self._waiting = self._send(bodies, frame, visible=False)
        if self.guarded.connections == 0:
            self._swap()
            return
        self._timer = threading.Timer(LATEST_S, self._when_late, args=[take])
        self._timer.daemon = True
        self._timer.start()

    def _is_loaded(self, *takes: _Take | None) -> bool:
        pages = self.guarded.connections
        return all(
            take is None or len(self._loaded_by.get(take.name, ())) >= pages for take in takes
        )

    def _when_late(self, take: _Take) -> None:
        with self._lock:
            if self._waiting is take:  # else shown meanwhile, or the room is closed
                self._swap()

    def _swap(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
        old, self._take = self._take, self._waiting
        if old is not None:
            self._loaded_by.pop(old.name, None)
        self._waiting = self._timer = None
        with self.guarded.server.atomic():
            if self._take is not None:
                self._take.parent.visible = True
                # the clamp and the camera belong to the body in view, not to one on its way
                self._stage.fit(self._take.box, self._take.clamp)
            if old is not None:
                old.remove()
        self.guarded.forget_removed()
        self._send_next()
