"""How well the ladder predicts seconds.

    python -m benchmarks.ladder_cost collect FILE --stream sessions --seed 5 --seconds 240
    python -m benchmarks.ladder_cost collect FILE --stream unrelated --seed 5 --seconds 240
    python -m benchmarks.ladder_cost collect FILE --stream suction --seed 5 --seconds 240
    python -m benchmarks.ladder_cost again FILE --most-cpu 80  # those stopped before
    python -m benchmarks.ladder_cost judge FILE...
    python -m benchmarks.ladder_cost record FILE...            # writes the package's record

``collect`` adds timed jobs to a file: of designers' sessions, where each question is a small change
of the one before, with inflation or with suction, or of unrelated ones
(``benchmarks/ladder_jobs.py``); it can be stopped and begun again. ``judge`` makes a record of two
thirds of the sessions and unrelated jobs and plays the rest, in many random orders, to a new
machine that is slower or faster by a factor drawn from 1/3 to 3, for each third in turn: how many
predictions are within a factor of 1.5 of what the job then takes, for the 1st, for the 2nd to 10th,
and from the 11th job on, and of jobs that were stopped how many were told to take at least so long;
it draws these into docs/pictures (needs matplotlib)."""

import os

os.environ["NUMBA_NUM_THREADS"] = "1"
os.environ["MKL_NUM_THREADS"] = "1"
os.environ["OMP_NUM_THREADS"] = "1"

import argparse
import json
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import minimize

from actuators.mechanics.ladder import record as record_module
from actuators.mechanics.ladder.cost import CostModel, Known
from actuators.mechanics.ladder.past import PastJob, Spread
from actuators.mechanics.ladder.question import FEATURES, LevelErrors
from actuators.mechanics.ladder.record import job_document
from benchmarks.ladder_jobs import (
    SESSION,
    STREAMS,
    collect,
    collect_again,
    level_errors,
    past_job,
    preset_jobs,
    read_jobs,
)

PICTURE = Path(__file__).parent.parent / "docs" / "pictures" / "predicted_seconds.png"
RECORD = Path(record_module.__file__).parent / record_module.FILE
ORDERS, FOLDS = 12, 3
FEW = 100
"""Below so many jobs the spreads are the ones that :class:`Spread` has, not fitted."""
FITTED = ("weight", "memory", "reach", "peculiar", "noise")
FACTOR = 1.5
STAGES = ((0, 1, "first job"), (1, 10, "2nd to 10th"), (10, 10**6, "from the 11th on"))


@dataclass(frozen=True, eq=False)
class Timed:
    """A job as collected; ``full`` and ``told``: as the package's record and as a machine remember
    it."""

    entry: dict[str, Any]
    full: PastJob
    told: PastJob

    @property
    def group(self) -> tuple[str, int, int]:
        """Jobs that are played together: one session, or one unrelated job."""
        stream, number = self.entry["stream"], self.entry["number"]
        return stream, self.entry["seed"], number // (1 if stream == "unrelated" else SESSION)


@dataclass(frozen=True)
class Row:
    """One prediction: how many jobs the machine had run before, the true seconds (on the record's
    machine), predicted over true ones, whether those lay in the range."""

    before: int
    seconds: float
    ratio: float
    held: bool
    stopped: bool
    job: dict[str, Any]


def read(files: Sequence[Path]) -> list[Timed]:
    """All jobs of the files, and the presets of docs/validation.md."""
    jobs = read_jobs(files)
    full = [past_job(job, all_levels=True) for job in jobs]
    told = [past_job(job, all_levels=False) for job in jobs]
    collected = [Timed(*each) for each in zip(jobs, full, told, strict=True)]
    return [*collected, *(Timed(entry, job, job) for entry, job in preset_jobs())]


def fit_spread(jobs: Sequence[PastJob], levels: dict[bool, LevelErrors]) -> Spread:
    """Spreads under which the seconds of the jobs that ended are most likely; the usual ones for
    fewer than FEW."""
    jobs = [job for job in jobs if not job.stopped]
    if len(jobs) < FEW:
        return Spread()

    def spread(logs: np.ndarray) -> Spread:
        values = np.exp(np.clip(logs, -3.5, 1.5))
        return replace(Spread(), **dict(zip(FITTED, values.tolist(), strict=True)))

    start = np.log([getattr(Spread(), name) for name in FITTED])
    about = np.vstack([start, start + 0.5 * np.eye(len(start))])
    found = minimize(
        lambda logs: -Known(jobs, levels, spread(logs)).log_likelihood(),
        start, method="Nelder-Mead",
        options={"maxiter": 250, "xatol": 0.05, "fatol": 0.05, "initial_simplex": about},
    )  # fmt: skip
    return spread(found.x)


def write_record(files: Sequence[Path]) -> None:
    """The package's record, from all jobs of ``files``."""
    jobs = read(files)
    levels = level_errors([job.entry for job in jobs if job.group[0] != "presets"])
    known = [job.full for job in jobs]
    count = Counter(job.group[0] for job in jobs)
    spread = fit_spread(known, levels)
    names = {False: "massive", True: "stands_apart"}
    head = {
        "source": f"{count['sessions']} jobs of designers' sessions and {count['unrelated']} "
        f"unrelated ones on random designs of all families, {count['suction']} of sessions with "
        f"suction, {date.today()}, "
        f"and {count['presets']} presets of docs/validation.md; "
        "processor seconds of one thread on a virtual machine with 2 cores; "
        "python -m benchmarks.ladder_cost",
        "features": list(FEATURES),
        "spread": {name: round(value, 4) for name, value in asdict(spread).items()},
        "level_errors": {names[apart]: asdict(found) for apart, found in levels.items()},
    }
    lines = [json.dumps(job_document(job)) for job in known]
    top = ",\n ".join(f"{json.dumps(key)}: {json.dumps(value)}" for key, value in head.items())
    RECORD.write_text("{\n " + top + ',\n "jobs": [\n  ' + ",\n  ".join(lines) + "\n ]\n}\n")
    print(f"{RECORD}: {len(jobs)} jobs, {spread}")


def judge(files: Sequence[Path]) -> None:
    """Print how far predictions were off."""
    jobs = read(files)
    rows: dict[str, list[Row]] = {stream: [] for stream in (*STREAMS, "presets")}
    rng = np.random.default_rng(1)
    groups = sorted({job.group for job in jobs})
    fold_of = {group: k % FOLDS for k, group in enumerate(rng.permutation(len(groups)).tolist())}
    fold = {group: fold_of[k] for k, group in enumerate(groups)}
    for turn in range(FOLDS):
        known = [job for job in jobs if fold[job.group] != turn]
        levels = level_errors([job.entry for job in known if job.group[0] != "presets"])
        record = [job.full for job in known]
        of_record = Known(record, levels, fit_spread(record, levels))
        for stream, found in rows.items():
            unseen = [job for job in jobs if fold[job.group] == turn and job.group[0] == stream]
            for _ in range(ORDERS):
                found += play(unseen, of_record, rng)
    for stream, found in rows.items():
        count = sum(job.group[0] == stream for job in jobs)
        if not count:
            continue
        print(f"\n{stream}: {count} jobs")
        _print(found)
    draw({stream: found for stream, found in rows.items() if found})


def draw(streams: dict[str, list[Row]]) -> None:
    """Predicted over true seconds from the 11th job on, into docs/pictures."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    size = {"figsize": (3.6 * len(streams), 4), "layout": "constrained"}
    figure, axes = pyplot.subplots(1, len(streams), sharey=True, **size)
    ends = np.array([0.1, 1000.0])
    for axis, (stream, rows) in zip(axes, streams.items(), strict=True):
        late = [row for row in rows if row.before >= STAGES[-1][0] and not row.stopped]
        true = np.array([row.seconds for row in late])
        axis.fill_between(ends, ends / FACTOR, ends * FACTOR, color="0.88")
        axis.plot(ends, ends, color="0.6", linewidth=0.8)
        axis.plot(true, true * [row.ratio for row in late], ".", alpha=0.25, markeredgewidth=0)
        within = np.mean([abs(np.log(row.ratio)) <= np.log(FACTOR) for row in late])
        axis.set(xscale="log", yscale="log", xlim=ends, ylim=ends, xlabel="true seconds",
                 title=f"{stream}: {100 * within:.0f} % within {FACTOR:g}")  # fmt: skip
    axes[0].set_ylabel("predicted seconds")
    figure.savefig(PICTURE, dpi=80)


def play(jobs: Sequence[Timed], known: Known, rng: np.random.Generator) -> list[Row]:
    """Jobs one after another on a new machine, groups in random order."""
    groups = sorted({job.group for job in jobs})
    pace = float(np.exp(rng.uniform(-1, 1) * np.log(3)))
    seen: list[PastJob] = []
    rows: list[Row] = []
    for index in rng.permutation(len(groups)).tolist():
        for job in (job for job in jobs if job.group == groups[index]):
            took = replace(job.told, seconds=pace * job.told.seconds)
            found = CostModel(known, seen).predict(took.outlook)
            held = found.low <= took.seconds <= found.high
            ratio = found.seconds / took.seconds
            stopped = job.told.stopped
            rows.append(Row(len(seen), job.told.seconds, ratio, held, stopped, job.entry))
            seen.append(took)
    return rows


def _print(everyone: list[Row]) -> None:
    rows = [row for row in everyone if not row.stopped]
    print(
        "\n| predictions | within 1.5 | within 2 | median factor off | in the range |"
        "\n| --- | --- | --- | --- | --- |"
    )
    for low, high, name in STAGES:
        _line(name, [row for row in rows if low <= row.before < high])
    late = [row for row in rows if row.before >= 10]
    kinds: tuple[Callable[[Row], str], ...] = (
        lambda row: row.job["design"]["family"],
        lambda row: row.job["kind"],
        lambda row: row.job["move"],
    )
    for kind in kinds:
        for name in sorted({kind(row) for row in late} - {"start"}):
            _line(f"of these: {name}", [row for row in late if kind(row) == name])
    stopped = [row for row in everyone if row.stopped and row.before >= 10]
    if stopped:
        longer = np.mean([row.ratio > 1 / FACTOR for row in stopped])
        print(f"\nOf those stopped {100 * longer:.0f} % were told to take at least so long")


def _line(name: str, rows: Sequence[Row]) -> None:
    if not rows:
        return
    away = np.exp(np.abs(np.log([row.ratio for row in rows])))
    shares = [away <= FACTOR, away <= 2, [row.held for row in rows]]
    within, twice, held = (f"{100 * np.mean(share):.0f} %" for share in shares)
    print(f"| {name} | {within} | {twice} | {np.median(away):.2f} | {held} |")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("what", choices=("collect", "again", "record", "judge"))
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("--stream", choices=STREAMS, default="unrelated")
    parser.add_argument("--seed", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=1800.0)
    parser.add_argument("--most", type=int, default=10**6)
    parser.add_argument("--most-cpu", type=float, default=15.0)
    asked = parser.parse_args()
    if asked.what == "collect":
        collect(asked.files[0], asked.stream, asked.seed, asked.seconds, asked.most_cpu, asked.most)
    elif asked.what == "again":
        collect_again(asked.files[0], asked.seconds, asked.most_cpu)
    elif asked.what == "record":
        write_record(asked.files)
    else:
        judge(asked.files)


if __name__ == "__main__":
    main()
