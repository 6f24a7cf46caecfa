"""The unknowns of one pitch, by their parity under half a turn.

``even`` motions (pressure, stretch, torsion, bending about X2) lead along the path; ``odd`` ones
(bending about X3) enter the tangent only.

Rigid motions that neither strains nor symmetry exclude (along X3; for odd ones along X1, X2 and
about X1) are excluded by a point's *pins* where nothing but pressure acts, and where resultants may
act by conditions on the whole body's mean motion: what holds the cell then presses nowhere in
particular.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from actuators.mechanics.cell.helical.domain import Domain, Image
from actuators.mechanics.cell.helical.reduce import WIDTH, block_places, site_pairs
from actuators.mechanics.continuum.kernel.pattern import upper_rows
from actuators.mechanics.direct_solver import SymmetricSolver, open_solver

Parity = Literal["even", "odd"]
PARITY_STRAINS: dict[Parity, tuple[int, ...]] = {"even": (0, 1, 2), "odd": (3,)}
_TURNS = {Image.TURNED, Image.TURNED_AND_CARRIED}


@dataclass(eq=False)
class Numbering:
    """Unknowns of one parity: ``count`` in the sparse matrix, then in the border the strains
    ``strains`` and ``pins``, the unknowns whose sparse rows rigid motions would make singular.

    ``unknown``: (nodes, 7), the mesh's outer ones first, then those of walls in contact; ``places``
    and ``wall_places``: of either's blocks in the matrix; ``of_site``: (s, 3); ``mean``:
    (count + border, h), what the conditions on the mean motion weigh each unknown with; ``sign``:
    (6,) of every image; ``motion``: G of :mod:`.reduce` at the tangent last reduced, None before.
    """

    strains: tuple[int, ...]
    count: int
    pins: int
    unknown: np.ndarray
    of_site: np.ndarray
    mean: np.ndarray
    sign: np.ndarray
    indptr: np.ndarray
    indices: np.ndarray
    places: np.ndarray
    wall_places: np.ndarray
    node_entries: tuple[int, int]
    solver: SymmetricSolver
    motion: np.ndarray | None = None

    @property
    def border(self) -> int:
        """Strains and pins."""
        return len(self.strains) + self.pins


def number_unknowns(
    domain: Domain, site: np.ndarray, image: np.ndarray, outer: int, parity: Parity
) -> Numbering:
    """``site``, ``image`` of the ``outer`` nodes (those that no element has inside) and of others
    behind them; still without the matrix's pattern, see :func:`lay_out`."""
    strains = PARITY_STRAINS[parity]
    moving = np.flatnonzero(image != Image.ITSELF)
    used = np.zeros(len(domain.place), dtype=bool)
    used[site] = True
    free = np.repeat(used[:, None], 3, axis=1)
    foot, above = domain.lowest
    if parity == "even":
        free[domain.on_axis, :2] = False
        pins = [(foot, 2)]
    else:
        free[domain.on_axis, 2] = False
        pins = [(foot, 0), (foot, 1), (above, 1)]
    sparse = free.copy()
    for pin in pins:
        sparse[pin] = False
    count = int(sparse.sum())
    of_site = np.full(free.shape, -1, dtype=np.int32)
    of_site[sparse] = np.arange(count, dtype=np.int32)
    for number, pin in enumerate(pins):
        of_site[pin] = count + len(strains) + number
    unknown = np.full((len(site), WIDTH), -1, dtype=np.int32)
    unknown[:, :3] = of_site[site]
    for number, strain in enumerate(strains):
        unknown[moving, 3 + strain] = count + number
    sign = np.array([-1.0 if parity == "odd" and i in _TURNS else 1.0 for i in Image])
    return Numbering(
        strains=strains, count=count, pins=len(pins), unknown=unknown, of_site=of_site,
        mean=_means(domain, site[:outer], parity, of_site, count + len(strains) + len(pins)),
        sign=sign,
        indptr=np.empty(0, np.int32), indices=np.empty(0, np.int32),
        places=np.empty((0, 3, 3), np.int32), wall_places=np.empty((0, 3, 3), np.int32),
        node_entries=(-1, -1),
        solver=open_solver(np.zeros(1, np.int32), np.empty(0, np.int32)),
    )  # fmt: skip


def _means(
    domain: Domain, site: np.ndarray, parity: Parity, of_site: np.ndarray, size: int
) -> np.ndarray:
    """Weights of the conditions (size, h): mean motion of the sites, and turn about X1."""
    share = np.bincount(site, minlength=len(domain.place)).astype(float)
    share /= share.sum()
    height = domain.place[:, 2] - share @ domain.place[:, 2]
    weights = np.zeros((len(share), 3, 1 if parity == "even" else 3))
    if parity == "even":
        weights[:, 2, 0] = share
    else:
        weights[:, 0, 0] = share
        weights[:, 1, 1] = share
        weights[:, 1, 2] = -share * height / domain.period
        weights[:, 2, 2] = share * domain.place[:, 1] / domain.period
    mean = np.zeros((size, weights.shape[2]))
    kept = of_site >= 0
    mean[of_site[kept]] = weights[kept]
    return mean


@dataclass(frozen=True, eq=False)
class Blocks:
    """A matrix of (3, 3) node blocks, upper triangle by rows (``indptr``, ``indices``,
    ``values``), of ``nodes`` (b,), numbers among all that a :class:`Numbering` knows; their
    ``site`` (b,)."""

    indptr: np.ndarray
    indices: np.ndarray
    values: np.ndarray
    nodes: np.ndarray
    site: np.ndarray


_NONE = np.empty(0, dtype=np.int32)
NO_BLOCKS = Blocks(np.zeros(1, np.int32), _NONE, np.empty(0), _NONE, _NONE)


def lay_out(numbering: Numbering, mesh: Blocks, walls: Blocks) -> None:
    """Pattern of the reduced matrix for these blocks of the mesh's nodes and of walls'."""
    pairs = np.concatenate([site_pairs(b.indptr, b.indices, b.site) for b in (mesh, walls)])
    count = len(numbering.of_site)
    key = np.unique(np.concatenate(
        [pairs[:, 0] * count + pairs[:, 1], pairs[:, 1] * count + pairs[:, 0]]
    ))  # fmt: skip
    first = np.concatenate([[0], np.cumsum(np.bincount(key // count, minlength=count))])
    sparse = np.where(numbering.of_site < numbering.count, numbering.of_site, -1)
    numbering.indptr, numbering.indices = upper_rows(
        first.astype(np.int64), (key % count).astype(np.int32), sparse.astype(np.int32),
        numbering.count,
    )  # fmt: skip
    numbering.places, numbering.wall_places = (
        block_places(
            b.indptr, b.indices, numbering.unknown[b.nodes], numbering.count, numbering.indptr,
            numbering.indices,
        )
        for b in (mesh, walls)
    )  # fmt: skip
    numbering.node_entries = len(mesh.indices), len(walls.indices)
    numbering.solver = open_solver(numbering.indptr, numbering.indices)
