"""Cell and rod against 3D finite elements on every preset, and what it costs.

``python -m benchmarks.cell_rod`` compares with the 3D answers kept in ``cell_rod_reference.json``
and writes the table of docs/cell_rod.md; ``--reference`` computes those that are missing
(minutes each); ``--times`` measures times only.
"""

import argparse
import json
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from actuators.design import PRESETS, preset
from actuators.mechanics.cell.cache import forget_cells
from actuators.mechanics.cell.inflated_cache import forget_paths
from actuators.mechanics.cell_rod.cells import forget_shear_and_bending
from actuators.mechanics.cell_rod.grip import forget_grips
from actuators.mechanics.cell_rod.root import forget_roots
from actuators.mechanics.predict import predict
from actuators.mechanics.response import Response
from actuators.mechanics.scene import Scene

REFERENCE = Path(__file__).parent / "cell_rod_reference.json"
PAGE = Path(__file__).parent.parent / "docs" / "cell_rod.md"
STEPS = 4
REPEATS = 7
# [kPa] moderate: half of what a family is inflated to, where 3D paths take minutes, not hours
PRESSURES = {"slab": 6.0, "oblique": 15.0, "printed": 50.0}
ACCURACY = {"oblique": 0.1}


def pressure_of(name: str) -> float:
    """End of a preset's path [kPa]."""
    for family, pressure in PRESSURES.items():
        if name.startswith(family):
            return pressure
    return preset(name).pressure_to / 2e3


def compute_missing() -> None:
    """3D answers of the presets that have none yet, each stored at once."""
    from actuators.mechanics.continuum import solve

    known = references()
    for name in PRESETS:
        if name in known:
            continue
        accuracy = ACCURACY.get(name.split("-")[0], 0.05)
        scene = Scene(pressure_of(name) * 1e3, steps=STEPS)
        answer = solve(preset(name).design, scene, accuracy=accuracy, time_budget=900)
        known[name] = _kept(answer.to_document())
        REFERENCE.write_text(json.dumps(known, indent=1) + "\n")
        print(f"{name}: {answer.outcome.value}")


def _kept(document: dict[str, Any]) -> dict[str, Any]:
    names = ("pressure_kPa", "tip_mm", "tip_displacement_mm", "tip_rotation_deg",
             "cavity_volume_ml")  # fmt: skip
    return {
        "outcome": document["outcome"],
        "error_estimate_percent": document["error_estimate_percent"],
        "unknowns": document["unknowns"],
        "path": [{n: point[n] for n in names} for point in document["path"]],
    }


def references() -> dict[str, Any]:
    """3D answers by preset."""
    return json.loads(REFERENCE.read_text()) if REFERENCE.exists() else {}


def deviations(name: str, rung: str) -> tuple[Response, np.ndarray]:
    """The rung's answer, and its tip's distance from the 3D one at every point of that: [% of the
    body's length, % of the tip's displacement], (k, 2)."""
    found = references()[name]["path"]
    pressures = np.array([point["pressure_kPa"] for point in found]) * 1e3
    # the path ends where the 3D one does
    answer = predict(preset(name).design, Scene(float(pressures[-1]), steps=24), rung=rung)
    at = np.array([point.pressure for point in answer.path])
    tips = np.array([point.tip for point in answer.path]) * 1e3
    tip = np.stack([np.interp(pressures, at, tips[:, a]) for a in range(3)], axis=-1)
    apart = np.linalg.norm(tip - [point["tip_mm"] for point in found], axis=1)
    moved = np.linalg.norm([point["tip_displacement_mm"] for point in found], axis=1)
    length = preset(name).design.length * 1e3
    return answer, 100 * np.stack([apart / length, apart / np.maximum(moved, 1e-9)], axis=-1)


def table() -> str:
    """Markdown table of all presets with a 3D answer."""
    rows = [
        "| preset | to, kPa | 3D tip | 3D estimate | cell-rod, % of length (of the tip's way) |"
        " energy rung |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for name in PRESETS:
        if name not in references():
            rows.append(f"| {name} | | no 3D answer in the time given | | | |")
            continue
        known = references()[name]
        _, ours = deviations(name, "cell-rod")
        _, instant = deviations(name, "energy")
        last = known["path"][-1]
        tip = ", ".join(f"{x:.1f}" for x in last["tip_mm"])
        estimate = known["error_estimate_percent"]
        told = "coarsest mesh only" if estimate is None else f"{estimate:.2g} %"
        rows.append(
            f"| {name} | {last['pressure_kPa']:g} | ({tip}) mm | {told} "
            f"| {ours[:, 0].max():.1f} ({ours[-1, 1]:.1f}) "
            f"| {instant[:, 0].max():.1f} ({instant[-1, 1]:.1f}) |"
        )
    return "\n".join(rows)


def times() -> str:
    """Markdown table of processor times with new and with kept cells."""
    rows = [
        "| preset | new cells, ms | of which rod | other load, cells kept, ms | "
        "energy rung, cells kept, ms |",
        "| --- | --- | --- | --- | --- |",
    ]
    for name in ("slab-rectangle-low", "slab-ellipse-low", "oblique-90", "oblique-45",
                 "printed-14", "bellows-11-2.0"):  # fmt: skip
        ask = partial(_question, name)
        ask()()
        cold = _milliseconds(ask(), _forget)
        share = ask()().timings["rod"] * 1e3
        kept = _milliseconds(ask(5.0))
        energy = _milliseconds(ask(rung="energy"))
        rows.append(f"| {name} | {cold:.0f} | {share:.0f} | {kept:.1f} | {energy:.1f} |")
    return "\n".join(rows)


def _question(name: str, weight: float = 9.81, rung: str = "cell-rod") -> Callable[[], Response]:
    scene = Scene(pressure_of(name) * 1e3, steps=20, gravity=(0.0, 0.0, -weight))
    return partial(predict, preset(name).design, scene, rung=rung)


def _forget() -> None:
    for forget in (forget_cells, forget_paths, forget_shear_and_bending, forget_grips,
                   forget_roots):  # fmt: skip
        forget()


def _milliseconds(work: Callable[[], object], before: Callable[[], None] = lambda: None) -> float:
    """Median processor time."""
    spent: list[float] = []
    for _ in range(REPEATS):
        before()
        start = time.process_time()
        work()
        spent.append(1e3 * (time.process_time() - start))
    return median(spent)


def main() -> None:
    """Print the tables, and put them on their page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--reference", action="store_true", help="compute missing 3D answers")
    parser.add_argument("--times", action="store_true", help="measure times only")
    chosen = parser.parse_args()
    if chosen.reference:
        compute_missing()
    parts = {"times": times()} if chosen.times else {"deviations": table(), "times": times()}
    page = PAGE.read_text()
    for name, text in parts.items():
        begin, end = f"<!-- {name} -->\n", f"\n<!-- end of {name} -->"
        head, rest = page.split(begin)
        page = head + begin + text + end + rest.split(end)[1]
        print(text)
    PAGE.write_text(page)


if __name__ == "__main__":
    main()
