"""Which stock sheets to stack for a wanted height."""

import math
from collections.abc import Sequence

STOCK_MM: tuple[float, ...] = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
"""Common thicknesses of acrylic sheet."""

_GRAIN = 0.01  # thicknesses are told apart to 0.01 mm


def stack(
    height: float, stock: Sequence[float] = STOCK_MM, *, above: float = 0.0
) -> tuple[float, ...]:
    """The fewest sheets, thickest first, whose sum is nearest to ``height`` and greater than
    ``above``; all in mm. The sum may miss the height where the stock does not allow it."""
    if not stock or any(not math.isfinite(t) or t < _GRAIN for t in stock):
        raise ValueError(f"stock must hold thicknesses of {_GRAIN} mm or more, not {stock}")
    grains = sorted({round(t / _GRAIN) for t in stock}, reverse=True)
    wanted, floor = height / _GRAIN, round(above / _GRAIN)
    # a sum beyond both by the thickest sheet is never needed
    limit = max(math.ceil(wanted), floor) + grains[0]
    count = [0] + [limit + 1] * limit
    top = [0] * (limit + 1)
    for total in range(1, limit + 1):
        for sheet in grains:
            if sheet <= total and count[total - sheet] + 1 < count[total]:
                count[total], top[total] = count[total - sheet] + 1, sheet
    reachable = [t for t in range(floor + 1, limit + 1) if count[t] <= limit]
    best = min(reachable, key=lambda t: (round(abs(t - wanted), 6), count[t]))
    sheets: list[float] = []
    while best > 0:
        sheets.append(round(top[best] * _GRAIN, 2))
        best -= top[best]
    return tuple(sorted(sheets, reverse=True))
