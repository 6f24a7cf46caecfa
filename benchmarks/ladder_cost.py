"""How well the ladder predicts seconds: jobs on random designs of all families, in random scenes.

    python -m benchmarks.ladder_cost collect FILE --stream unrelated --seed 5 --seconds 240
    python -m benchmarks.ladder_cost collect FILE --stream sessions --seed 5 --seconds 240
    python -m benchmarks.ladder_cost record FILE...            # writes the package's record
    python -m benchmarks.ladder_cost judge FILE... --unseen FILE...

``judge`` makes a record of the first files and plays the unseen jobs, in many random orders, to a
new machine that is slower or faster by a factor drawn from 1/3 to 3: how many predictions are
within a factor of 1.5 of what the job then takes, for the 1st, for the 2nd to 10th, and from the
11th job on."""

import os

os.environ["NUMBA_NUM_THREADS"] = "1"
os.environ["MKL_NUM_THREADS"] = "1"
os.environ["OMP_NUM_THREADS"] = "1"

import argparse
import json
from collections.abc import Sequence
from dataclasses import asdict, replace
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import minimize

from actuators.mechanics.ladder import record as record_module
from actuators.mechanics.ladder.cost import CostModel, Spread, Timings
from actuators.mechanics.ladder.question import FEATURES, LevelErrors
from benchmarks.ladder_jobs import collect, finished, job_features, level_errors, read_jobs

RECORD = Path(record_module.__file__).parent / record_module.FILE
ORDERS = 20
FEW = 100
"""Below so many jobs the spreads are the ones that :class:`Spread` has, not fitted."""
FACTOR = 1.5
STAGES = ((0, 1, "first job"), (1, 10, "2nd to 10th"), (10, 10**6, "from the 11th on"))


def fit_spread(timings: Timings) -> Spread:
    """Spreads under which the timings are most likely; the usual ones for fewer than FEW jobs."""
    if len(timings.seconds) < FEW:
        return Spread()
    names = ("weight", "memory", "reach", "peculiar")

    def spread(logs: np.ndarray) -> Spread:
        values = np.exp(np.clip(logs, -3.5, 1.5))
        return replace(Spread(), **dict(zip(names, values.tolist(), strict=True)))

    start = np.log([getattr(Spread(), name) for name in names])
    found = minimize(
        lambda logs: -CostModel(timings, Timings.of([]), spread(logs)).log_likelihood(),
        start, method="Nelder-Mead", options={"maxiter": 200, "xatol": 0.05, "fatol": 0.05},
    )  # fmt: skip
    return spread(found.x)


def table_of(jobs: list[dict[str, Any]], errors: dict[bool, LevelErrors]) -> Timings:
    """Features and processor seconds of the jobs that came to an end."""
    return Timings.of([(job_features(job, errors), job["cpu"]) for job in jobs if finished(job)])


def write_record(files: Sequence[Path]) -> None:
    """The package's record, from all jobs of ``files``."""
    jobs = read_jobs(files)
    errors = level_errors(jobs)
    timings = table_of(jobs, errors)
    spread = fit_spread(timings)
    names = {False: "massive", True: "stands_apart"}
    document = {
        "source": f"{len(timings.seconds)} jobs on random designs of all families, {date.today()}, "
        "processor seconds of one thread on a virtual machine with 2 cores; "
        "python -m benchmarks.ladder_cost",
        "features": list(FEATURES),
        "spread": {name: round(value, 4) for name, value in asdict(spread).items()},
        "level_errors": {names[apart]: asdict(found) for apart, found in errors.items()},
        "jobs": [
            [round(x, 4) for x in [*row, seconds]]
            for row, seconds in zip(timings.features, timings.seconds, strict=True)
        ],
    }
    text = json.dumps(document, indent=1)
    RECORD.write_text(_rows_on_lines(text) + "\n")
    print(f"{RECORD}: {len(timings.seconds)} jobs, {spread}")


def _rows_on_lines(text: str) -> str:
    """Lists of numbers on one line each."""
    lines: list[str] = []
    inside = False
    for line in text.split("\n"):
        bare = line.strip()
        if inside:
            lines[-1] += bare if bare.startswith("]") else bare + (" " if bare != "" else "")
            inside = not bare.startswith("]")
            continue
        lines.append(line)
        inside = bare.endswith("[") and bare in ("[", '"mean": [', '"deviation": [')
    return "\n".join(line.replace(" ]", "]") for line in lines)


def judge(files: Sequence[Path], unseen: Sequence[Path]) -> None:
    """Print how far predictions were off."""
    known, new = read_jobs(files), read_jobs(unseen)
    errors = level_errors(known)
    record = table_of(known, errors)
    spread = fit_spread(record)
    asked = [job for job in new if finished(job)]
    table = table_of(new, errors)
    rng = np.random.default_rng(1)
    off: list[list[tuple[int, float, str, str]]] = []
    for _ in range(ORDERS):
        order, pace = rng.permutation(len(asked)), float(np.exp(rng.uniform(-1, 1) * np.log(3)))
        seen: list[tuple[np.ndarray, float]] = []
        rows: list[tuple[int, float, str, str]] = []
        for count, index in enumerate(order.tolist()):
            model = CostModel(record, Timings.of(seen), spread)
            took = pace * float(table.seconds[index])
            ratio = model.predict(table.features[index]).seconds / took
            job = asked[index]
            rows.append((count, ratio, job["design"]["family"], job["kind"]))
            seen.append((table.features[index], took))
        off.append(rows)
    _print(off, len(known), len(new), len(asked))


def _print(off: list[list[tuple[int, float, str, str]]], known: int, new: int, asked: int) -> None:
    every = [row for rows in off for row in rows]
    print(f"record of {known} jobs; {new} unseen, {asked} of them to an end; {ORDERS} orders")
    print(
        "\n| predictions | within 1.5 | within 2 | median factor off |\n| --- | --- | --- | --- |"
    )
    for low, high, name in STAGES:
        _line(name, [ratio for count, ratio, _, _ in every if low <= count < high])
    late = [row for row in every if row[0] >= 10]
    for column in (2, 3):
        for name in sorted({row[column] for row in late}):
            _line(f"{name}, from the 11th on", [row[1] for row in late if row[column] == name])


def _line(name: str, ratios: list[float]) -> None:
    away = np.exp(np.abs(np.log(ratios)))
    print(f"| {name} | {100 * np.mean(away <= FACTOR):.0f} % | {100 * np.mean(away <= 2):.0f} % "
          f"| {np.median(away):.2f} |")  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("what", choices=("collect", "record", "judge"))
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("--unseen", nargs="+", type=Path, default=[])
    parser.add_argument("--seed", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=1800.0)
    parser.add_argument("--most-cpu", type=float, default=15.0)
    parser.add_argument("--stream", choices=("unrelated", "sessions"), default="unrelated")
    parser.add_argument("--most", type=int, default=10**6)
    asked = parser.parse_args()
    if asked.what == "collect":
        collect(asked.files[0], asked.stream, asked.seed, asked.seconds, asked.most_cpu, asked.most)
    elif asked.what == "record":
        write_record(asked.files)
    else:
        judge(asked.files, asked.unseen)


if __name__ == "__main__":
    main()
