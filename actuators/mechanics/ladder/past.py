"""Jobs that have run, and how far one may differ from another."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from actuators.mechanics.ladder.question import Outlook

JUDGED = ("tip", "angle", "force", "limit_pressure")
"""Estimates that decide whether a job ends on a mesh (``continuum.estimates``)."""


@dataclass(frozen=True, eq=False)
class PastJob:
    """A job that has run: what could be told of it, the ``seconds`` it took, the mesh it ended on
    (``level``, 0 the coarsest), and the largest judged estimates [fractions] on meshes where they
    are known, by level. ``stopped``: it had not come to its end by then, and ``level`` is the mesh
    that it had come to at least."""

    outlook: Outlook
    seconds: float
    level: int
    errors: Mapping[int, float]
    stopped: bool = False

    @staticmethod
    def of(
        outlook: Outlook, seconds: float, unknowns: int, estimates: Mapping[str, float | None],
        *, stopped: bool = False,
    ) -> "PastJob":  # fmt: skip
        """From what an answer says of itself: its ``unknowns`` and its estimated errors by
        quantity, as fractions; only the seconds of one that was ``stopped``."""
        if stopped:
            return PastJob(outlook, seconds, 0, {}, stopped=True)
        level = outlook.level_of(unknowns)
        known = [e for name in JUDGED if (e := estimates.get(name)) is not None]
        return PastJob(outlook, seconds, level, {level: max(known)} if known else {})

    @property
    def is_timed(self) -> bool:
        """Whether its seconds mean anything."""
        return self.seconds > 0.0 and math.isfinite(self.seconds)


@dataclass(frozen=True)
class Spread:
    """Standard deviations. Of ln t: of the weights ``b`` (per unit of a feature), of the memory
    ``g`` and its ``reach`` (distance in features), of what neighbours share (``peculiar``, h), of
    the noise between two runs of one question, of one machine against another. Of errors, as parts
    of their whole variance: ``error_alike`` g, ``error_near`` h, the rest is noise;
    ``error_levels``: correlation from one mesh to the next."""

    weight: float = 0.05
    memory: float = 0.75
    reach: float = 2.0
    peculiar: float = 0.3
    noise: float = 0.14
    machine: float = 1.0
    error_alike: float = 0.3
    error_near: float = 0.65
    error_levels: float = 0.7
