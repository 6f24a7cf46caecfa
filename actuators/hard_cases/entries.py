"""Reading the catalogue: TOML to cases, one per rung, closed to entries that mean nothing."""

import fnmatch
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any, cast

from actuators.errors import QuestionError
from actuators.hard_cases.case import Budget, Case, Check, Scaling, Variation
from actuators.mechanics.response import Outcome

CATALOGUE_FOLDER = Path(__file__).parent / "catalogue"
Table = Mapping[str, Any]


def read_cases(folder: Path = CATALOGUE_FOLDER) -> tuple[Case, ...]:
    """Every case of every file, one per rung. Raises ValueError for an entry that means nothing."""
    cases: list[Case] = []
    for path in sorted(folder.glob("*.toml")):
        document = tomllib.loads(path.read_text(encoding="utf-8"))
        defaults: Table = document.pop("defaults", {})
        entries: list[Table] = document.pop("case", [])
        if document:
            raise ValueError(f"{path.name}: {sorted(document)} is neither case nor defaults")
        for entry in entries:
            cases += _cases(path.stem, {**defaults, **entry})
    titles = [case.title for case in cases]
    twice = {title for title in titles if titles.count(title) > 1}
    if twice:
        raise ValueError(f"named twice: {sorted(twice)}")
    return tuple(cases)


def selected(cases: Sequence[Case], *, only: str | None = None, fast: bool = False) -> list[Case]:
    """Cases whose topic, name or title matches the pattern ``only`` (``*`` stands for anything,
    a plain word for a part); without the slow ones where ``fast``. Raises
    :class:`QuestionError` where none matches."""
    pattern = None if only is None else (only if set(only) & set("*?[") else f"*{only}*")
    found = [
        case for case in cases
        if (pattern is None or any(fnmatch.fnmatch(x, pattern)
                                   for x in (case.topic, case.name, case.title)))
        and not (fast and case.slow)
    ]  # fmt: skip
    if not found:
        topics = ", ".join(sorted({case.topic for case in cases}))
        raise QuestionError(
            f"only is {only!r}, which no case matches. Topics: {topics}.",
            field="only", value=str(only), mend="Use a part of a case's name, or a topic.",
        )  # fmt: skip
    return found


def _cases(topic: str, entry: dict[str, Any]) -> list[Case]:
    name = str(entry.pop("name"))
    where = f"{topic}: {name}"
    rungs, slow = entry.pop("rungs"), entry.pop("slow", False)
    checks = [_check(check, where) for check in entry.pop("check", [])]
    given = entry.pop("outcome", "converged")
    budget = _budget(entry.pop("budget", {}), where)
    scene = nulls(entry.pop("scene"))
    _closed(entry, {f.name for f in fields(Case)}, where)
    return [
        Case(
            topic=topic, name=name, rung=rung, scene=scene, outcomes=_outcomes(given, rung),
            budget=budget,
            slow=slow if isinstance(slow, bool) else rung in slow,
            checks=tuple(c for c in checks if not c.rungs or rung in c.rungs),
            **entry,
        )
        for rung in rungs
    ]  # fmt: skip


def _outcomes(given: Any, rung: str) -> tuple[Outcome, ...]:
    """``given``: an outcome, a list of those allowed, or a table of either by rung."""
    mine = given.get(rung, "converged") if isinstance(given, dict) else given
    return tuple(Outcome(o) for o in ([mine] if isinstance(mine, str) else mine))


def _budget(given: Table, where: str) -> Budget:
    _closed(given, {"seconds", "iterations", "memory_MiB"}, where)
    plain = Budget()
    return Budget(
        given.get("seconds", plain.seconds), given.get("iterations", plain.iterations),
        given.get("memory_MiB", plain.memory_mib),
    )  # fmt: skip


def _check(given: Table, where: str) -> Check:
    _closed(given, {f.name for f in fields(Check)}, where)
    entry = dict(given)
    for name in ("value", "rungs"):
        if isinstance(entry.get(name), list):
            entry[name] = tuple(entry[name])
    if "like" in entry:
        entry["like"] = variation(entry["like"], where)
    said = [name for name in ("value", "above", "below", "like") if name in entry]
    if not said or not entry.get("source"):
        raise ValueError(f"{where}: a check of {entry.get('quantity')} expects nothing, or has "
                         "no source")  # fmt: skip
    return Check(**entry)


def variation(given: Table, where: str) -> Variation:
    """The ``like`` of a check."""
    _closed(given, {f.name for f in fields(Variation)}, where)
    entry = dict(given)
    if "scaled" in entry:
        entry["scaled"] = Scaling(**entry["scaled"])
    if "scene" in entry:
        entry["scene"] = nulls(entry["scene"])
    return Variation(**entry)


def nulls(document: Table) -> dict[str, Any]:
    """A copy with "none" as None, at every depth: TOML has no null."""
    return {
        key: None if value == "none"
        else nulls(cast("Table", value)) if isinstance(value, dict) else value
        for key, value in document.items()
    }  # fmt: skip


def _closed(given: Table, known: set[str], where: str) -> None:
    unknown = set(given) - known
    if unknown:
        raise ValueError(f"{where}: {sorted(unknown)} is not part of an entry")
