"""A room: what one view shows, on one viser server."""

import threading
import time
from dataclasses import dataclass, field

import numpy as np
import viser

from backend.viewer import stage
from backend.viewer.viser_door import GuardedServer

SETTLE_S = 0.25
"""Time given to pages to load new bodies, unseen, before they replace the old ones."""


@dataclass(eq=False)
class _Take:
    """The bodies of one content: a node per frame, and the undeformed body."""

    parent: viser.FrameHandle
    frames: list[viser.GlbHandle]
    shown: int

    def remove(self) -> None:
        self.parent.remove()  # and all below it


@dataclass(frozen=True, eq=False)
class Bodies:
    """What to show: GLBs in mm, one per frame, and the box around all of them (2, 3) [mm]."""

    frames: list[bytes]
    undeformed: bytes | None
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
        self._timer: threading.Timer | None = None
        self._serial = 0
        self._stage = stage.Stage(self.guarded.server, dark=self.dark)

    def show(self, bodies: Bodies, frame: int) -> None:
        """Replace the content without a gap: new bodies are sent hidden, and take the old ones'
        place when pages have had time to load them."""
        server = self.guarded.server
        with self._lock:
            self._drop_waiting()
            self._serial += 1
            with server.atomic():
                take = self._send(bodies, frame, visible=self._take is None)
                self._stage.fit(bodies.box, bodies.clamp)
            if self._take is None:
                self._take = take
                return
            self._waiting = take
            self._timer = threading.Timer(SETTLE_S, self._swap, args=[take])
            self._timer.daemon = True
            self._timer.start()

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
            self._waiting = self._take = None
        self.guarded.stop()

    def _send(self, bodies: Bodies, frame: int, *, visible: bool) -> _Take:
        scene = self.guarded.server.scene
        parent = scene.add_frame(f"/take{self._serial}", show_axes=False, visible=visible)
        frames = [
            scene.add_glb(
                f"{parent.name}/frame{k}", glb, visible=k == frame, cast_shadow=False,
                receive_shadow=False,
            )
            for k, glb in enumerate(bodies.frames)
        ]  # fmt: skip
        if bodies.undeformed is not None:
            scene.add_glb(
                f"{parent.name}/undeformed",
                bodies.undeformed,
                cast_shadow=False,
                receive_shadow=False,
            )
        return _Take(parent, frames, frame)

    def _swap(self, take: _Take) -> None:
        with self._lock:
            if self._waiting is not take:
                return  # overtaken by newer content, or the room is closed
            old, self._take, self._waiting, self._timer = self._take, take, None, None
            with self.guarded.server.atomic():
                take.parent.visible = True
                if old is not None:
                    old.remove()
            self.guarded.forget_removed()

    def _drop_waiting(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
        if self._waiting is not None:
            with self.guarded.server.atomic():
                self._waiting.remove()
        self._waiting = self._timer = None
