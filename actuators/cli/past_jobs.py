"""What the command line remembers of its own finite-element jobs: how long each took.

One line of JSON per job in ``past_jobs.jsonl`` of the data folder. It never leaves this machine,
and may be deleted: predictions then start from the package's record again.
"""

import json
import math
from pathlib import Path
from typing import Any

import click
import numpy as np

from actuators.design import Design
from actuators.mechanics.ladder import FEATURES, CostModel, Rung, Timings, cost_record, features
from actuators.mechanics.ladder.cost import MOST_JOBS
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.scene import Scene
from actuators.places import data_folder

VERSION = 1
"""Of what the features mean; lines of another version are not read."""
NOT_TIMED = (Outcome.CANCELLED, Outcome.BUDGET_SPENT)


def past_jobs_file() -> Path:
    """Where the jobs are remembered."""
    return data_folder() / "past_jobs.jsonl"


LOADING_S = 5.0
"""The first solve of a process also reads compiled kernels; shorter ones would tell mostly that."""


def remember(
    response: Response, rung: Rung, *, cpu_s: float = math.inf, is_first: bool = False
) -> None:
    """Add a finished job. ``cpu_s``: processor seconds [s] it took, which count where they are
    fewer: a machine busy with other work is not slow. ``is_first``: its process had not loaded the
    solver before. A folder that
    cannot be written to costs the memory, not the answer."""
    if response.outcome in NOT_TIMED or response.wall_s <= (LOADING_S if is_first else 0.0):
        return
    row = _features(response.design, response.scene, rung)
    entry = {
        "version": VERSION,
        "seconds": min(response.wall_s, cpu_s),
        "features": dict(zip(FEATURES, row.tolist(), strict=True)),
    }
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
    record = cost_record()
    return CostModel(record.timings, Timings.of(_read(past_jobs_file())), record.spread)


def _features(design: Design, scene: Scene, rung: Rung) -> np.ndarray:
    errors = cost_record().level_errors
    return features(design, scene, accuracy=rung.accuracy, mesh=rung.mesh, errors=errors)


def _read(file: Path) -> list[tuple[np.ndarray, float]]:
    """Jobs of the file; lines that are damaged or of another version are passed over."""
    if not file.exists():
        return []
    try:
        lines = file.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        click.echo(f"{file} cannot be read ({error}); times are predicted without it.", err=True)
        return []
    return [job for line in lines if (job := _job(line)) is not None]


def _job(line: str) -> tuple[np.ndarray, float] | None:
    try:
        entry: Any = json.loads(line)
        if entry["version"] != VERSION:
            return None
        row = np.array([float(entry["features"][name]) for name in FEATURES])
        seconds = float(entry["seconds"])
    except (ValueError, KeyError, TypeError):
        return None
    return (row, seconds) if np.isfinite(row).all() else None
