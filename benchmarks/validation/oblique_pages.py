"""Oblique chambers: six presets under pressure, and one cell turned through its angles."""

from collections.abc import Mapping

import numpy as np

from actuators.design import preset
from actuators.design.base import Design
from actuators.mechanics.predict import predict
from actuators.mechanics.response import PathPoint
from actuators.mechanics.scene import Scene
from benchmarks.validation.data import Answer
from benchmarks.validation.markdown import number, percent, table
from benchmarks.validation.plots import figure, picture
from benchmarks.validation.published import OBLIQUE_C
from benchmarks.validation.studies import OBLIQUES, SWEEP, sweep_design

COLOURS = ("tab:purple", "tab:blue", "tab:cyan", "tab:green", "tab:orange", "tab:red")
Answers = Mapping[str, Answer]


def instant(design: Design, pressure: float, c: object = "computed") -> PathPoint:
    """The instant model at this pressure [kPa], without weight."""
    return predict(design, Scene(pressure * 1e3, steps=1, gravity=None), c=c).path[-1]


def presets_section(answers: Answers) -> str:
    """Curvature and torsion of the six presets, 3D FE beside the instant model."""
    rows: list[list[str]] = []
    constants: list[list[str]] = []
    with figure("oblique", 2) as (bending, twisting):
        for theta, colour in zip(OBLIQUES, COLOURS, strict=True):
            design = preset(f"oblique-{theta}").design
            computed = _constant(design)
            constants.append([f"{theta}°", f"{OBLIQUE_C[theta]:g}", number(computed),
                              number(OBLIQUE_C[theta] / computed, 2)])  # fmt: skip
            found = answers.get(f"oblique-{theta}")
            if found is None:
                continue
            p = found.column("pressure_kPa")
            line = instant(design, 60.0)
            for ax, key, rate in (
                (bending, "curvature_per_m", line.curvature or 0.0),
                (twisting, "torsion_per_m", line.torsion or 0.0),
            ):
                ax.plot(p, found.column(key), "o-", ms=3, color=colour, label=f"{theta}°")
                ax.plot([0, p[-1]], [0, rate * p[-1] / 60], "--", lw=0.8, color=colour)
            rows += _preset_rows(theta, found, line)
        for ax, name in ((bending, "curvature"), (twisting, "torsion")):
            ax.set(xlabel="pressure, kPa", ylabel=f"{name}, 1/m")
    parts = [
        picture("oblique", "Curvature and torsion of the six presets: 3D FE and instant model"),
        "\n3D FE (points) and the instant model (dashed): means over the whole length.",
        table(["preset", "kPa", "curvature, 1/m", "instant", "torsion, 1/m", "instant",
               "error estimate", "path ended"], rows),
        "\nG's fitted constant against the computed one:\n",
        table(["theta", "c of G, Table 2", "c computed", "G / computed"], constants),
    ]  # fmt: skip
    return "\n".join(parts)


def _preset_rows(theta: int, found: Answer, line: PathPoint) -> list[list[str]]:
    """At round pressures, and at the end of the path."""
    rows: list[list[str]] = []
    end = float(found.column("pressure_kPa")[-1])
    for p in (*(p for p in (10.0, 20.0, 30.0, 40.0) if p < end - 0.1), end):
        share = p / 60
        rows.append([
            f"oblique-{theta}", number(p), number(found.at(p, "curvature_per_m")),
            number((line.curvature or 0) * share), number(found.at(p, "torsion_per_m")),
            number((line.torsion or 0) * share), percent(found.error_percent),
            found.outcome.replace("_", " ") if p == end else "",
        ])  # fmt: skip
    return rows


def _constant(design: Design) -> float:
    notes = predict(design, Scene(1e3, steps=1, gravity=None)).notes
    text = next(note for note in notes if note.startswith("c = "))
    return float(text.removeprefix("c = ").split(",")[0])


def sweep_section(answers: Answers) -> str:
    """Where does it twist most?"""
    known = [a for a in SWEEP if f"theta-{a}" in answers]
    angles = np.array(known, dtype=float)
    fine = np.arange(15.0, 90.5, 1.0)
    points = [instant(sweep_design(a), 1.0) for a in fine]
    cell = {"torsion_per_m": np.array([p.torsion for p in points], dtype=float),
            "curvature_per_m": np.array([p.curvature for p in points], dtype=float)}  # fmt: skip
    energy = [instant(sweep_design(a), 1.0, c=1.0) for a in fine]
    lines = {
        "torsion_per_m": np.array([p.torsion for p in energy], dtype=float),
        "curvature_per_m": np.array([p.curvature for p in energy], dtype=float),
    }
    pressures = (2.5, 5.0, 10.0)
    with figure("theta", 2) as axes:
        for ax, key in zip(axes, cell, strict=True):
            ax.plot(fine, cell[key], "k-", lw=1, label="periodic cell (instant)")
            scale = np.abs(cell["torsion_per_m"]).max() / np.abs(lines["torsion_per_m"]).max()
            ax.plot(fine, scale * lines[key], "k:", lw=1, label="energy model, scaled")
            for p, colour in zip(pressures, ("tab:blue", "tab:green", "tab:red"), strict=True):
                values = [answers[f"theta-{a}"].at(p, key) / p for a in known]
                ax.plot(angles, values, "o-", ms=3, lw=0.8, color=colour, label=f"3D FE, {p:g} kPa")
            ax.set(xlabel="theta, degrees", ylabel=f"{key.split('_')[0]} per kPa, 1/(m kPa)")
            ax.axhline(0, color="k", lw=0.5)
    found_rows = [
        [f"3D FE, {p:g} kPa", *(_places(angles, *(
            np.array([answers[f"theta-{a}"].at(p, key) for a in known])
            for key in ("torsion_per_m", "curvature_per_m")
        )))]
        for p in pressures
    ]  # fmt: skip
    found_rows.append(["periodic cell (instant model)", *_places(fine, *cell.values())])
    found_rows.append(["energy model (10), any constant c", *_places(fine, *lines.values())])
    found_rows += _presets_places(answers)
    numbers = [
        [f"{a}°", *(number(answers[f"theta-{a}"].at(p, k)) for k in cell for p in pressures),
         number(answers[f"theta-{a}"].at(pressures[-1], "max_contact_pressure_kPa"), 2),
         percent(answers[f"theta-{a}"].error_percent)]
        for a in known
    ]  # fmt: skip
    heads = [f"{n} at {p:g} kPa" for n in ("torsion", "curvature") for p in pressures]
    return "\n".join([
        picture("theta", "Torsion and curvature per pressure against the chamber angle"),
        table(["model", "most torsion at", "most torsion over curvature at",
               "bending vanishes at"], found_rows),
        "",
        table(["theta", *heads, "walls press, kPa, at 10 kPa", "error estimate (tip)"], numbers),
    ])  # fmt: skip


def _presets_places(answers: Answers) -> list[list[str]]:
    """The same of G's six presets, whose t's and n change with the angle."""
    angles = np.array(OBLIQUES, dtype=float)
    line = [instant(preset(f"oblique-{a}").design, 1.0) for a in OBLIQUES]
    values = [
        np.array(v, dtype=float) for v in ([q.torsion for q in line], [q.curvature for q in line])
    ]
    rows = [["G's six presets, instant model", *_places(angles, *values)]]
    found = [answers.get(f"oblique-{a}") for a in OBLIQUES]
    known = [f for f in found if f is not None]
    if len(known) == len(found):
        both = [
            np.array([f.at(10.0, k) for f in known]) for k in ("torsion_per_m", "curvature_per_m")
        ]
        rows.append(["G's six presets, 3D FE, 10 kPa", *_places(angles, *both)])
    return rows


def _places(angles: np.ndarray, torsion: np.ndarray, curvature: np.ndarray) -> list[str]:
    ratio = torsion / np.where(curvature == 0, np.nan, curvature)
    change = np.flatnonzero(np.diff(np.sign(curvature)))
    if len(change):
        k = int(change[0])
        zero = angles[k] - curvature[k] * (angles[k + 1] - angles[k]) / (
            curvature[k + 1] - curvature[k]
        )
        return [_peak(angles, torsion), f"{zero:.1f}° (no curvature)", f"{zero:.1f}°"]
    return [_peak(angles, torsion), _peak(angles, ratio), "nowhere from 15° to 90°"]


def _peak(angles: np.ndarray, values: np.ndarray) -> str:
    """Where a parabola through the largest value and its neighbours is level."""
    if np.argmax(values) == 0:
        return f"{angles[0]:.0f}° (the smallest)"
    k = int(np.clip(np.argmax(values), 1, len(values) - 2))
    a, b, _ = np.polyfit(angles[k - 1 : k + 2], values[k - 1 : k + 2], 2)
    return f"{-b / (2 * a):.0f}°"
