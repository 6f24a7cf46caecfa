"""What the command line remembers of its own finite-element jobs: how long each took.

One line of JSON per job in ``past_jobs.jsonl`` of the data folder. It never leaves this machine,
and may be deleted: predictions then start from the package's record again.
"""

import json
from pathlib import Path
from typing import Any

import click

from actuators.cli.ladder_table import jobs_in_words
from actuators.design import Design
from actuators.errors import InputError
from actuators.mechanics.ladder import (
    CostModel,
    PastJob,
    Rung,
    cost_record,
    expected_time,
    job_document,
    job_of_document,
    outlook,
)
from actuators.mechanics.ladder.cost import MOST_JOBS
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.scene import Scene
from actuators.places import data_folder
from actuators.quantities import two_digits

VERSION = 3
"""Of what the features mean; lines of another version are not read."""
STOPPED = (Outcome.CANCELLED, Outcome.BUDGET_SPENT)


def past_jobs_file() -> Path:
    """Where the jobs are remembered."""
    return data_folder() / "past_jobs.jsonl"


LOADING_S = 1.0
"""The first solve of a process also reads compiled kernels, most of them while it is set up (1 s of
the processor; 0.01 s later on). What is left of a shorter one would still tell mostly that."""


def remember(response: Response, rung: Rung, *, is_first: bool = False) -> None:
    """Add a job: its seconds on the clock or, where they are fewer, of the processor, for a machine
    busy with other work is not slow; where it was stopped, that it takes longer than so.
    ``is_first``: its process had not loaded the solver before; its setting up is left out. A folder
    that cannot be written to costs the memory, not the answer."""
    seconds = response.wall_s if response.cpu_s is None else min(response.wall_s, response.cpu_s)
    if is_first and response.wall_s > 0.0:
        seconds *= 1.0 - response.timings.get("set_up", 0.0) / response.wall_s
    if seconds <= (LOADING_S if is_first else 0.0):
        return
    told = outlook(response.design, response.scene, accuracy=rung.accuracy, mesh=rung.mesh)
    job = PastJob.of(
        told, seconds, response.unknowns, response.error_estimates,
        stopped=response.outcome in STOPPED,
    )  # fmt: skip
    entry = {"version": VERSION, **job_document(job)}
    file = past_jobs_file()
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        lines = file.read_text(encoding="utf-8").splitlines() if file.exists() else []
        lines = [*lines, json.dumps(entry)][-2 * MOST_JOBS :]
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        click.echo(f"How long this took could not be remembered in {file}: {error}.", err=True)


def cost_model() -> CostModel:
    """Prediction of seconds from the package's record and this user's past jobs."""
    return cost_record().model(_read(past_jobs_file()))


def tell_expected(design: Design, scene: Scene, rung: Rung) -> None:
    """On standard error, how long finite elements will take; nothing of a question that the solver
    is going to refuse."""
    try:
        expected = expected_time(design, scene, rung, cost_model())
    except InputError:
        return
    seconds, low, high = map(two_digits, (expected.seconds, expected.low, expected.high))
    click.echo(
        f"Expected to take {seconds} s (four of five such jobs: {low} to {high} s), from "
        f"{jobs_in_words(expected.learned_from)} and the package's record.",
        err=True,
    )


def _read(file: Path) -> list[PastJob]:
    """Jobs of the file; lines that are damaged or of another version are passed over."""
    if not file.exists():
        return []
    try:
        lines = file.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        click.echo(f"{file} cannot be read ({error}); times are predicted without it.", err=True)
        return []
    return [job for line in lines if (job := _job(line)) is not None]


def _job(line: str) -> PastJob | None:
    try:
        entry: Any = json.loads(line)
        return job_of_document(entry) if entry["version"] == VERSION else None
    except (AttributeError, ValueError, KeyError, TypeError):
        return None
