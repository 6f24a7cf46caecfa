"""Hard cases: designs and scenes in corners that no paper visited, as data, and what runs them.

``catalogue/*.toml`` holds the cases, one file per topic; :mod:`case` says what an entry means.
"""

from actuators.hard_cases.case import Case, Check
from actuators.hard_cases.entries import CATALOGUE_FOLDER, read_cases, selected
from actuators.hard_cases.run import Result, run_case

__all__ = [
    "CATALOGUE_FOLDER", "Case", "Check", "Result", "read_cases", "run_case", "selected",
]  # fmt: skip
