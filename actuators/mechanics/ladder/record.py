"""The package's own record: jobs that were timed once, so that a new machine can predict its first.

``cost_record.json`` is written by ``python -m benchmarks.ladder_cost record``; it says where and
how it was measured.
"""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from importlib.resources import files
from typing import Any

import numpy as np

from actuators.mechanics.ladder.cost import CostModel, Known
from actuators.mechanics.ladder.past import PastJob, Spread
from actuators.mechanics.ladder.question import FEATURES, LevelErrors, Outlook, work_by_level

FILE = "cost_record.json"
_LINEAR = FEATURES.index("linear")


@dataclass(frozen=True, eq=False)
class CostRecord:
    """``jobs`` of the machine it was made on, ``spread`` fitted to them, ``level_errors`` of
    massive bodies (False) and of those whose chambers stand apart (True)."""

    jobs: tuple[PastJob, ...]
    spread: Spread
    level_errors: Mapping[bool, LevelErrors]
    source: str

    @cached_property
    def known(self) -> Known:
        """What it says, worked out once."""
        return Known(self.jobs, self.level_errors, self.spread)

    def model(self, own: Sequence[PastJob]) -> CostModel:
        """Prediction from this record and a machine's ``own`` jobs."""
        return CostModel(self.known, own)


@cache
def cost_record() -> CostRecord:
    """The record as shipped."""
    return read_record(
        json.loads((files("actuators.mechanics.ladder") / FILE).read_text(encoding="utf-8"))
    )


def read_record(document: Mapping[str, Any]) -> CostRecord:
    """A record from its document; raises ValueError for one of other features."""
    if tuple(document["features"]) != FEATURES:
        raise ValueError(
            f"{FILE} holds other features than this version's. Write it again: "
            "python -m benchmarks.ladder_cost record"
        )
    return CostRecord(
        tuple(job_of_document(entry) for entry in document["jobs"]),
        Spread(**document["spread"]),
        {
            apart: LevelErrors(tuple(entry["mean"]), tuple(entry["deviation"]))
            for apart, entry in (
                (False, document["level_errors"]["massive"]),
                (True, document["level_errors"]["stands_apart"]),
            )
        },
        document["source"],
    )


def job_document(job: PastJob) -> dict[str, Any]:
    """A job as it is kept: in the record, and by the command line on its machine."""
    told = job.outlook
    return {
        "features": [round(x, 4) for x in told.features.tolist()],
        "sizes": list(told.sizes),
        "accuracy": told.accuracy,
        "stands_apart": told.stands_apart,
        "seconds": round(job.seconds, 4),
        "level": job.level,
        "errors": {str(level): float(f"{error:.3g}") for level, error in job.errors.items()},
        **({"stopped": True} if job.stopped else {}),
    }


def job_of_document(entry: Mapping[str, Any]) -> PastJob:
    """Raises KeyError, TypeError or ValueError for what is no job of these features."""
    features = np.array([float(x) for x in entry["features"]])
    sizes = tuple(int(n) for n in entry["sizes"])
    level, seconds = int(entry["level"]), float(entry["seconds"])
    if features.shape != (len(FEATURES),) or not np.isfinite(features).all():
        raise ValueError("other features")
    if not 0 <= level < len(sizes) or min(sizes) <= 0 or not 0.0 < seconds < math.inf:
        raise ValueError("no job")
    work = work_by_level(sizes, linear=bool(features[_LINEAR]))
    accuracy = entry["accuracy"]
    return PastJob(
        Outlook(
            features, sizes, tuple(math.log(w) for w in work),
            None if accuracy is None else float(accuracy), bool(entry["stands_apart"]),
        ),
        seconds, level, {int(k): float(e) for k, e in entry["errors"].items()},
        stopped=bool(entry.get("stopped", False)),
    )  # fmt: skip
