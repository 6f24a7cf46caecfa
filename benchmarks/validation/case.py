"""One finite-element case of the studies, and its answer as a document that can be kept."""

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
    time_budget: float = 600.0

    @property
    def question(self) -> dict[str, Any]:
        """What an answer belongs to: an answer to another question is not used."""
        return {
            "design": self.design.to_document(),
            "scene": self.scene.to_document(),
            "accuracy": self.accuracy,
        }

    def answer(self) -> dict[str, Any]:
        """Solve it. Some seconds to some minutes."""
        begun = time.process_time()
        found = solve(self.design, self.scene, accuracy=self.accuracy, time_budget=self.time_budget)
        document = found.to_document()
        for twice in ("design", "scene", "rung"):
            del document[twice]
        return {
            "key": self.key, "group": self.group, "question": self.question, **document,
            "processor_s": time.process_time() - begun,
        }  # fmt: skip
