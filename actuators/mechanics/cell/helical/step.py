"""Changes of a cell's state: corrections, rates along a path, and combinations of them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from actuators.mechanics.cell.helical.system import CellState, CellSystem
from actuators.mechanics.continuum.system import Balance, State


@dataclass(frozen=True, eq=False)
class Step:
    """Changes of a :class:`.CellState`'s parts and ``rise`` of the pressure [Pa]; or the rates of
    all of them along a path."""

    nodes: State
    place: np.ndarray
    strain: np.ndarray
    hold: np.ndarray
    rise: float

    @property
    def length(self) -> float:
        """Largest displacement [m]."""
        return max(float(np.abs(self.place).max()), float(np.abs(self.nodes.displacement).max()))

    def combined(self, factors: Sequence[float], others: Sequence["Step"]) -> "Step":
        """self + the sum of factors times others."""
        nodes, place, strain, hold, rise = (
            self.nodes, self.place, self.strain, self.hold, self.rise
        )  # fmt: skip
        for factor, other in zip(factors, others, strict=True):
            nodes = nodes.moved(factor, other.nodes)
            place = place + factor * other.place
            strain = strain + factor * other.strain
            hold = hold + factor * other.hold
            rise += factor * other.rise
        return Step(nodes, place, strain, hold, rise)

    def times(self, factor: float) -> "Step":
        """factor times self."""
        return self.combined([factor - 1.0], [self])

    def taken(self, system: CellSystem, state: CellState, factor: float) -> CellState:
        """``state`` after this part of the step."""
        return system.placed(
            state.nodes.moved(factor, self.nodes), state.place + factor * self.place,
            state.strain + factor * self.strain, state.hold + factor * self.hold,
        )  # fmt: skip


def step_of(
    system: CellSystem, state: CellState, solution: np.ndarray, balance: Balance | None,
    hold: np.ndarray, rise: float,
) -> Step:  # fmt: skip
    """The step that unknowns of the even numbering describe; ``balance`` as
    :meth:`.CellSystem.expand` takes it."""
    nodes, place, strain = system.expand(state, solution, balance, system.numbering("even"))
    full = hold if len(hold) else np.zeros_like(state.hold)
    return Step(nodes, place, strain, full, rise)


def difference(before: CellState, last: CellState) -> Step:
    """The step from one state to another."""
    return Step(
        last.nodes.moved(-1.0, before.nodes), last.place - before.place,
        last.strain - before.strain, last.hold - before.hold, 0.0,
    )  # fmt: skip
