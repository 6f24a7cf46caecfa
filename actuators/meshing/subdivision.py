"""Lines of a mesh between the lattice lines of a body.

The error of a pneu-net sits at the re-entrant edges of its chambers, so that thin layers at the
block borders pay more than uniform refinement. Subdivisions are nested: with the same ``uniform``,
the lines of more layers contain those of fewer.
"""

from collections.abc import Sequence

import numpy as np

FIRST_LAYER = 1 / 8
"""Thickness of a single layer over that of the interval (or part) it is cut from."""
LAYER_RATIO = 1 / 4
"""Thickness of every further layer over that of the one before."""


def subdivide(
    lines: np.ndarray,
    *,
    uniform: int | Sequence[int] = 1,
    layers: int = 0,
    graded_first: bool = True,
    graded_last: bool = True,
) -> np.ndarray:
    """Increasing mesh lines that contain ``lines``.

    Every interval is cut into ``uniform`` equal parts (one number, or one per interval); then
    the outermost part at either end is cut ``layers`` times, at :data:`FIRST_LAYER` and, within the
    layer, at :data:`LAYER_RATIO`.
    ``graded_first`` and ``graded_last`` say whether the two ends of the whole range get layers;
    inner lines always do.
    """
    count = len(lines) - 1
    parts = np.broadcast_to(np.asarray(uniform, dtype=int), (count,))
    if layers < 0 or (parts < 1).any():
        raise ValueError("subdivisions must be positive and layers not negative")
    pieces = [
        _interval(int(n), layers, graded_first or k > 0, graded_last or k < count - 1)
        for k, n in enumerate(parts)
    ]
    out = [lines[k] + (lines[k + 1] - lines[k]) * piece[:-1] for k, piece in enumerate(pieces)]
    return np.concatenate([*out, lines[-1:]])


def _interval(parts: int, layers: int, at_start: bool, at_end: bool) -> np.ndarray:
    """Lines of one interval in [0, 1]."""
    inner = np.linspace(0.0, 1.0, parts + 1)
    thin = FIRST_LAYER * LAYER_RATIO ** np.arange(layers - 1, -1, -1.0) / parts
    start = thin if at_start else np.empty(0)
    end = 1.0 - thin[::-1] if at_end else np.empty(0)
    return np.concatenate([[0.0], start, inner[1:-1], end, [1.0]])
