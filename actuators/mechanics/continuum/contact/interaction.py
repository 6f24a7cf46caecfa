"""The hook by which forces between surfaces enter the discrete problem."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np


@dataclass(frozen=True, eq=False)
class Tangent:
    """The matrix being assembled: upper triangle by rows, and ``dof`` (n, 3), -1 where held.
    ``near``: whether the state is so near to equilibrium that its contact pressures are to be
    believed."""

    dof: np.ndarray
    indptr: np.ndarray
    indices: np.ndarray
    values: np.ndarray
    near: bool = True


@dataclass(frozen=True)
class Touch:
    """What an interaction found: ``points`` names the points that are pressed (equal where
    the same ones are); ``blind`` says that surfaces ran so far into each other that the
    interaction may no longer see all of it."""

    points: bytes = b""
    blind: bool = False


class Interaction(Protocol):
    """Forces with a potential that depends on node positions only. Far from touching, an
    interaction does no more than find that out."""

    def couples(self, positions: np.ndarray) -> np.ndarray:
        """(k, m) nodes that may get entries with each other at ``positions`` (n, 3), beyond those
        of common elements; k is 0 where there are none."""
        ...

    def add(self, positions: np.ndarray, residual: np.ndarray, tangent: Tangent | None) -> Touch:
        """Add the potential's gradient to ``residual`` (n, 3) [N] and, if asked for, its second
        derivatives to ``tangent``."""
        ...

    def overlap(self, positions: np.ndarray) -> float:
        """Deepest penetration at ``positions`` over the distance in which contact sets in; 0 where
        there is none."""
        ...

    def contact_pressure(self, positions: np.ndarray) -> np.ndarray:
        """(n,) contact pressure [Pa] at the nodes, per area as it is at ``positions``; 0 where
        nothing touches."""
        ...
