"""How long the stages of a request take."""

import time
from collections.abc import Callable


def milliseconds(stages: dict[str, float]) -> Callable[[str], None]:
    """A stopwatch: each call writes the time since the last one under a name [ms]."""
    last = time.perf_counter()

    def stamp(name: str) -> None:
        nonlocal last
        now = time.perf_counter()
        stages[name] = round((now - last) * 1e3, 2)
        last = now

    return stamp
