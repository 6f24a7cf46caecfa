"""The rungs, from the cheapest to the most accurate."""

from collections.abc import Callable
from dataclasses import dataclass

from actuators.errors import QuestionError
from actuators.mechanics import predict as instant

ACCURACIES = (0.10, 0.05, 0.02, 0.01)
"""Accuracies at which the ladder shows finite elements."""

_LEFT_OUT = {
    "closed-form": ("weight", "twist", "bulging of walls", "large strain", "contact"),
    "energy": ("large strain", "contact", "the ends of the body"),
    "cell-rod": ("differences between chambers",),
    "fe": ("inertia", "viscoelasticity"),
}


@dataclass(frozen=True)
class Rung:
    """One way to answer. ``accuracy`` (a fraction) and ``mesh`` belong to finite elements only: the
    accuracy asked for, or the one mesh chosen instead."""

    name: str
    accuracy: float | None = None
    mesh: str | None = None

    @property
    def label(self) -> str:
        """As people read it: ``fe 5 %``."""
        if self.mesh is not None:
            return f"{self.name} {self.mesh} mesh"
        return self.name if self.accuracy is None else f"{self.name} {100 * self.accuracy:g} %"

    @property
    def leaves_out(self) -> tuple[str, ...]:
        """What of the physics it does not hold, whatever the scene."""
        return _LEFT_OUT.get(self.name, ())

    @property
    def is_instant(self) -> bool:
        """Whether it answers within a second, without the queue."""
        return self.name != "fe"


def ladder_rungs() -> tuple[Rung, ...]:
    """Every rung of this version: the instant models there are, then finite elements."""
    fe = tuple(Rung("fe", accuracy) for accuracy in ACCURACIES)
    return (*(Rung(name) for name in instant.RUNGS), *fe)


def read_rung(text: str, read_accuracy: Callable[[str], float]) -> Rung:
    """``energy``, ``fe:5%``; raises :class:`QuestionError` for what is none."""
    name, _, accuracy = text.strip().partition(":")
    known = [*instant.RUNGS, "fe:5%"]
    if name == "fe" and accuracy:
        return Rung("fe", read_accuracy(accuracy))
    if name not in instant.RUNGS or accuracy:
        raise QuestionError(
            f"rung is {text.strip()!r}; it must be one of {', '.join(known)}.",
            field="run", value=text, mend=f"Use for example {known[1]} or {known[-1]}.",
        )  # fmt: skip
    return Rung(name)
