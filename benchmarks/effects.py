"""Chosen effects against all effects, on random designs in random scenes.

``python -m benchmarks.effects --file benchmarks/effects_cases.jsonl --count 200`` solves every
question twice on the coarsest mesh, once with the effects that the plan chooses and once with all
of them forced on, and prints how far apart the tips end, and the ratio of processor times measured
one after the other. What the file holds is not solved again, so that it can be stopped
(``--seconds``) and go on, or run in parts side by side (``--part 0/2``, a file each);
``--write FILE...`` puts the table of all that the files hold into docs/performance.md.
"""

import argparse
import json
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from actuators.design import FAMILIES, Design, preset
from actuators.mechanics.cell.row import ChamberRow, chamber_row
from actuators.mechanics.choices import NAMES, Choice
from actuators.mechanics.continuum import solve
from actuators.mechanics.effects import plan
from actuators.mechanics.effects.afterwards import LOADS
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.response import Effect, Outcome, Response
from actuators.mechanics.scene import Scene
from benchmarks.random_questions import random_design

CHAMBERS = (2, 3)
STRAINS = (1e-4, 0.15)
"""Largest strain that the linear cell expects at the end of the path."""
PERFORMANCE = Path(__file__).parent.parent / "docs" / "performance.md"
BEGIN, END = "<!-- effects: begin -->", "<!-- effects: end -->"


@dataclass(frozen=True)
class Case:
    """One question: ``difference`` of the tips over the tip's way with all effects (infinite where
    the paths ended differently), processor times [s], names of what was off and of what switched
    itself on."""

    family: str
    difference: float
    chosen_s: float
    all_s: float
    off: tuple[str, ...]
    switched: tuple[str, ...]
    told: tuple[str, ...]
    outcome: str


def random_scene(rng: np.random.Generator, design: Design) -> Scene:
    """Inflation of any strength, each other load or obstacle in some scenes, of any size."""
    row = chamber_row(design)
    low, high = np.log(STRAINS)
    pressure = min(float(np.exp(rng.uniform(low, high))) / row.largest_strain, 1e6)
    gravity: tuple[float, float, float] | None = (0.0, 0.0, -9.81)
    draw = rng.random()
    if draw < 0.2:
        gravity = None
    elif draw < 0.3:
        gravity = (0.0, 9.81, 0.0)
    force = None
    if rng.random() < 0.35:
        size = _weight(row) * 10 ** rng.uniform(-2, 0)
        force = (0.0, 0.0, float(size * rng.choice([-1.0, 1.0])))
    outside = 0.0
    if rng.random() < 0.25:
        outside = float(pressure * 10 ** rng.uniform(-3, -1) * rng.choice([-1.0, 1.0]))
    plate = cylinder = None
    draw, gap = rng.random(), float(design.length * 10 ** rng.uniform(-2.5, -0.5))
    if draw < 0.25:
        plate = Plate(gap)
    elif draw < 0.4:
        radius, at = 0.2 * design.length, float(rng.uniform(0.5, 0.9)) * design.length
        cylinder = Cylinder(radius, (at, 0.0, -(radius + gap)))
    return Scene(
        pressure, steps=2, gravity=gravity, tip_force=force, outside_pressure=outside,
        plate=plate, cylinder=cylinder,
    )  # fmt: skip


def _weight(row: ChamberRow) -> float:
    return float(row.line_mass.sum() * row.pitch * 9.81)


def everything(scene: Scene) -> Scene:
    """The scene with every effect that it can have forced on."""
    there = {
        "gravity": bool(any(scene.gravity or ())), "plate_contact": scene.plate is not None,
        "cylinder_contact": scene.cylinder is not None,
        "outside_pressure": scene.outside_pressure != 0.0,
        "tip_force": scene.tip_force is not None,
        "finite_strain": True, "hyperelasticity": True, "self_contact": True,
    }  # fmt: skip
    on: dict[str, Choice] = {name: "on" for name, present in there.items() if present}
    return scene.choosing(**on)


def compare(design: Design, scene: Scene, accuracy: float) -> Case:
    """Both answers to one question; the order does not matter, kernels are compiled before."""
    begun = time.process_time()
    chosen = solve(design, scene, accuracy=accuracy, mesh="coarse")
    between = time.process_time()
    whole = solve(design, everything(scene), accuracy=accuracy, mesh="coarse")
    ended = time.process_time()
    decided = plan(design, scene, accuracy)
    relevant = {d.name for d in plan(design, everything(scene), accuracy).decisions if d.on}
    effects = {e.name: e for e in chosen.effects if e.name in NAMES}
    return Case(
        family=design.family,
        difference=apart(chosen, whole),
        chosen_s=between - begun,
        all_s=ended - between,
        off=tuple(n for n in NAMES if n in relevant and not effects[n].on),
        switched=tuple(n for n in NAMES if effects[n].on and not decided.on(n)),
        told=tuple(n for n in LOADS if _told(effects[n], decided.threshold)),
        outcome=whole.outcome.value,
    )


def _told(effect: Effect, threshold: float) -> bool:
    return not effect.on and (effect.estimated_change_percent or 0.0) > 100 * threshold


def apart(one: Response, other: Response) -> float:
    """Distance of two answers' last tips over the second one's way; for answers that end at a
    limit, of their limit pressures."""
    if one.outcome is not other.outcome or not one.path or not other.path:
        return np.inf
    if one.outcome is Outcome.LIMIT_POINT and one.limit_pressure and other.limit_pressure:
        return abs(one.limit_pressure / other.limit_pressure - 1.0)
    a, b = one.path[-1], other.path[-1]
    ways = [float(np.linalg.norm(p.tip_displacement)) for p in other.path]
    return float(np.linalg.norm(np.subtract(a.tip, b.tip))) / max(ways)


def table(cases: Sequence[Case], accuracy: float) -> str:
    """The result as Markdown."""
    ratios = np.array([c.all_s / c.chosen_s for c in cases])
    known = [c.difference for c in cases if np.isfinite(c.difference)]
    lines = [
        f"{len(cases)} random questions at an accuracy of {accuracy:.0%}, coarsest mesh, one "
        "thread, processor time:",
        "",
        "| family | questions | within the accuracy | median difference | largest | speed-up, "
        "median | all times together |",
        "| --- | --- | --- | --- | --- | --- | --- |",
    ]
    for family in (*FAMILIES, "all"):
        own = [c for c in cases if family in (c.family, "all")]
        if not own:
            continue
        differences = np.array([c.difference for c in own])
        speed = np.array([c.all_s / c.chosen_s for c in own])
        total = sum(c.all_s for c in own) / sum(c.chosen_s for c in own)
        inside = int((differences <= accuracy).sum())
        lines.append(
            f"| {family} | {len(own)} | {inside} ({inside / len(own):.0%}) "
            f"| {np.median(differences):.1%} | {differences.max():.1%} "
            f"| {np.median(speed):.2g} | {total:.2g} |"
        )
    off, switched = Counter[str](), Counter[str]()
    for case in cases:
        off.update(case.off)
        switched.update(case.switched)
    lines += [
        "",
        "Left out: " + ", ".join(f"{n.replace('_', ' ')} {k}" for n, k in off.most_common())
        + ". Switched on during a run: "
        + (", ".join(f"{n.replace('_', ' ')} {k}" for n, k in switched.most_common()) or "nothing")
        + f". Speed-up: geometric mean {np.exp(np.log(ratios).mean()):.2g}, "
        f"10 % of the questions above {np.quantile(ratios, 0.9):.2g}, "
        f"{int((ratios < 0.9).sum())} slower than with all effects. "
        f"{len(cases) - len(known)} ended differently. The look afterwards called for a load in "
        f"{sum(bool(c.told) for c in cases)} of them, "
        f"{sum(bool(c.told) and not c.difference <= accuracy for c in cases)} beyond the accuracy.",
    ]  # fmt: skip
    return "\n".join(lines) + "\n"


def write(text: str) -> None:
    """Put the table between its marks in docs/performance.md."""
    page = PERFORMANCE.read_text()
    head, _, rest = page.partition(BEGIN)
    _, _, tail = rest.partition(END)
    PERFORMANCE.write_text(f"{head}{BEGIN}\n{text}{END}{tail}")


def questions(seed: int) -> Iterator[tuple[Design, Scene]]:
    """Without end, families in turn."""
    rng = np.random.default_rng(seed)
    while True:
        for family in FAMILIES:
            design = random_design(rng, family, CHAMBERS)
            yield design, random_scene(rng, design)


def read(files: Sequence[Path]) -> dict[int, Case]:
    """Cases that the files hold, by their number."""
    found: dict[int, Case] = {}
    for line in (line for file in files if file.exists() for line in file.read_text().splitlines()):
        entry: dict[str, Any] = json.loads(line)
        number = entry.pop("number")
        for names in ("off", "switched", "told"):
            entry[names] = tuple(entry[names])
        found[number] = Case(**entry)
    return dict(sorted(found.items()))


def measure(
    file: Path, seed: int, accuracy: float, count: int, seconds: float, part: tuple[int, int]
) -> None:
    """Add to ``file`` the cases below ``count`` that it lacks, for so many seconds on the clock; of
    their numbers those that leave ``part[0]`` divided by ``part[1]``."""
    start = preset("slab-rectangle-low")
    solve(start.design, everything(Scene(1e3, steps=1)), mesh="coarse")  # kernels into memory
    there, end = read([file]), time.monotonic() + seconds
    for number, (design, scene) in zip(range(count), questions(seed), strict=False):
        if number in there or number % part[1] != part[0]:
            continue
        if time.monotonic() > end:
            return
        case = compare(design, scene, accuracy)
        with file.open("a") as out:
            out.write(json.dumps({"number": number, **asdict(case)}) + "\n")
        mark = "  " if case.difference <= accuracy else "!!"
        print(
            f"{mark} {number:3d} {case.family:8s} {case.difference:8.2%} "
            f"{case.all_s / case.chosen_s:6.2f} x  {case.all_s:5.1f} s  off: {','.join(case.off)}"
            f"  on: {','.join(case.switched)}  told: {','.join(case.told)}  {case.outcome}",
            flush=True,
        )
        if mark == "!!":
            print("     ", design.digest[:12], scene.to_document(), flush=True)


def _part(text: str) -> tuple[int, int]:
    which, of = text.split("/")
    return int(which), int(of)


def main() -> None:
    """Solve, or print and write what was solved."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--file", type=Path)
    parser.add_argument("--write", nargs="+", type=Path)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seconds", type=float, default=np.inf)
    parser.add_argument("--accuracy", type=float, default=0.05)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--part", type=_part, default=(0, 1))
    asked = parser.parse_args()
    if asked.file is not None:
        measure(asked.file, asked.seed, asked.accuracy, asked.count, asked.seconds, asked.part)
    if asked.write:
        text = table(list(read(asked.write).values()), asked.accuracy)
        print(text)
        write(text)


if __name__ == "__main__":
    main()
