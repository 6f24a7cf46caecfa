"""What a running computation tells its caller, and how the caller stops it."""

import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from actuators.mechanics.response import Outcome

_MEMORY_IN_USE = Path("/proc/self/statm")


@dataclass(frozen=True)
class Progress:
    """``fraction`` 0..1 of the whole computation, never falling; ``pressure`` [Pa] reached."""

    fraction: float
    message: str
    pressure: float | None = None


@dataclass(frozen=True)
class Budget:
    """What a computation may take: wall ``seconds``; ``iterations``, a factorisation each;
    ``memory`` [bytes] of the whole process, looked at where the system tells it (Linux). None: as
    much as it takes. Looked at between iterations: the last one is always finished."""

    seconds: float | None = None
    iterations: int | None = None
    memory: float | None = None


class Monitor:
    """Passes progress on and collects the reasons to stop."""

    def __init__(
        self,
        progress: Callable[[Progress], None] | None = None,
        cancelled: Callable[[], bool] | None = None,
        budget: Budget | float | None = None,
    ) -> None:
        self._progress, self._cancelled = progress, cancelled
        self._budget = budget if isinstance(budget, Budget) else Budget(budget)
        self._start = time.perf_counter()
        self._fraction = 0.0
        self._asked = 0
        self.most_memory = 0.0

    def report(self, fraction: float, message: str, pressure: float | None = None) -> None:
        """Tell the caller."""
        self._fraction = max(self._fraction, min(fraction, 1.0))
        if self._progress is not None:
            self._progress(Progress(self._fraction, message, pressure))

    def stop(self) -> Outcome | None:
        """Why to stop now, or None. Asked before every iteration, and once after a failed step:
        the times asked bound the iterations."""
        self._asked += 1
        if self._cancelled is not None and self._cancelled():
            return Outcome.CANCELLED
        return Outcome.BUDGET_SPENT if self._is_spent() else None

    def _is_spent(self) -> bool:
        budget = self._budget
        if budget.memory is not None:
            self.most_memory = max(self.most_memory, memory_in_use())
            if self.most_memory > budget.memory:
                return True
        if budget.iterations is not None and self._asked > budget.iterations:
            return True
        return budget.seconds is not None and self.elapsed > budget.seconds

    @property
    def elapsed(self) -> float:
        """Seconds since the start."""
        return time.perf_counter() - self._start


def memory_in_use() -> float:
    """Memory of this process that is in use now [bytes]; 0 where the system does not tell."""
    try:
        pages = int(_MEMORY_IN_USE.read_text().split()[1])
    except (OSError, ValueError, IndexError):
        return 0.0
    return float(pages * os.sysconf("SC_PAGE_SIZE"))
