"""The same path on a finer mesh of the same body, started from the coarser answer."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from actuators.mechanics.continuum.direct_solver import SymmetricSolver
from actuators.mechanics.continuum.newton import Equilibrium, Target, solve_equilibrium
from actuators.mechanics.continuum.path import Path
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.mechanics.response import Outcome
from actuators.meshing import prolong_nodes, prolong_pressure

NEAR_LIMIT = 0.8
"""Above this fraction of a limit pressure the volume is prescribed: the finer mesh's own limit may
lie lower."""
UNKNOWNS_TO_SOLVE = 400_000
"""Points times unknowns that the finest mesh solves; further points are corrected by
interpolation."""


@dataclass(eq=False)
class Refined:
    """Answer on a finer mesh. ``solved``: how many of the path's points were solved there; the
    others carry the correction interpolated between solved ones."""

    path: Path
    solved: int


class Refinement:
    """Transfer of one path from ``coarse`` to ``fine``, end point first."""

    def __init__(
        self,
        coarse: ContinuumSystem,
        fine: ContinuumSystem,
        solver: SymmetricSolver,
        path: Path,
        *,
        tolerance: float = 1e-6,
        stop: Callable[[], Outcome | None] = lambda: None,
        watch: Callable[[float], None] = lambda share: None,
    ) -> None:
        self._fine, self._solver, self._path = fine, solver, path
        self._tolerance, self._stop, self._watch = tolerance, stop, watch
        self._starts = [_prolong(coarse, fine, e.state) for e in path.points]
        self.iterations = 0

    def end_point(
        self, previous: tuple[ContinuumSystem, Equilibrium] | None = None
    ) -> Equilibrium | None:
        """The last state of the path on the finer mesh, None where it was not found. ``previous``:
        a level between the coarse and this one, and its end point, to start from."""
        start = self._starts[-1]
        if previous is not None:
            start = _prolong(previous[0], self._fine, previous[1].state)
        return self._at(len(self._starts) - 1, start)

    def whole_path(self, end: Equilibrium) -> Refined:
        """All points, from the end backwards, each started with the correction of the one before
        it."""
        count = len(self._starts)
        points = _choose(count, self._fine.unknowns)
        found: dict[int, Equilibrium] = {count - 1: end}
        for done, index in enumerate(points[::-1][1:], 1):
            nearest = min(found)
            correction = _minus(found[nearest].state, self._starts[nearest])
            result = self._at(index, self._starts[index].moved(1.0, correction))
            if result is None and self._stop() is None:
                result = self._at(index, self._starts[index])
            if self._stop() is not None:
                break
            if result is not None:
                found[index] = result
            self._watch(done / len(points))
        return self._assemble(found)

    def _at(self, index: int, start: State) -> Equilibrium | None:
        known = self._path.points[index]
        limited = self._path.outcome is Outcome.LIMIT_POINT
        near = limited and known.pressure > NEAR_LIMIT * self._path.points[-1].pressure
        volume = known.volume if near else None
        result = solve_equilibrium(
            self._fine, self._solver, start, Target(known.pressure, volume=volume),
            tolerance=self._tolerance, cancelled=lambda: self._stop() is not None,
        )  # fmt: skip
        self.iterations += result.iterations
        return result if isinstance(result, Equilibrium) else None

    def _assemble(self, found: dict[int, Equilibrium]) -> Refined:
        known = sorted(found)
        corrections = [_minus(found[i].state, self._starts[i]) for i in known]
        shifts = [found[i].pressure - self._path.points[i].pressure for i in known]
        at = np.array([self._path.points[i].volume for i in known])
        points: list[Equilibrium] = []
        for index, coarse in enumerate(self._path.points):
            if index in found:
                points.append(found[index])
                continue
            weights = _hat_weights(at, coarse.volume)
            state = self._starts[index]
            for weight, correction in zip(weights, corrections, strict=True):
                if weight != 0.0:
                    state = state.moved(weight, correction)
            shift = float(np.dot(weights, shifts))
            volume, _ = self._fine.volume(state)
            points.append(Equilibrium(state, coarse.pressure + shift, volume, 0, None))
        path = Path(points, self._path.outcome, self._path.reason)
        return Refined(path, len(known))


def _prolong(coarse: ContinuumSystem, fine: ContinuumSystem, state: State) -> State:
    return State(
        prolong_nodes(coarse.mesh, fine.mesh) @ state.displacement,
        prolong_pressure(coarse.mesh, fine.mesh, state.pressure),
    )


def _choose(count: int, unknowns: int) -> list[int]:
    """Points to solve: all, or evenly spread with both ends."""
    affordable = max(2, UNKNOWNS_TO_SOLVE // max(unknowns, 1))
    if affordable >= count:
        return list(range(count))
    return sorted({round(i) for i in np.linspace(0, count - 1, affordable)})


def _hat_weights(at: np.ndarray, where: float) -> np.ndarray:
    """Weights of piecewise linear interpolation at ``where`` between increasing ``at``."""
    return np.array([np.interp(where, at, row) for row in np.eye(len(at))])


def _minus(a: State, b: State) -> State:
    return State(a.displacement - b.displacement, a.pressure - b.pressure)


def tip_difference(
    coarse: ContinuumSystem, fine: ContinuumSystem, a: Equilibrium, b: Equilibrium
) -> float:
    """Difference of the tip's displacement over its size; of the pressure, where the volume was
    prescribed, if that is larger."""
    before = a.state.displacement[coarse.mesh.underside_line[-1]]
    after = b.state.displacement[fine.mesh.underside_line[-1]]
    size = float(np.linalg.norm(after))
    change = float(np.linalg.norm(after - before)) / size if size > 0 else 0.0
    if b.pressure > 0:
        change = max(change, abs(b.pressure - a.pressure) / b.pressure)
    return change
