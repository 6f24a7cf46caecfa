"""Timed finite-element jobs, one line of JSON each: what predictions of time are made from and
judged by.

Streams of questions. *Unrelated*: random designs of all families in random scenes. *Sessions*:
what a studio sees, one design and scene after another, each a small change of the one before.
*Suction*: sessions whose chambers are sucked empty, by pressure or by volume.
"""

import json
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from actuators.design import FAMILIES, Design, parse_design
from actuators.errors import InputError, QuestionError
from actuators.mechanics.cell.row import chamber_row
from actuators.mechanics.ladder.ends import SMALLEST_ERROR
from actuators.mechanics.ladder.past import JUDGED, PastJob
from actuators.mechanics.ladder.question import LevelErrors, mesh_sizes, outlook
from actuators.mechanics.obstacles import Plate
from actuators.mechanics.scene import STANDARD_GRAVITY, STRONGEST, VACUUM, Scene
from actuators.meshing.levels import MeshChoice
from benchmarks.random_questions import KINDS, random_design, random_questions, random_scene
from benchmarks.validation.data import read as validation_answers
from benchmarks.validation.studies import all_cases

ACCURACIES = (0.3, 0.3, 0.2, 0.1, 0.1, 0.05, 0.02)
SHARE_OF_MESHES = 0.2
"""Part of the jobs that name the coarsest mesh instead."""
DRAINED = (0.04, 0.5)
"""Share of its air that suction takes from the linear cavity, drawn evenly in its logarithm."""
STREAMS = ("unrelated", "sessions", "suction")
NAME = ("stream", "seed", "number")
CHAMBERS = (1, 3)
ENDED = ("converged", "limit_point", "stalled")
SESSION = 9
"""Jobs of one session."""
MOVES = ("pressure", "pressure", "pressure", "length", "length", "length", "length", "accuracy",
         "accuracy", "chambers", "load")  # fmt: skip
"""What a designer changes from one job to the next: sliders mostly."""
MOST_MOVES = 3
"""Changes between two jobs, at most; as many are drawn evenly from one on."""


@dataclass(frozen=True)
class Asked:
    """One job: a question, and how well it is to be answered. ``move``: what was changed since the
    job before, ``start`` for the first one of a session or an unrelated one."""

    design: Design
    scene: Scene
    kind: str
    accuracy: float
    mesh: MeshChoice | None
    move: str = "start"


def unrelated(seed: int) -> Iterator[Asked]:
    """Random designs in random scenes, without end."""
    rng = np.random.default_rng(seed + 1000)
    for each in random_questions(seed, CHAMBERS):
        accuracy = float(rng.choice(ACCURACIES))
        mesh: MeshChoice | None = "coarse" if rng.random() < SHARE_OF_MESHES else None
        yield Asked(each.design, each.scene, each.kind, accuracy, mesh)


def sessions(seed: int, *, suction: bool = False) -> Iterator[Asked]:
    """Designers one after another, without end, families in turn; each asks SESSION times, mostly
    changing what was asked last by up to three moves."""
    number = 0
    while True:
        rng = np.random.default_rng([seed, number])
        family = list(FAMILIES)[number % len(FAMILIES)]
        design = random_design(rng, family, CHAMBERS)
        kind = "suction" if suction else str(rng.choice(KINDS))
        accuracy = float(rng.choice(ACCURACIES))
        mesh: MeshChoice | None = "coarse" if rng.random() < SHARE_OF_MESHES else None
        scene = _drained(rng, design) if suction else random_scene(rng, design, kind)
        asked = Asked(design, scene, kind, accuracy, mesh)
        yield asked
        for _ in range(SESSION - 1):
            last = asked
            for _ in range(int(rng.integers(1, MOST_MOVES + 1))):
                last = _moved(rng, last)
            asked = replace(last, move=_named(last, asked))
            yield asked
        number += 1


def _drained(rng: np.random.Generator, design: Design) -> Scene:
    """Suction, asked for by its pressure or by what it leaves of the air."""
    row = chamber_row(design)
    air = float(row.cavity_volume.sum())
    taken = float(np.exp(rng.uniform(*np.log(DRAINED)))) * air
    gravity = None if rng.random() < 0.3 else STANDARD_GRAVITY
    if rng.random() < 0.4:
        return Scene(volume_to=air - taken, gravity=gravity)
    pressure = taken / float(row.cavity_compliance.sum())
    return Scene(pressure_to=-min(pressure, VACUUM), gravity=gravity)


def _moved(rng: np.random.Generator, last: Asked) -> Asked:
    """The same question after one change."""
    while True:
        move = str(rng.choice(MOVES))
        try:
            changed = _change(rng, last, move)
        except InputError:
            continue
        if changed != last:
            return changed


def _named(asked: Asked, before: Asked) -> str:
    """What of a question has changed that matters most to its time."""
    if (asked.accuracy, asked.mesh) != (before.accuracy, before.mesh):
        return "accuracy"
    if getattr(asked.design, "chamber_count") != getattr(before.design, "chamber_count"):  # noqa: B009
        return "chambers"
    return "sliders"


def _change(rng: np.random.Generator, last: Asked, move: str) -> Asked:
    scene, design = last.scene, last.design
    if move == "accuracy":
        mesh: MeshChoice | None = "coarse" if rng.random() < SHARE_OF_MESHES else None
        return replace(last, accuracy=float(rng.choice(ACCURACIES)), mesh=mesh)
    if move == "pressure":
        factor = float(np.exp(rng.uniform(-0.35, 0.35)))
        if scene.pressure_to is not None:
            to = max(min(scene.pressure_to * factor, STRONGEST), -VACUUM)
            return replace(last, scene=replace(scene, pressure_to=to))
        return replace(last, scene=replace(scene, volume_to=(scene.volume_to or 0.0) * factor**0.3))
    if move == "load":
        return replace(last, scene=_other_load(rng, scene))
    if move == "chambers":
        before = int(getattr(design, "chamber_count"))  # noqa: B009 (every family has one)
        count = int(np.clip(before + rng.choice([-1, 1]), *CHAMBERS))
        length = round(1e3 * design.length * count / before, 2)
        return replace(last, design=design.changed(chamber_count=count, length=length))
    names = [p for p in design.parameters() if p.kind == "length"]
    parameter = names[int(rng.integers(len(names)))]
    value = getattr(design, parameter.name) / parameter.si_per_unit
    value = round(float(value * np.exp(rng.uniform(-0.15, 0.15))), 2)
    return replace(last, design=design.changed(**{parameter.name: value}))


def _other_load(rng: np.random.Generator, scene: Scene) -> Scene:
    if scene.plate is not None:
        gap = scene.plate.gap * float(np.exp(rng.uniform(-0.3, 0.3)))
        return replace(scene, plate=Plate(gap, scene.plate.normal))
    if scene.tip_force is not None:
        x, y, z = (f * float(np.exp(rng.uniform(-0.5, 0.5))) for f in scene.tip_force)
        return replace(scene, tip_force=(x, y, z))
    return replace(scene, gravity=None if scene.gravity is not None else (0.0, 0.0, -9.81))


def collect(
    file: Path, stream: str, seed: int, seconds: float, most_cpu_s: float, most: int
) -> None:
    """Add jobs of a stream to ``file`` for so many seconds or up to ``most`` of them; those that
    stand there already are passed over. Each is stopped after ``most_cpu_s`` [s] of processor time
    and then counts as unfinished. One thread; processor seconds, for the machine may be busy."""
    there = {_name(entry) for entry in _lines([file])}
    questions = {
        "unrelated": unrelated, "sessions": sessions, "suction": partial(sessions, suction=True)
    }[stream](seed)  # fmt: skip
    noted = Noted()
    end = time.monotonic() + seconds
    for number, asked in enumerate(questions):
        if number >= most or time.monotonic() > end:
            return
        if (stream, seed, number) in there:
            continue
        _add(file, asked, {"stream": stream, "seed": seed, "number": number}, most_cpu_s, noted)


def collect_again(file: Path, seconds: float, most_cpu_s: float) -> None:
    """Run the jobs of ``file`` anew that were stopped before ``most_cpu_s`` [s], for so many
    seconds; of a job's lines the last one counts."""
    noted = Noted()
    end = time.monotonic() + seconds
    for entry in read_jobs([file]):
        if finished(entry) or entry["cpu"] > most_cpu_s or time.monotonic() > end:
            continue
        asked = Asked(
            parse_design(entry["design"]), Scene.from_document(entry["scene"]), entry["kind"],
            entry["accuracy"], entry["mesh"], entry["move"],
        )  # fmt: skip
        _add(file, asked, dict(zip(NAME, _name(entry), strict=True)), most_cpu_s, noted)


def _add(file: Path, asked: Asked, name: dict[str, Any], most_cpu_s: float, noted: "Noted") -> None:
    entry = {
        **name, "move": asked.move,
        "design": asked.design.to_document(), "scene": asked.scene.to_document(),
        "kind": asked.kind, "accuracy": asked.accuracy, "mesh": asked.mesh,
        **_answered(asked, most_cpu_s, noted),
    }  # fmt: skip
    with file.open("a") as out:
        out.write(json.dumps(entry) + "\n")
    told = f"{entry['cpu']:.1f} s, {entry['tangents']}" if "cpu" in entry else entry["refused"]
    print(name["number"], asked.design.family, asked.kind, asked.move, told, flush=True)


def _name(entry: dict[str, Any]) -> tuple[str, int, int]:
    """What tells a job from all others."""
    stream, seed, number = (entry[key] for key in NAME)
    return stream, seed, number


class Noted:
    """What a solve tells on its way: estimates of every mesh, tangents factorised by size."""

    def __init__(self) -> None:
        from actuators.mechanics.continuum import climb, linear, warm
        from actuators.mechanics.direct_solver import PardisoSolver

        warm.exercise()
        self.levels: list[dict[str, float]] = []
        self.tangents: Counter[int] = Counter()
        estimates, factorize = climb.estimates, PardisoSolver.factorize

        def noting(*given: Any, **named: Any) -> dict[str, float]:
            self.levels.append(estimates(*given, **named))
            return self.levels[-1]

        def counting(solver: PardisoSolver, values: np.ndarray) -> None:
            self.tangents[solver._size] += 1  # pyright: ignore[reportPrivateUsage]
            factorize(solver, values)

        climb.estimates = linear.estimates = noting
        setattr(PardisoSolver, "factorize", counting)  # noqa: B010 (names of arguments differ)

    def clear(self) -> None:
        """Forget the job before."""
        self.levels, self.tangents = [], Counter()


def _answered(asked: Asked, most_cpu_s: float, noted: Noted) -> dict[str, Any]:
    from actuators.mechanics import continuum

    noted.clear()
    begun = time.process_time()

    def late() -> bool:
        return time.process_time() - begun > most_cpu_s

    try:
        response = continuum.solve(
            asked.design, asked.scene, accuracy=asked.accuracy, mesh=asked.mesh, cancelled=late
        )
    except QuestionError as refusal:
        return {"refused": str(refusal)}
    return {
        "cpu": time.process_time() - begun, "outcome": response.outcome.value,
        "effects": {e.name: e.on for e in response.effects},
        "unknowns": response.unknowns, "iterations": response.newton_iterations,
        "tangents": sorted(noted.tangents.items()), "levels": noted.levels,
        "timings": {name: round(value, 3) for name, value in response.timings.items()},
        "ends_at": response.path[-1].pressure if response.path else None,
    }  # fmt: skip


def _lines(paths: Iterable[Path]) -> list[dict[str, Any]]:
    there = [path for path in paths if path.exists()]
    return [json.loads(line) for path in there for line in path.read_text().splitlines()]


def read_jobs(paths: Iterable[Path]) -> list[dict[str, Any]]:
    """Jobs of files that :func:`collect` wrote, refused ones left out; of lines of one job the
    last."""
    return list({_name(entry): entry for entry in _lines(paths) if "cpu" in entry}.values())


def finished(job: dict[str, Any]) -> bool:
    """Whether it ran to an end of its own."""
    return job["outcome"] not in ("cancelled", "budget_spent")


def past_job(job: dict[str, Any], *, all_levels: bool) -> PastJob:
    """As the ladder keeps it: errors of the mesh it ended on; with ``all_levels`` also those of the
    meshes before, which answers do not tell."""
    told = outlook(
        parse_design(job["design"]), Scene.from_document(job["scene"]),
        accuracy=job["accuracy"], mesh=job["mesh"],
    )  # fmt: skip
    estimates = job["levels"][-1] if job["levels"] else {}
    stopped = not finished(job)
    found = PastJob.of(told, job["cpu"], job["unknowns"], estimates, stopped=stopped)
    if job["mesh"] is not None or not all_levels:
        return found
    errors = {k: worst(each) for k, each in enumerate(job["levels"], start=1)}
    if stopped:
        level = min(max(errors, default=0), len(told.sizes) - 1)
        return replace(found, level=level, errors=errors)
    return replace(found, errors=errors)


def preset_jobs() -> list[tuple[dict[str, Any], PastJob]]:
    """The studies of docs/validation.md: presets of full size far into contact and to their limits,
    in processor seconds of the same kind of machine; each with what it is. Studies changed since
    are left out."""
    found: list[tuple[dict[str, Any], PastJob]] = []
    _, answers = validation_answers()
    for number, case in enumerate(all_cases()):
        answer = answers.get(case.key)
        if answer is None or answer.outcome not in ENDED:
            continue
        told = outlook(case.design, case.scene, accuracy=case.accuracy)
        document = answer.document
        if not any(0.85 < document["unknowns"] / size <= 1.0 for size in told.sizes):
            continue
        percent = document.get("error_estimate_percent")
        estimates = {} if percent is None else {"tip": percent / 100}
        entry = {
            "stream": "presets", "seed": 0, "number": number, "move": "start",
            "design": case.design.to_document(),
            "kind": "pressure" if case.scene.plate is None else "plate",
        }  # fmt: skip
        seconds = float(document["processor_s"])
        found.append((entry, PastJob.of(told, seconds, document["unknowns"], estimates)))
    return found


def worst(estimates: dict[str, float]) -> float:
    """The largest estimate that decides."""
    return max(estimates.get(name, 0.0) for name in JUDGED)


def level_errors(jobs: list[dict[str, Any]]) -> dict[bool, LevelErrors]:
    """Mean and deviation of the logarithm of the largest judged estimate, by level. A level seen in
    fewer than four jobs takes a third of the one before."""
    seen: dict[bool, list[list[float]]] = {False: [], True: []}
    for job in jobs:
        if job["mesh"] is not None:
            continue
        table = seen[mesh_sizes(parse_design(job["design"]), is_half=False).stands_apart]
        for level, estimates in enumerate(job["levels"]):
            while len(table) <= level:
                table.append([])
            table[level].append(float(np.log(max(worst(estimates), SMALLEST_ERROR))))
    return {apart: _summary(table) for apart, table in seen.items()}


def _summary(table: list[list[float]]) -> LevelErrors:
    mean, deviation = [float(np.log(0.08))], [0.6]
    for level in range(4):
        values = table[level] if level < len(table) else []
        if len(values) >= 4:
            found, spread = float(np.mean(values)), float(np.std(values, ddof=1))
        else:
            found, spread = mean[-1] - float(np.log(3.0)), deviation[-1]
        mean.append(round(found, 3))
        deviation.append(round(max(spread, 0.2), 3))
    return LevelErrors(tuple(mean[1:]), tuple(deviation[1:]))
