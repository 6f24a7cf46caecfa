"""docs/validation.md from the kept numbers: every table is made, the words are below."""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from benchmarks.validation.bellows_page import bellows_section
from benchmarks.validation.data import Answer
from benchmarks.validation.markdown import table
from benchmarks.validation.oblique_pages import presets_section, sweep_section
from benchmarks.validation.printed_page import printed_section
from benchmarks.validation.slab_page import slabs_section

PAGE = Path("docs/validation.md")
NOT_GIVEN = re.compile(
    r"(\w+) is not (?:given in|known from) the (?:paper|thesis) \(.\); the studio"
)
WORDS = Path(__file__).parent / "words.txt"


def make_page(rows: list[dict[str, Any]], answers: Mapping[str, Answer]) -> None:
    """Put every made part in its place among the words."""
    parts = {
        "VERIFICATION": verification_table(rows),
        "OBLIQUE": presets_section(answers),
        "THETA": sweep_section(answers),
        "SLABS": slabs_section(answers),
        "PRINTED": printed_section(answers),
        "BELLOWS": bellows_section(answers),
        "ASSUMED": assumptions(answers),
        "COSTS": costs(answers),
    }
    text = WORDS.read_text()
    for name, part in parts.items():
        text = text.replace(f"{{{{{name}}}}}", part)
    PAGE.write_text(text)


def verification_table(rows: list[dict[str, Any]]) -> str:
    lines = [
        [r["problem"], r["quantity"], f"{r['expected']:.6g}", f"{r['ours']:.6g}",
         f"{r['difference_percent']:+.4f} %", r["mesh"], r["source"]]
        for r in rows
    ]  # fmt: skip
    return table(
        ["problem", "quantity", "expected", "ours", "difference", "elements", "from"], lines
    )


def assumptions(answers: Mapping[str, Answer]) -> str:
    """What each family's answers assume, said once."""
    seen: dict[str, list[str]] = {}
    for found in answers.values():
        known = seen.setdefault(found.document["group"], [])
        known += [text for text in found.document["assumptions"] if text not in known]
    merged: dict[str, list[str]] = {}
    for group, texts in seen.items():
        known = merged.setdefault("oblique" if group == "theta" else group, [])
        known += [text for text in texts if text not in known]
    return "\n".join(
        f"- **{group}**: {_in_short(texts)}" for group, texts in merged.items() if texts
    )


def _in_short(texts: list[str]) -> str:
    """Parameters without a source as one list, what needs words in full."""
    bare = [m for text in texts if (m := NOT_GIVEN.match(text))]
    rest = [text for text in texts if not NOT_GIVEN.match(text)]
    named = f"the paper does not give {', '.join(m.group(1) for m in bare)}" if bare else ""
    return "; ".join([*([named] if named else []), *rest]) + "."


def costs(answers: Mapping[str, Answer]) -> str:
    """Processor time by family, and the commits that solved it."""
    groups = sorted({a.document["group"] for a in answers.values()})
    lines: list[list[str]] = []
    for group in groups:
        of = [a.document for a in answers.values() if a.document["group"] == group]
        spent = [d["processor_s"] for d in of]
        sizes = [d["unknowns"] for d in of]
        versions = sorted({d.get("code") or "before versions were noted" for d in of})
        lines.append([group, str(len(of)), f"{min(sizes):,} to {max(sizes):,}",
                      f"{min(spent):.0f} to {max(spent):.0f}", ", ".join(versions)])  # fmt: skip
    heads = ["family", "cases", "unknowns", "processor seconds a case", "version of the code"]
    return table(heads, lines)
