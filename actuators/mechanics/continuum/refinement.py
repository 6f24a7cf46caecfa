"""The same path on a finer mesh of the same body, started from the coarser answer."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from actuators.mechanics.continuum.newton import (
    MONOTONE,
    Equilibrium,
    Target,
    solve_equilibrium,
)
from actuators.mechanics.continuum.path import Path, PathFollower
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.mechanics.direct_solver import SymmetricSolver
from actuators.mechanics.response import Outcome
from actuators.meshing import prolong_nodes, prolong_pressure

NEAR_LIMIT = 0.8
"""Above this fraction of the pressure at which a path ended early, the finer mesh follows its own:
its limit may lie lower."""
UNKNOWNS_TO_SOLVE = 400_000
"""Points times unknowns that the finest mesh solves; further points are corrected by
interpolation."""


@dataclass(eq=False)
class Anchor:
    """The last point of the path that both meshes share, on one of them."""

    system: ContinuumSystem
    found: Equilibrium


@dataclass(eq=False)
class Refined:
    """Answer on a finer mesh. ``solved``: how many of the path's points were solved there; the
    others carry the correction interpolated between solved ones."""

    path: Path
    solved: int


class Refinement:
    """Transfer of one path from ``coarse`` to ``fine``, the last shared point (the anchor) first:
    the end, or, where the path ended early, the last point well below that."""

    def __init__(
        self,
        coarse: ContinuumSystem,
        fine: ContinuumSystem,
        solver: SymmetricSolver,
        path: Path,
        *,
        stop: Callable[[], Outcome | None] = lambda: None,
        watch: Callable[[float], None] = lambda share: None,
    ) -> None:
        self._fine, self._solver, self._path = fine, solver, path
        self._stop, self._watch = stop, watch
        self._shared = shared_points(path)
        self._starts = [_prolong(coarse, fine, e.state) for e in path.points[: self._shared]]
        self._marched: dict[int, Equilibrium] = {}
        self.iterations = 0

    def anchor(self, previous: Anchor) -> Anchor | None:
        """The anchor on the finer mesh, started from a coarser one; None where not found."""
        last = self._shared - 1
        found = self._at(last, _prolong(previous.system, self._fine, previous.found.state))
        if found is None and self._stop() is None:
            found = self._march(last)
        return Anchor(self._fine, found) if found is not None else None

    def _march(self, last: int) -> Equilibrium | None:
        """The anchor by way of easier points, each started with the correction of the one before
        it: where less is deformed, the finer mesh is nearer to the coarse one."""
        found = self._at(0, self._starts[0])
        at, step = 0, max(1, last // 4)
        while found is not None and at < last:
            self._marched[at] = found
            goal = min(last, at + step)
            correction = _minus(found.state, self._starts[at])
            result = self._at(goal, self._starts[goal].moved(1.0, correction))
            if result is not None:
                at, found, step = goal, result, 2 * step
                self._watch(0.5 * at / last)
            elif step == 1 or self._stop() is not None:
                return None
            else:
                step //= 2
        return found

    def beyond(
        self, anchor: Anchor, pressure_to: float, report: Sequence[float] | None
    ) -> Path | None:
        """Points from the anchor to this mesh's own limit; None for a path that reached its end."""
        if self._path.outcome is Outcome.CONVERGED:
            return None
        history = [anchor.found]
        if self._shared > 1:
            correction = _minus(anchor.found.state, self._starts[-1])
            before = self._at(self._shared - 2, self._starts[-2].moved(1.0, correction))
            history = [before, anchor.found] if before is not None else history
        follower = PathFollower(self._fine, self._solver, stop=self._stop)
        left = [p for p in report if p > anchor.found.pressure] if report is not None else None
        path = follower.resume(history, pressure_to, left)
        self.iterations += path.iterations
        return path

    def whole_path(self, anchor: Anchor, rest: Path | None) -> Refined:
        """All points, from the anchor backwards, each started with the correction of the one
        before it; then ``rest``."""
        found: dict[int, Equilibrium] = {**self._marched, self._shared - 1: anchor.found}
        points = _choose(self._shared, self._fine.unknowns)
        for done, index in enumerate(points[::-1][1:], 1):
            if index in found:
                continue
            nearest = min(i for i in found if i > index)
            correction = _minus(found[nearest].state, self._starts[nearest])
            result = self._at(index, self._starts[index].moved(1.0, correction))
            if result is None and self._stop() is None:
                result = self._at(index, self._starts[index])
            if self._stop() is not None:
                break
            if result is not None:
                found[index] = result
            self._watch(done / len(points))
        return self._assemble(found, rest)

    def _at(self, index: int, start: State) -> Equilibrium | None:
        result = solve_equilibrium(
            self._fine, self._solver, start, Target(self._path.points[index].pressure),
            cancelled=lambda: self._stop() is not None, lenience=MONOTONE,
        )  # fmt: skip
        self.iterations += result.iterations
        return result if isinstance(result, Equilibrium) else None

    def _assemble(self, found: dict[int, Equilibrium], rest: Path | None) -> Refined:
        known = sorted(found)
        corrections = [_minus(found[i].state, self._starts[i]) for i in known]
        at = np.array([self._path.points[i].volume for i in known])
        points: list[Equilibrium] = []
        for index, coarse in enumerate(self._path.points[: self._shared]):
            if index in found:
                points.append(found[index])
                continue
            state = self._starts[index]
            for weight, correction in zip(_hats(at, coarse.volume), corrections, strict=True):
                if weight != 0.0:
                    state = state.moved(weight, correction)
            volume, _ = self._fine.volume(state)
            points.append(Equilibrium(state, coarse.pressure, volume, 0, None))
        if rest is None:
            return Refined(Path(points, self._path.outcome, self._path.reason), len(known))
        points += rest.points
        return Refined(Path(points, rest.outcome, rest.reason), len(known) + len(rest.points))


def shared_points(path: Path) -> int:
    """Number of points that every mesh can be expected to have."""
    if path.outcome is Outcome.CONVERGED:
        return len(path.points)
    limit = path.points[-1].pressure
    return max(1, sum(e.pressure <= NEAR_LIMIT * limit for e in path.points))


def difference(before: Anchor, after: Anchor, limits: tuple[float, float] | None) -> float:
    """Difference of the tip's displacement at the anchor over its size, or of the two limit
    pressures over the later one, whichever is larger."""
    old = before.found.state.displacement[before.system.mesh.underside_line[-1]]
    new = after.found.state.displacement[after.system.mesh.underside_line[-1]]
    size = float(np.linalg.norm(new))
    change = float(np.linalg.norm(new - old)) / size if size > 0 else 0.0
    if limits is not None:
        change = max(change, abs(limits[1] - limits[0]) / limits[1])
    return change


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


def _hats(at: np.ndarray, where: float) -> np.ndarray:
    """Weights of piecewise linear interpolation at ``where`` between increasing ``at``."""
    return np.array([np.interp(where, at, row) for row in np.eye(len(at))])


def _minus(a: State, b: State) -> State:
    return State(a.displacement - b.displacement, a.pressure - b.pressure)
