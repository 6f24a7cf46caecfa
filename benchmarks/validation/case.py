"""One finite-element case of the studies, and its answer as a document that can be kept."""

import subprocess
import time
from dataclasses import dataclass
from typing import Any

from actuators.design.base import Design
from actuators.mechanics.continuum import solve
from actuators.mechanics.scene import Scene


@dataclass(frozen=True)
class Case:
    """``key`` names the answer's file; ``group`` the section of the page."""

    key: str
    group: str
    design: Design
    scene: Scene
    accuracy: float
    processor_budget: float = 600.0

    @property
    def question(self) -> dict[str, Any]:
        """What an answer belongs to: an answer to another question is not used."""
        return {
            "design": self.design.to_document(),
            "scene": self.scene.to_document(),
            "accuracy": self.accuracy,
        }

    def answer(self) -> dict[str, Any]:
        """Solve it. Some seconds to some minutes of processor time, whatever else the machine
        does: beyond the budget it stops with what it has."""
        begun = time.process_time()

        def spent() -> bool:
            return time.process_time() - begun > self.processor_budget

        found = solve(self.design, self.scene, accuracy=self.accuracy, cancelled=spent)
        document = found.to_document()
        if document["outcome"] == "cancelled":
            document["outcome"] = "budget_spent"
        for twice in ("design", "scene", "rung"):
            del document[twice]
        return {
            "key": self.key, "group": self.group, "question": self.question, **document,
            "processor_s": time.process_time() - begun, "code": code_version(),
        }  # fmt: skip


def code_version() -> str:
    """Commit of the working copy that solves, with a plus where its science was changed since."""

    def git(*what: str) -> str:
        done = subprocess.run(["git", *what], capture_output=True, text=True, check=False)
        return done.stdout.strip()

    commit = git("rev-parse", "--short", "HEAD")
    return f"{commit or 'unknown'}{'+' if git('status', '--short', 'actuators') else ''}"
