"""Rules of the house that no linter knows."""

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parent.parent
SUBJECTLESS = re.compile(r"^_?(util|utils|helper|helpers|common|misc|tools_misc|stuff)(\.|$)", re.I)


def tracked_files() -> list[Path]:
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    return [ROOT / line for line in listed.splitlines() if (ROOT / line).is_file()]


def test_no_file_or_folder_is_named_without_a_subject() -> None:
    bad = [
        str(path.relative_to(ROOT))
        for path in tracked_files()
        if any(SUBJECTLESS.match(part) for part in path.relative_to(ROOT).parts)
    ]
    assert not bad, f"If it has no subject, find the subject: {bad}"


def test_no_lock_file_names_the_host_of_a_registry() -> None:
    for name in ("requirements.lock", "frontend/package-lock.json"):
        text = (ROOT / name).read_text()
        hosts = re.findall(r'"resolved": "https?://[^"]+"|--(?:extra-)?index-url.*', text)
        assert not hosts, f"{name} names download addresses: {hosts[:3]}"


def test_every_relative_link_in_the_documents_leads_somewhere() -> None:
    link = re.compile(r"\]\((?!https?://|#|mailto:)([^)#\s]+)")
    broken: list[str] = []
    for path in tracked_files():
        if path.suffix != ".md" or "node_modules" in path.parts:
            continue
        for target in link.findall(path.read_text()):
            if not (path.parent / target).exists():
                broken.append(f"{path.relative_to(ROOT)} -> {target}")
    assert not broken, broken
