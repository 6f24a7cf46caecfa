"""What a running computation tells its caller, and how the caller stops it."""

import time
from collections.abc import Callable
from dataclasses import dataclass

from actuators.mechanics.response import Outcome


@dataclass(frozen=True)
class Progress:
    """``fraction`` 0..1 of the whole computation, never falling; ``pressure`` [Pa] reached."""

    fraction: float
    message: str
    pressure: float | None = None


class Monitor:
    """Passes progress on and collects the reasons to stop."""

    def __init__(
        self,
        progress: Callable[[Progress], None] | None,
        cancelled: Callable[[], bool] | None,
        time_budget: float | None,
    ) -> None:
        self._progress, self._cancelled, self._budget = progress, cancelled, time_budget
        self._start = time.perf_counter()
        self._fraction = 0.0

    def report(self, fraction: float, message: str, pressure: float | None = None) -> None:
        """Tell the caller."""
        self._fraction = max(self._fraction, min(fraction, 1.0))
        if self._progress is not None:
            self._progress(Progress(self._fraction, message, pressure))

    def stop(self) -> Outcome | None:
        """Why to stop now, or None."""
        if self._cancelled is not None and self._cancelled():
            return Outcome.CANCELLED
        if self._budget is not None and self.elapsed > self._budget:
            return Outcome.BUDGET_SPENT
        return None

    @property
    def elapsed(self) -> float:
        """Seconds since the start."""
        return time.perf_counter() - self._start
