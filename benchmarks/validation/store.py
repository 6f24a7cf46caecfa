"""Answers kept one file a case, so that an interrupted study goes on where it stopped."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from benchmarks.validation.case import Case

FOLDER = Path(".cache/validation")


def kept(case: Case, folder: Path = FOLDER) -> dict[str, Any] | None:
    """The answer to exactly this question, or None."""
    path = folder / f"{case.key}.json"
    if not path.exists():
        return None
    document = json.loads(path.read_text())
    return document if document["question"] == case.question else None


def compute(cases: Iterable[Case], *, fresh: bool = False, folder: Path = FOLDER) -> None:
    """Solve the cases that have no answer yet."""
    folder.mkdir(parents=True, exist_ok=True)
    for case in cases:
        if not fresh and kept(case, folder) is not None:
            continue
        document = case.answer()
        (folder / f"{case.key}.json").write_text(json.dumps(document, indent=1))
        print(f"{case.key}: {document['outcome']}, {document['processor_s']:.0f} s", flush=True)
