"""How fast the walls on either side of an open gap come together, by the linear cell."""

from collections.abc import Iterator

import numpy as np

from actuators.geometry import OUTSIDE
from actuators.mechanics.cell import element
from actuators.mechanics.cell.lattice import HalfCell

_NUMBER = np.arange(element.NODES)
_LEFT, _RIGHT = _NUMBER[_NUMBER % 3 == 0], _NUMBER[_NUMBER % 3 == 2]
_TOP = _NUMBER[_NUMBER // 9 == 2]
_TOP_MIRRORED = _TOP.reshape(3, 3)[:, ::-1].ravel()
NARROW = 0.3
"""Pairs nearer than this share of the middle gap are left out: where a gap runs out into its
bottom, walls are one and cannot meet."""
FACING = 0.5
"""Least cosine between a bent wall's normal and the way across."""

Pair = tuple[int, np.ndarray, int, np.ndarray, bool]
"""Element and its nine nodes on one wall, the same on the other, whether a period lies between."""


def wall_closing(cell: HalfCell, period: float, motion: np.ndarray, rod: np.ndarray) -> float:
    """Largest share of an open gap that closes per pressure [1/Pa], negative where all of them
    widen; 0 where there is no gap.

    ``motion``: (n, 81) displacement of every element's nodes per pressure, the rod's part included
    [m/Pa]; ``rod``: (4,) free rod strains per pressure. Walls are compared node by node along the
    wall's normal, those of neighbouring chambers with the rod's motion over the ``period`` [m].
    """
    position = cell.coordinates()
    moved = motion.reshape(-1, element.NODES, 3)
    curved = cell.position is not None
    gaps: list[np.ndarray] = []
    rates: list[np.ndarray] = []
    for one, near, other, far, wrapped in _over_valleys(cell) if curved else _across_gaps(cell):
        here, there = position[one][near], position[other][far]
        opening = moved[other][far] - moved[one][near]
        if wrapped:
            opening = opening + _over_a_period(there, period, rod)
            there = there + np.array([period, 0.0, 0.0])
        normal = np.cross(here[2] - here[0], here[6] - here[0])
        normal *= np.sign(normal @ (there[4] - here[4])) / np.linalg.norm(normal)
        across = there - here
        gap = across @ normal
        facing = gap > (FACING if curved else 0.0) * np.linalg.norm(across, axis=1)
        gaps.append(gap[facing])
        rates.append(-(opening @ normal)[facing])
    if not gaps or not any(len(g) for g in gaps):
        return 0.0
    gap, rate = np.concatenate(gaps), np.concatenate(rates)
    wide = gap > NARROW * np.median(gap)
    return float((rate[wide] / gap[wide]).max())


def _across_gaps(cell: HalfCell) -> Iterator[Pair]:
    """Walls with outside air between them along the lattice's x."""
    nx, ny, nz = (n // 2 for n in cell.shape)
    number = np.arange(len(cell.fill)).reshape(nx, ny, nz)
    fill = cell.fill.reshape(nx, ny, nz)
    for i, j, k in np.argwhere((fill >= 0) & (np.roll(fill, -1, axis=0) == OUTSIDE)):
        beyond = int(i) + 1
        while fill[beyond % nx, j, k] == OUTSIDE:
            beyond += 1
        yield int(number[i, j, k]), _RIGHT, int(number[beyond % nx, j, k]), _LEFT, beyond >= nx


def _over_valleys(cell: HalfCell) -> Iterator[Pair]:
    """The second half of a bellows' skin, and its mirror image that the next bellows begins
    with."""
    nx, ny, nz = (n // 2 for n in cell.shape)
    number = np.arange(len(cell.fill)).reshape(nx, ny, nz)
    for i in range(nx // 2):
        for j in range(ny):
            yield int(number[nx - 1 - i, j, -1]), _TOP, int(number[i, j, -1]), _TOP_MIRRORED, True


def _over_a_period(position: np.ndarray, period: float, rod: np.ndarray) -> np.ndarray:
    """Displacement (n, 3) per pressure that rod strains add from ``position`` (n, 3) to the same
    place one period on (:mod:`.periodic` lists the fields)."""
    x, y, z = position.T
    square = ((x + period) ** 2 - x**2) / 2
    stretch, torsion, bending, sideways = rod
    return np.stack(
        [
            period * (stretch + bending * z - sideways * y),
            -torsion * period * z + sideways * square,
            torsion * period * y - bending * square,
        ],
        axis=-1,
    )
