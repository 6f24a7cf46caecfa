"""Printed bellows: ours beside the measured displacements and blocked forces."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from benchmarks.validation.data import Answer
from benchmarks.validation.markdown import number, percent, table
from benchmarks.validation.plots import figure, picture
from benchmarks.validation.published import BELLOWS

WORDS = Path(__file__).parent / "bellows_words.txt"


def bellows_section(answers: Mapping[str, Answer]) -> str:
    """With its heading; nothing where nothing was computed."""
    rows: list[list[str]] = []
    pairs: list[tuple[float, float, float, float]] = []
    for count, wall, bar, moved, force, their_force, their_miss in BELLOWS:
        name = f"{count}-{wall:.1f}"
        free, pressed = answers.get(f"bellows-{name}-free"), answers.get(f"bellows-{name}-plate")
        ours = _at(free, bar * 100.0, "tip_displacement_mm") - _droop(free)
        push = _at(pressed, bar * 100.0, "plate_force_N")
        pairs.append((moved, ours, force, push))
        if free is not None or pressed is not None:
            rows.append([
                name, f"{bar}", number(moved), number(ours), number(_droop(free)),
                number(their_miss), number(force), number(their_force), number(push), _error(free),
                _error(pressed),
            ])  # fmt: skip
    found = np.array(pairs)
    if not np.isfinite(found[:, [1, 3]]).any():
        return ""
    with figure("bellows", 2) as axes:
        for ax, (measured, ours), what in zip(
            axes, (found[:, :2].T, found[:, 2:].T), ("displacement, mm", "blocked force, N"),
            strict=True,
        ):  # fmt: skip
            ax.plot(measured, ours, "o")
            top = 1.05 * float(np.nanmax([measured, ours]))
            ax.plot([0, top], [0, top], "k--", lw=0.8)
            ax.set(xlabel=f"measured {what}", ylabel=f"3D FE, {what}")
    heads = ["N - wall, mm", "bar", "measured dZ, mm", "ours, mm", "our droop, mm",
             "B's FE misses by, mm", "measured force, N", "B's FE, N", "ours, N",
             "error estimate, free", "error estimate, plate"]  # fmt: skip
    return "\n".join([
        "## Bellows (B)", picture("bellows", "Bellows: ours over measured"), table(heads, rows),
        "", WORDS.read_text(),
    ])  # fmt: skip


def _at(found: Answer | None, pressure: float, key: str) -> float:
    if found is None or found.column("pressure_kPa")[-1] < pressure * (1 - 1e-6):
        return float("nan")
    value = found.path[-1].get(key)
    if value is None:
        return float("nan")
    return -value[2] if isinstance(value, list) else value


def _droop(found: Answer | None) -> float:
    return float("nan") if found is None else -float(found.column("tip_displacement_mm")[0, 2])


def _error(found: Answer | None) -> str:
    return "–" if found is None else percent(found.error_percent)
