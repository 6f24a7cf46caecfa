"""Tables and numbers as the page writes them."""

import math
from collections.abc import Sequence


def table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = ["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads)]
    return "\n".join([*lines, *("| " + " | ".join(row) + " |" for row in rows)])


def number(value: float | None, digits: int = 3) -> str:
    """To so many digits; a dash where there is none."""
    if value is None or not math.isfinite(value):
        return "–"
    if abs(value) < 1e-9:
        return "0"
    short = f"{value:.{digits}g}"
    return f"{float(short):.0f}" if "e+" in short else short


def percent(value: float | None, digits: int = 2) -> str:
    return "none" if value is None else f"{value:.{digits}g} %"
