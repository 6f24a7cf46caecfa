"""Printed bellows: ours beside the measured displacements and blocked forces."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from actuators.design import preset
from actuators.design.base import Design
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import Scene
from benchmarks.validation.data import Answer
from benchmarks.validation.markdown import number, percent, table
from benchmarks.validation.plots import figure, picture
from benchmarks.validation.published import BELLOWS

WORDS = Path(__file__).parent / "bellows_words.txt"
CHANGES: tuple[tuple[str, float, float | None], ...] = (
    ("nothing", 1.0, None),
    ("bottom twice as thick", 2.0, None),
    ("channel 4 mm high instead of 2 mm", 1.0, 4.0),
    ("both", 2.0, 4.0),
    ("bottom 2.5 times as thick, channel 4 mm", 2.5, 4.0),
)
"""What is changed, the bottom's thickness over the walls', the channel's height [mm]."""


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
        "", WORDS.read_text().replace("{{ASSUMPTIONS}}", assumptions_table()),
    ])  # fmt: skip


def assumptions_table() -> str:
    """The two assumed dimensions that matter, changed in all nine bodies: displacement of the
    instant model over the measured one."""
    heads = ["changed", *(f"{n}-{wall:.1f}" for n, wall, *_ in BELLOWS), "mean", "scatter"]
    lines: list[list[str]] = []
    for name, bottom, channel in CHANGES:
        ratios = np.array([
            _instant_move(_changed(n, wall, bottom, channel), bar) / moved
            for n, wall, bar, moved, *_ in BELLOWS
        ])  # fmt: skip
        logs = np.log(ratios)
        lines.append([name, *(number(float(r), 2) for r in ratios),
                      number(float(np.exp(logs.mean())), 2),
                      f"x / {number(float(np.exp(logs.std())), 2)}"])  # fmt: skip
    return table(heads, lines)


def _changed(count: int, wall: float, bottom: float, channel: float | None) -> Design:
    design = preset(f"bellows-{count}-{wall:.1f}").design
    if bottom != 1.0:
        design = design.changed(bottom_thickness=bottom * wall)
    return design if channel is None else design.changed(channel_height=channel)


def _instant_move(design: Design, bar: float) -> float:
    """Way of the tip downwards from its place under the weight [mm], by the instant model."""
    path = predict(design, Scene(bar * 1e5, steps=1)).path
    return 1e3 * float(path[0].tip_displacement[2] - path[-1].tip_displacement[2])


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
