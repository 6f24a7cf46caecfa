"""The ladder: for one design in one scene, what every rung costs in seconds and how far off it is.

Nothing here solves in three dimensions, and nothing here reads or writes what a user has: answers
and timings are handed in.
"""

from actuators.mechanics.ladder.answer import Answer, Difference, difference
from actuators.mechanics.ladder.build import Ladder, ask_instant, build_ladder, expected_time
from actuators.mechanics.ladder.choice import (
    Choice,
    Limit,
    as_it_went,
    at_most_error,
    at_most_seconds,
)
from actuators.mechanics.ladder.cost import CostModel, Known, TimeEstimate
from actuators.mechanics.ladder.past import PastJob
from actuators.mechanics.ladder.points import Point, Span, Typical
from actuators.mechanics.ladder.question import FEATURES, Outlook, outlook
from actuators.mechanics.ladder.record import cost_record, job_document, job_of_document
from actuators.mechanics.ladder.rungs import Rung, ladder_rungs, read_rung
from actuators.mechanics.ladder.typical import typical_at, typical_error

__all__ = [
    "FEATURES", "Answer", "Choice", "CostModel", "Difference", "Known", "Ladder", "Limit",
    "Outlook", "PastJob", "Point", "Rung", "Span", "TimeEstimate", "Typical", "as_it_went",
    "ask_instant",
    "at_most_error", "at_most_seconds", "build_ladder", "cost_record", "difference",
    "expected_time", "job_document", "job_of_document", "ladder_rungs", "outlook", "read_rung",
    "typical_at", "typical_error",
]  # fmt: skip
