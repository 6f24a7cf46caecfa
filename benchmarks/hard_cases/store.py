"""What came out of every case, kept in docs/hard_cases_data.json beside the page."""

import json
from pathlib import Path
from typing import Any

from actuators.hard_cases import Case, Result, read_cases

DATA = Path("docs/hard_cases_data.json")


def load() -> dict[str, dict[str, Any]]:
    """Stored results by the case's title."""
    return json.loads(DATA.read_text()) if DATA.exists() else {}


def keep(result: Result) -> None:
    """Put one result into the store; cases that are no more leave it."""
    known = {case.title for case in read_cases()}
    stored = {title: found for title, found in load().items() if title in known}
    stored[result.case.title] = result.to_document()
    ordered = {case.title: stored[case.title] for case in read_cases() if case.title in stored}
    DATA.write_text(json.dumps(ordered, indent=1, ensure_ascii=False) + "\n")


def lacking(cases: list[Case]) -> list[Case]:
    """Cases without a stored result as it must be."""
    stored = load()
    return [case for case in cases if not stored.get(case.title, {}).get("passed")]
