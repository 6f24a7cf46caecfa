"""Timed finite-element jobs on random questions, one line of JSON each: what predictions of time
are made from and judged by."""

import json
import time
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from actuators.design import parse_design
from actuators.errors import QuestionError
from actuators.mechanics.ladder.question import (
    FEATURES,
    LevelErrors,
    features,
    mesh_sizes,
)
from actuators.mechanics.scene import Scene
from benchmarks.random_questions import random_questions

ACCURACIES = (0.3, 0.3, 0.2, 0.1, 0.1, 0.05, 0.02)
SHARE_OF_MESHES = 0.2
"""Part of the jobs that name the coarsest mesh instead."""
JUDGED = ("tip", "angle", "force", "limit_pressure")


def collect(seed: int, seconds: float, most_cpu_s: float, file: Path) -> None:
    """Add jobs to ``file`` for so many seconds; each is stopped after ``most_cpu_s`` [s] of
    processor time and then counts as unfinished. One thread; processor seconds, for the machine may
    be busy."""
    from actuators.mechanics import continuum
    from actuators.mechanics.continuum import climb, linear, warm

    warm.exercise()
    levels: list[dict[str, float]] = []
    own_estimates = climb.estimates

    def noting(last: dict[str, float], layers: tuple[int, int, int]) -> dict[str, float]:
        levels.append(own_estimates(last, layers))
        return levels[-1]

    climb.estimates = linear.estimates = noting
    rng = np.random.default_rng(seed + 1000)
    end = time.monotonic() + seconds
    with file.open("a") as out:
        for question in random_questions(seed, (1, 3)):
            if time.monotonic() > end:
                return
            accuracy = float(rng.choice(ACCURACIES))
            mesh = "coarse" if rng.random() < SHARE_OF_MESHES else None
            levels.clear()
            begun = time.process_time()

            def late(begun: float = begun) -> bool:
                return time.process_time() - begun > most_cpu_s

            try:
                response = continuum.solve(
                    question.design, question.scene, accuracy=accuracy, mesh=mesh, cancelled=late
                )
            except QuestionError as refusal:
                print(refusal)
                continue
            entry = {
                "design": question.design.to_document(), "scene": question.scene.to_document(),
                "kind": question.kind, "accuracy": accuracy, "mesh": mesh,
                "cpu": time.process_time() - begun, "outcome": response.outcome.value,
                "effects": {e.name: e.on for e in response.effects},
                "unknowns": response.unknowns, "iterations": response.newton_iterations,
                "levels": levels,
            }  # fmt: skip
            out.write(json.dumps(entry) + "\n")
            out.flush()
            print(question.design.family, question.kind, f"{entry['cpu']:.1f} s", flush=True)


def read_jobs(paths: Iterable[Path]) -> list[dict[str, Any]]:
    """Jobs of files that :func:`collect` wrote."""
    lines = [line for path in paths for line in path.read_text().splitlines()]
    return [entry for line in lines if "cpu" in (entry := json.loads(line))]


def finished(job: dict[str, Any]) -> bool:
    """Whether it ran to an end of its own."""
    return job["outcome"] not in ("cancelled", "budget_spent")


def job_features(job: dict[str, Any], errors: dict[bool, LevelErrors]) -> np.ndarray:
    """As the ladder computes them, (f,)."""
    row = features(
        parse_design(job["design"]), Scene.from_document(job["scene"]),
        accuracy=job["accuracy"], mesh=job["mesh"], errors=errors,
    )  # fmt: skip
    assert len(row) == len(FEATURES)
    return row


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
            worst = max(estimates.get(name, 0.0) for name in JUDGED)
            table[level].append(float(np.log(max(worst, 1e-4))))
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
