"""Errors for input that cannot be used. Not converging is not an error but an ``Outcome``."""

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Change:
    """One parameter's new value that mends: ``field`` is its border name (``length_mm``), ``value``
    in border units."""

    field: str
    value: float


class InputError(Exception):
    """Input that cannot be used.

    ``field`` names the offending entry (border name, e.g. ``bottom_thickness``), ``value`` is what
    was given (in border units, as text), ``mend`` says what to do. ``str()`` holds all three in
    one sentence or two, ready to be shown to the designer. ``changes`` are those that mend it, each
    by itself, where they can be told; the first is the smallest.
    """

    def __init__(
        self, message: str, *, field: str, value: str = "", mend: str = "",
        changes: Sequence[Change] = (),
    ) -> None:  # fmt: skip
        super().__init__(message)
        self.changes = tuple(changes)
        self.field = field
        self.value = value
        self.mend = mend


class DesignError(InputError):
    """A design that cannot be built: a value out of its limits or an impossible combination."""


class SceneError(InputError):
    """A scene that cannot be computed: a bad load, or an effect this version does not have."""


class QuestionError(InputError):
    """A question a rung cannot answer: unknown rung, accuracy or step count."""
