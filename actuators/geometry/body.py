"""A body as blocks on a lattice: what every mesh, surface and mould is made from.

Three lists of lattice lines cut parameter space into boxes; ``fill`` says what each box is;
``place`` maps lattice coordinates to the undeformed actuator. Curved outlines and oblique chambers
live in ``place``, so that all else is structured.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

CAVITY = -1
"""A box that holds air under the actuation pressure."""
OUTSIDE = -2
"""A box that is not part of the actuator: surrounding air."""


@dataclass(frozen=True)
class Region:
    """A part of the body cast from one material; ``material`` is a key of the catalogue."""

    name: str
    material: str


@dataclass(frozen=True)
class Membrane:
    """An embedded sheet across the whole body that resists stretch along X1 and bends freely.

    ``plane``: z' of the sheet, one of the body's ``lines[2]``. ``stiffness`` K [N/m]: its energy
    per reference area is K/2 (lambda - 1)^2, lambda the stretch of the sheet's own X1 direction.
    """

    name: str
    plane: float
    stiffness: float


@dataclass(frozen=True, eq=False)
class Body:
    """Block-structured undeformed actuator (or one periodic cell of it).

    ``lines``: three increasing arrays, lattice coordinates of the block borders along (x', y', z').
    ``fill``: (nx, ny, nz) int8, an index into ``regions``, or :data:`CAVITY`, or :data:`OUTSIDE`.
    ``place``: maps lattice coordinates (..., 3) to positions (..., 3) [m]; continuous, and smooth
    inside every block.
    ``symmetric``: True where mirroring X2 -> -X2 leaves the body unchanged; then ``lines[1]``
    contains 0 and :meth:`half` is allowed.
    ``period``: length of the cell along X1 [m] for a periodic cell, else None. The faces x' =
    lines[0][0] and lines[0][-1] of a periodic cell differ by the translation (period, 0, 0).
    ``membranes``: embedded sheets, wherever rubber meets their planes. ``curved``: True where
    boxes are bent along x' (seen from the side), so that straight edges between lattice lines do
    not do.
    """

    lines: tuple[np.ndarray, np.ndarray, np.ndarray]
    fill: np.ndarray
    regions: tuple[Region, ...]
    place: Callable[[np.ndarray], np.ndarray]
    symmetric: bool
    period: float | None = None
    membranes: tuple[Membrane, ...] = ()
    curved: bool = False

    def half(self) -> "Body":
        """The half X2 >= 0 of a symmetric body; raises ValueError for one that is not."""
        if not self.symmetric:
            raise ValueError("only a symmetric body has a half model")
        y = self.lines[1]
        start = int(np.flatnonzero(y == 0.0)[0])
        return Body(
            lines=(self.lines[0], y[start:], self.lines[2]),
            fill=self.fill[:, start:, :],
            regions=self.regions,
            place=self.place,
            symmetric=False,
            period=self.period,
            membranes=self.membranes,
            curved=self.curved,
        )
