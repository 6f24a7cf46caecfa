"""Solving with the tangent of one pitch: a sparse matrix with a dense border.

    [ K    L ] [y]     [r]
    [ L^T  D ] [z] = - [s]        (D - L^T K^-1 L) z = -(s - L^T K^-1 r)

The border holds the free strains, the pins where a cell is held by its mean motion instead, the
forces that hold it, and the pressure where the cavity's volume is given.
"""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.cell.helical.system import CellState, CellSystem, Numbering
from actuators.mechanics.continuum.system import Balance

Flags = tuple[bool, bool, bool, bool]
EVEN_FREE: Flags = (False, False, False, True)
ODD_FREE: Flags = (True, True, True, False)


@dataclass(frozen=True, eq=False)
class Target:
    """What is prescribed: ``pressure`` [Pa], or the half pitch's ``volume`` [m3] with ``pressure``
    as first guess. ``resultants`` (4,) [N, N m]; strains where ``fixed`` keep the start's values. A
    cell that resultants may act on is ``held`` by its mean motion, at the start's values, instead
    of by a point."""

    pressure: float
    volume: float | None = None
    resultants: np.ndarray | None = None
    fixed: Flags = EVEN_FREE
    held: bool = False


@dataclass(frozen=True, eq=False)
class Factor:
    """A factorised sparse tangent at a state: good until its numbering factorises another.

    ``column``: (count, c) of all that a border can hold (strains, pins, mean motions, the cavity's
    volume), ``corner``: (c, c), ``back``: the sparse matrix' inverse times ``column``.
    ``balance`` and ``pressure``: of the state; ``negative``: its negative eigenvalues.
    """

    system: CellSystem
    numbering: Numbering
    state: CellState
    balance: Balance
    pressure: float
    column: np.ndarray
    corner: np.ndarray
    back: np.ndarray
    negative: int


def factorised(
    system: CellSystem, numbering: Numbering, state: CellState, balance: Balance, pressure: float
) -> Factor:
    """Of the free nodes' tangent last filled; raises FactorizationError."""
    matrix = system.reduced(state, balance, pressure, numbering)
    solver, count, border = numbering.solver, numbering.count, numbering.border
    solver.factorize(matrix.values)
    gradient = system.volume_gradient(state, numbering)
    wide = np.concatenate([numbering.mean, gradient[:, None]], axis=1)
    column = np.concatenate([matrix.border, wide[:count]], axis=1)
    corner = np.zeros((column.shape[1],) * 2)
    corner[:border, :border] = matrix.corner
    corner[:border, border:] = wide[count:]
    corner[border:, :border] = wide[count:].T
    return Factor(
        system, numbering, state, balance, pressure, column, corner, solver.solve(column),
        solver.negative_eigenvalues or 0,
    )  # fmt: skip


class Tangent:
    """A factor with the border of one kind of target. ``reference``: mean motion at which a
    ``held`` cell is held."""

    def __init__(self, factor: Factor, target: Target, reference: np.ndarray | None = None) -> None:
        self._factor, self._target, self._reference = factor, target, reference
        numbering = factor.numbering
        count, strains = numbering.count, numbering.strains
        chosen = [n for n, strain in enumerate(strains) if not target.fixed[strain]]
        if target.held:
            chosen += range(len(strains), numbering.border)
        self._rows = count + np.array(chosen, dtype=np.int64)
        last = factor.column.shape[1] - 1
        if target.held:
            chosen += range(numbering.border, last)
        if target.volume is not None:
            chosen.append(last)
        self._column, self._back = factor.column[:, chosen], factor.back[:, chosen]
        self._schur = factor.corner[np.ix_(chosen, chosen)] - self._column.T @ self._back
        self.conditions = len(chosen)

    def unstable(self) -> bool:
        """Whether there are more negative eigenvalues than conditions account for."""
        below = int((np.linalg.eigvalsh(self._schur) < 0).sum())
        return self._factor.negative + below > self.conditions - len(self._rows)

    def answer(self, border: np.ndarray, first: np.ndarray | None = None) -> np.ndarray:
        """(count + border + conditions',) what forces (conditions,) on the border cause; besides
        ``first``, the sparse matrix' own answer to forces inside."""
        numbering = self._factor.numbering
        count = numbering.count
        if first is not None:
            border = border - self._column.T @ first
        z = np.linalg.solve(self._schur, border)
        solution = np.zeros(count + numbering.border + self.conditions - len(self._rows))
        solution[:count] = -self._back @ z
        if first is not None:
            solution[:count] += first
        solution[self._rows] = z[: len(self._rows)]
        solution[count + numbering.border :] = z[len(self._rows) :]
        return solution

    def correction(
        self, state: CellState, balance: Balance, pressure: float
    ) -> tuple[np.ndarray, np.ndarray, float]:
        """Newton's correction of the unknowns, of the holding forces and of the pressure."""
        system, numbering, target = self._factor.system, self._factor.numbering, self._target
        residual = system.forces(state, balance, pressure, numbering)
        if target.resultants is not None:
            strains = slice(numbering.count, numbering.count + len(numbering.strains))
            share = system.domain.period / 2
            residual[strains] -= share * target.resultants[list(numbering.strains)]
        border = [-residual[self._rows]]
        if self._reference is not None:
            border.append(self._reference - system.held(state, numbering))
        if target.volume is not None:
            border.append(np.array([target.volume - system.volume(state)]))
        first = numbering.solver.solve(-residual[: numbering.count])
        found = self.answer(np.concatenate(border), first)
        size = numbering.count + numbering.border
        hold = found[size : size + numbering.mean.shape[1]] if target.held else np.zeros(0)
        # the border's column is +dV/dx, the pressure's is -dV/dx
        rise = -float(found[-1]) if target.volume is not None else 0.0
        return found[:size], hold, rise

    def rate(self) -> tuple[np.ndarray, float]:
        """Change of the unknowns per pressure, and of the volume."""
        numbering, last = self._factor.numbering, self._factor.column.shape[1] - 1
        inner = self._rows - numbering.count
        load = self._factor.corner[inner, last]
        solution = self.answer(load, self._factor.back[:, last])
        growth = self._factor.column[:, last] @ solution[: numbering.count]
        return solution, float(growth + load @ solution[self._rows])
