"""docs/hard_cases.md from what is stored."""

import json
from collections import Counter
from pathlib import Path
from typing import Any

from actuators.hard_cases import read_cases
from benchmarks.hard_cases.pictures import FOLDER
from benchmarks.hard_cases.store import load

PAGE = Path("docs/hard_cases.md")
FUZZ = Path("docs/hard_cases_fuzz.json")
Found = dict[str, Any]

WORDS = Path(__file__).with_name("words.txt")


def write() -> None:
    """Write the page."""
    PAGE.write_text(text(load()))


def text(stored: dict[str, Found]) -> str:
    """The page of these results."""
    cases = [case for case in read_cases() if case.title in stored]
    names = {(case.topic, case.name) for case in read_cases()}
    found = [stored[case.title] for case in cases]
    counts = Counter(f["outcome"] for f in found)
    passed = sum(f["passed"] for f in found)
    missing = len(read_cases()) - len(found)
    counted = (
        f"{len(names)} cases, {len(found) + missing} runs. Of {len(found)} runs with a stored "
    )
    counted += f"result {passed} came out as they must; outcomes: "
    counted += ", ".join(f"{n} {name}" for name, n in counts.most_common()) + "."
    if missing:
        counted += f" {missing} runs have no stored result yet and are not listed."
    parts = [WORDS.read_text().replace("@COUNTS@", counted).replace("@RANDOM@", random_runs())]
    gallery = _gallery(found)
    if gallery:
        parts.append(
            "\n## The hardest\nOf each topic the run that took the most iterations, at its last "
            "state (coarse meshes).\n\n"
        )
        parts.append(gallery)
    for topic in dict.fromkeys(case.topic for case in cases):
        parts.append(f"\n## {topic.replace('_', ' ').capitalize()}\n")
        parts.append("| case | what makes it hard | rung | outcome | error | iterations | s |\n")
        parts.append("| --- | --- | --- | --- | --- | --- | --- |\n")
        parts += [_row(f) for f in found if f["topic"] == topic]
    return "".join(parts)


def random_runs() -> str:
    """What the slices of random designs came to, by rung."""
    slices: list[Found] = json.loads(FUZZ.read_text()) if FUZZ.exists() else []
    rows = ["| rung | designs | how they ended | slowest [s] | memory [MiB] | not as it must |\n",
            "| --- | --- | --- | --- | --- | --- |\n"]  # fmt: skip
    for rung in dict.fromkeys(s["rung"] for s in slices):
        mine = [s for s in slices if s["rung"] == rung]
        ends: Counter[str] = Counter()
        for s in mine:
            ends.update(s["outcomes"])
        rows.append(
            f"| {rung} | {sum(s['ran'] for s in mine)} | "
            f"{', '.join(f'{n} {name}' for name, n in ends.most_common())} | "
            f"{max(s['slowest_s'] for s in mine):.2g} | {max(s['peak_MiB'] for s in mine)} | "
            f"{sum(len(s['failures']) for s in mine)} |\n"
        )
    return "".join(rows)


def worst(stored: dict[str, Found]) -> list[str]:
    """Titles of the runs with a picture: of every topic the 3D one with the most iterations."""
    best: dict[str, tuple[int, str]] = {}
    for title, f in stored.items():
        if f["rung"] == "fe" and f["iterations"] > best.get(f["topic"], (0, ""))[0]:
            best[f["topic"]] = (f["iterations"], title)
    return [title for _, title in best.values()]


def _gallery(found: list[Found]) -> str:
    shown = [f for f in found if (FOLDER / f"{f['name']}.png").exists() and f["rung"] == "fe"]
    rows: list[str] = []
    for start in range(0, len(shown), 3):
        row = shown[start : start + 3]
        cells = [f"![{f['name']}](pictures/hard_cases/{f['name']}.png)" for f in row]
        said = [f"{f['name']}: {f['outcome']}, {f['iterations']} iterations" for f in row]
        blank = [""] * (3 - len(row))
        rows.append("| " + " | ".join([*cells, *blank]) + " |\n")
        if start == 0:
            rows.append("| --- | --- | --- |\n")
        rows.append("| " + " | ".join([*said, *blank]) + " |\n")
    return "".join(rows)


def _row(f: Found) -> str:
    error = "-" if f["error"] is None else f"{f['error']:.1e}"
    outcome = f["outcome"] + ("" if f["passed"] else ", **not as it must**")
    return (
        f"| {f['name']} | {f['hard']} | {f['rung']} | {outcome} | {error} | {f['iterations']} | "
        f"{f['seconds']:.2g} |\n"
    )
