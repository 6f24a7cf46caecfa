"""The package's own record: jobs that were timed once, so that a new machine can predict its first.

``cost_record.json`` is written by ``python -m benchmarks.ladder_cost --record``; it says where and
how it was measured.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np

from actuators.mechanics.ladder.cost import Spread, Timings
from actuators.mechanics.ladder.question import FEATURES, LevelErrors

FILE = "cost_record.json"


@dataclass(frozen=True, eq=False)
class CostRecord:
    """``timings`` of the machine it was made on, ``spread`` fitted to them, ``level_errors`` of
    massive bodies (False) and of those whose chambers stand apart (True)."""

    timings: Timings
    spread: Spread
    level_errors: Mapping[bool, LevelErrors]
    source: str


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
            "python -m benchmarks.ladder_cost --record"
        )
    rows = np.array(document["jobs"], dtype=float).reshape(-1, len(FEATURES) + 1)
    return CostRecord(
        Timings(rows[:, :-1], rows[:, -1]),
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
