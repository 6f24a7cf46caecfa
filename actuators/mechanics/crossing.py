"""Where something begins along a path that is known at points only."""

import numpy as np


def first_below(along: np.ndarray, values: np.ndarray, level: float = 0.0) -> float | None:
    """Where ``values`` (k,) first fall below ``level``, between the points of a path: ``along`` it
    (k,), such as pressures. The first point's place where they begin below, None where they stay
    above."""
    below = np.flatnonzero(values < level)
    if len(below) == 0:
        return None
    at = slice(max(int(below[0]) - 1, 0), int(below[0]) + 1)
    return float(np.interp(-level, -values[at], along[at]))
