"""What a running computation tells its caller, and how the caller stops it."""

import time
from collections.abc import Callable
from dataclasses import dataclass

from actuators.mechanics.continuum.memory import memory_free, memory_in_use
from actuators.mechanics.response import Outcome, Response


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
    much as it takes, of memory as the machine has. Looked at between iterations: the last one is
    always finished; of memory besides before a mesh is made, see :meth:`Monitor.room`."""

    seconds: float | None = None
    iterations: int | None = None
    memory: float | None = None


class Monitor:
    """Passes progress on and collects the reasons to stop.

    ``found`` is given every state of a path as what makes an answer of the path up to there. That
    costs time: it may be left undone, and is done in the solver's thread, between iterations (in
    ``found``, ``progress`` or ``cancelled``).
    """

    def __init__(
        self,
        progress: Callable[[Progress], None] | None = None,
        cancelled: Callable[[], bool] | None = None,
        budget: Budget | float | None = None,
        found: Callable[[Callable[[], Response]], None] | None = None,
    ) -> None:
        self._progress, self._cancelled, self._found = progress, cancelled, found
        self._budget = budget if isinstance(budget, Budget) else Budget(budget)
        self._start, self._start_cpu = time.perf_counter(), time.process_time()
        self._fraction = 0.0
        self._asked = 0
        self.most_memory = 0.0

    def report(self, fraction: float, message: str, pressure: float | None = None) -> None:
        """Tell the caller."""
        self._fraction = max(self._fraction, min(fraction, 1.0))
        if self._progress is not None:
            self._progress(Progress(self._fraction, message, pressure))

    def found(self, part: Callable[[], Response]) -> None:
        """Offer the path found so far."""
        if self._found is not None:
            self._found(part)

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

    def room(self) -> float:
        """Memory [bytes] that may still be taken: what the budget leaves, and the machine has."""
        free = memory_free()
        if self._budget.memory is not None:
            free = min(free, self._budget.memory - memory_in_use())
        return free

    @property
    def elapsed(self) -> float:
        """Seconds since the start."""
        return time.perf_counter() - self._start

    @property
    def elapsed_cpu(self) -> float:
        """Seconds of the processor since the start, of the whole process."""
        return time.process_time() - self._start_cpu
