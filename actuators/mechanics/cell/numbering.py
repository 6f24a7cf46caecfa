"""Unknowns of the half cell: tied by the half turn, pinned against rigid motion, scattered once.

All of it depends on the topology only (fill and element counts), so it is kept: a slider that
changes a dimension pays for numbers alone.
"""

from dataclasses import dataclass
from threading import Lock
from typing import Literal

import numpy as np

from actuators.mechanics.cell.kept import Kept
from actuators.mechanics.cell.lattice import HalfCell
from actuators.mechanics.direct_solver import SymmetricSolver, open_solver

Parity = Literal["even", "odd"]
"""How a motion answers the half turn about X3: ``even`` ones (pressure, stretch, torsion, bending
about X2) are unchanged by it, ``odd`` ones (bending about X3) change sign."""

_TIE = {"even": np.array([-1.0, -1.0, 1.0]), "odd": np.array([1.0, 1.0, -1.0])}


@dataclass(frozen=True, eq=False)
class Numbering:
    """``dofs``: (n, 81) unknown of each element's local dof 3 a + i, ``count`` where there is none;
    ``signs``: (n, 81) factor from unknown to local value; ``slot``: place in the matrix's data of
    every entry of the solid elements' upper triangle; ``size``: length of that data. ``solver``
    keeps the pattern's analysis; ``lock`` lets one thread at a time have it."""

    dofs: np.ndarray
    signs: np.ndarray
    count: int
    slot: np.ndarray
    size: int
    solver: SymmetricSolver
    lock: Lock

    def solve(self, elements: np.ndarray, solid: np.ndarray, right: np.ndarray) -> np.ndarray:
        """Unknowns (count, c) under the forces ``right`` (count, c): the matrix is the sum of the
        solid elements' (m, 81, 81)."""
        signs = self.signs[solid]
        values = elements * signs[:, :, None] * signs[:, None, :]
        data = np.bincount(self.slot, weights=values.ravel(), minlength=self.size + 1)[:-1]
        with self.lock:
            self.solver.factorize(data)
            return self.solver.solve(right)

    def gather(self, forces: np.ndarray, elements: np.ndarray) -> np.ndarray:
        """Sum local vectors (m, 81, c) of the elements in the mask into unknowns (count, c)."""
        signed = forces * self.signs[elements][:, :, None]
        dofs = self.dofs[elements].ravel()
        size = self.count + 1
        columns = [
            np.bincount(dofs, weights=signed[:, :, c].ravel(), minlength=size)[:-1]
            for c in range(forces.shape[-1])
        ]
        return np.stack(columns, axis=-1)

    def spread(self, unknowns: np.ndarray) -> np.ndarray:
        """Values (count,) back on the elements' local dofs (n, 81)."""
        return np.append(unknowns, 0.0)[self.dofs] * self.signs


_numberings: Kept[Numbering] = Kept(64)


def numbering(cell: HalfCell, parity: Parity) -> Numbering:
    """The numbering of the cell's topology, kept from last time where there was one."""
    key = (cell.shape, cell.turn, cell.fill.tobytes(), parity)
    return _numberings.get(key, lambda: _number(cell, parity))


def _number(cell: HalfCell, parity: Parity) -> Numbering:
    solid = cell.solid
    size = int(np.prod(cell.shape))
    nodes, twin = np.arange(size), cell.twin
    first = np.minimum(nodes, twin)
    free = np.zeros((size, 3), dtype=bool)
    free[cell.nodes[solid]] = True
    free[first != nodes] = False
    on_axis = (twin == nodes) & (nodes // cell.shape[2] % cell.shape[1] == 0)
    free[np.ix_(on_axis, _TIE[parity] < 0)] = False
    _pin(free, cell, parity)

    count = int(free.sum())
    unknown = np.full((size, 3), count)
    unknown[free] = np.arange(count)
    signs = np.ones((size, 3))
    signs[first != nodes] = _TIE[parity]
    dofs = unknown[first][cell.nodes].reshape(-1, 81)
    slot, indices, indptr = _pattern(dofs[solid], count)
    return Numbering(
        dofs=dofs,
        signs=signs[cell.nodes].reshape(-1, 81),
        count=count,
        slot=slot,
        size=len(indices),
        solver=open_solver(indptr, indices),
        lock=Lock(),
    )


def _pin(free: np.ndarray, cell: HalfCell, parity: Parity) -> None:
    """Hold one unknown for each rigid motion that period and half turn leave: along X3 for even
    ones; along X1 and X2, and turning about X1 (it moves lower and upper nodes apart along X2), for
    odd ones."""
    if parity == "even":
        free[np.flatnonzero(free[:, 2])[0], 2] = False
        return
    free[np.flatnonzero(free[:, 0])[0], 0] = False
    height = np.arange(len(free)) % cell.shape[2]
    free[np.flatnonzero(free[:, 1] & (height == 0))[0], 1] = False
    free[np.flatnonzero(free[:, 1] & (height == 2))[0], 1] = False


def _pattern(dofs: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """CSR pattern of the upper triangle of the matrix that elements with these dofs (m, 81) fill,
    and the slot of each of their entries in its data (one past the end for entries of held dofs
    and of the lower triangle)."""
    rows = np.repeat(dofs, 81, axis=1).ravel()
    columns = np.tile(dofs, (1, 81)).ravel()
    key = rows * (count + 1) + columns
    key[(rows > columns) | (columns == count)] = np.iinfo(np.int64).max
    entries, slot = np.unique(key, return_inverse=True)
    entries = entries[:-1]  # the dropped ones: a lower triangle there always is
    indices = (entries % (count + 1)).astype(np.int32)
    per_row = np.bincount(entries // (count + 1), minlength=count)
    indptr = np.concatenate([[0], np.cumsum(per_row)]).astype(np.int32)
    return slot.ravel(), indices, indptr
