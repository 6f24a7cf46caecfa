"""The path found so far, made into something to keep now and then: that takes time of the solver's
own thread, a tenth of what a state takes to be found. All times are those of the processor, for the
clock runs on while a busy machine computes something else."""

import logging
import time
from collections.abc import Callable

from actuators.mechanics.response import Response
from storage import Part
from storage.response_arrays import pack

Make = Callable[[], Response]
SHARE = 0.015
"""Of the processor's time so far, that making, packing and writing may take."""
FIRST_S = 5.0
"""Of the processor, before anything is worth keeping."""

_logger = logging.getLogger(__name__)


class PathKept:
    """The solver's thread calls :meth:`offer`, :meth:`look` and :meth:`newest`; the keeper's
    :meth:`take`, and tells by :meth:`spend` what it took to keep it."""

    def __init__(self) -> None:
        self._started = time.process_time()
        self._spent = self._last = 0.0
        self._make: Make | None = None
        self._made: Response | None = None
        self._is_new = False

    def offer(self, make: Make) -> None:
        """A state was found, of which ``make`` makes an answer."""
        self._make = make
        self.look()

    def look(self) -> None:
        """Make what was offered last, if it is time."""
        now = time.process_time() - self._started
        if now >= FIRST_S and self._spent + self._last <= SHARE * now:
            self._made_now()

    def newest(self) -> Response | None:
        """All that was found, whatever it takes: of a solver that will find no more."""
        self._made_now()
        return self._made

    def take(self) -> Response | None:
        """What was made since the last time."""
        if not self._is_new:
            return None
        self._is_new = False
        return self._made

    def spend(self, seconds: float) -> None:
        """What it took to keep what was taken [s]."""
        self._spent += seconds
        self._last += seconds

    def _made_now(self) -> None:
        make, self._make = self._make, None
        if make is None:
            return
        started = time.thread_time()  # threads of the solver's library may spin beside it
        try:
            made = make()
        except Exception:
            _logger.exception("no part of the path from this state")
        else:
            if len(made.path) > 1:
                self._made, self._is_new = made, True
        self._last = time.thread_time() - started
        self._spent += self._last


def as_part(response: Response, fraction: float) -> Part:
    """A part as it is stored."""
    return Part(response.to_document(), pack(response), fraction)
