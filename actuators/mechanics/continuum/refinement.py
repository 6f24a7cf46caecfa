"""The same path on a finer mesh of the same body, started from the coarser answer."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.newton import (
    MONOTONE,
    Equilibrium,
    Target,
    solve_equilibrium,
)
from actuators.mechanics.continuum.path import Path, PathFollower
from actuators.mechanics.continuum.sheets import prolong_sheet_force
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.mechanics.direct_solver import SymmetricSolver
from actuators.mechanics.response import Outcome
from actuators.meshing import prolong_nodes, prolong_pressure

NEAR_LIMIT = 0.8
"""Above this fraction of the pressure at which a path ended early, the finer mesh follows its own:
its limit may lie lower."""


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
        shared: int | None = None,
        stop: Callable[[], Outcome | None] = lambda: None,
        watch: Callable[[float], None] = lambda share: None,
    ) -> None:
        self._coarse, self._fine, self._solver, self._path = coarse, fine, solver, path
        self._stop, self._watch = stop, watch
        self.shared = shared if shared is not None else shared_points(path)
        self._starts = [_prolong(coarse, fine, e.state) for e in path.points[: self.shared]]
        first, *later = (e.state.displacement for e in path.points[: self.shared])
        self._way = max((float(np.abs(u - first).max()) for u in later), default=0.0)
        self._marched: dict[int, Equilibrium] = {}
        self.iterations = 0

    def anchor(self, previous: Anchor) -> Anchor | None:
        """The anchor on the finer mesh, started from a coarser one; None where not found. Where
        only points before it are found, :attr:`shared` shrinks to the last of them."""
        last = self.shared - 1
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
            elif self._stop() is not None:
                return None
            elif step == 1 and at == 0:
                return self._follow(found, last)
            elif step == 1:
                self.shared, self._starts = at + 1, self._starts[: at + 1]
                return found
            else:
                step //= 2
        return found

    def _follow(self, first: Equilibrium, last: int) -> Equilibrium | None:
        """The anchor by this mesh's own steps from its first point: where walls press on each
        other, even the first shared point may be too far. :attr:`shared` shrinks to what
        is found; None where that is the first point alone."""
        by_volume = self._path.by_volume
        wanted = [e.volume if by_volume else e.pressure for e in self._path.points[: last + 1]]
        goal = Goal(wanted[-1], by_volume, stops=tuple(wanted[1:]))
        path = PathFollower(self._fine, self._solver, stop=self._stop).resume([first], first, goal)
        self.iterations += path.iterations
        near = 1e-6 * abs(wanted[-1] - wanted[0])
        for index, value in enumerate(wanted[1:], start=1):
            for found in path.points:
                if abs(goal.measure(found) - value) <= near:
                    self._marched[index] = found
        if self._stop() is not None or not self._marched.keys() - {0}:
            return None
        reached = max(self._marched)
        self.shared, self._starts = reached + 1, self._starts[: reached + 1]
        return self._marched[reached]

    def beyond(self, anchor: Anchor, goal: Goal) -> Path | None:
        """Points from the anchor on, this mesh's own; None where every point is shared."""
        if self.shared == len(self._path.points):
            return None
        history = [anchor.found]
        if self.shared > 1:
            correction = _minus(anchor.found.state, self._starts[-1])
            before = self._at(self.shared - 2, self._starts[-2].moved(1.0, correction))
            history = [before, anchor.found] if before is not None else history
        follower = PathFollower(self._fine, self._solver, stop=self._stop)
        path = follower.resume(history, self._path.points[0], goal)
        self.iterations += path.iterations
        return path

    def limit_pressure(self, anchor: Anchor, rest: Path | None) -> float | None:
        """Maximum of the pressure on this mesh [Pa], None where the path met none."""
        limit = self._limit(anchor, rest)
        return limit.pressure if limit is not None else None

    def _limit(self, anchor: Anchor, rest: Path | None) -> Equilibrium | None:
        """The pressure's maximum: of the part that this mesh followed itself; on the part shared,
        at the coarse maximum's volume, for there the pressure hardly depends on the volume."""
        coarse = self._path.limit
        if rest is not None or coarse is None or not self._path.by_volume:
            return rest.limit if rest is not None else None
        start = _prolong(self._coarse, self._fine, coarse.state)
        start = start.moved(1.0, _minus(anchor.found.state, self._starts[-1]))
        return self._solve(start, Target(coarse.pressure, volume=coarse.volume))

    def whole_path(self, anchor: Anchor, rest: Path | None, accuracy: float = 0.0) -> Refined:
        """All points, then ``rest``. From the first point and the anchor inwards, points are solved
        until the correction interpolated between solved ones meets a solved one within a tenth
        of ``accuracy``; each is started with that interpolation."""
        last = self.shared - 1
        found: dict[int, Equilibrium] = {**self._marched, last: anchor.found}
        if last > 0 and self._solve_point(0, found) is not None:
            spans = [(0, last)]
            while spans and self._stop() is None:
                low, high = spans.pop(0)
                middle = self._middle(low, high)
                if middle in (low, high) or middle in found:
                    continue
                off = self._solve_point(middle, found)
                if off is not None and off > accuracy / 10:
                    spans += [(low, middle), (middle, high)]
                self._watch(len(found) / self.shared)
        return self._assemble(found, rest, self._limit(anchor, rest))

    def _middle(self, low: int, high: int) -> int:
        """Point nearest to the middle of a span in cavity volume."""
        volume = [e.volume for e in self._path.points[low : high + 1]]
        return low + int(np.argmin(np.abs(np.array(volume) - (volume[0] + volume[-1]) / 2)))

    def _solve_point(self, index: int, found: dict[int, Equilibrium]) -> float | None:
        """Solve one point from the known ones and add it; how far the interpolation was off, as a
        fraction of the largest displacement, or of what inflation makes of it if that is less: a
        body that sags far moves little by it. None where no equilibrium was found."""
        if index in found:
            return 0.0
        start = self._interpolated(index, found)
        result = self._at(index, start)
        if result is None and self._stop() is None:
            result = self._at(index, self._starts[index])
        if result is None:
            return None
        found[index] = result
        exact = result.state.displacement
        size = min(float(np.abs(exact).max()), self._way)
        return float(np.abs(start.displacement - exact).max()) / size if size > 0 else 0.0

    def _interpolated(self, index: int, found: dict[int, Equilibrium]) -> State:
        """The coarse state with the correction interpolated between solved points, by volume."""
        known = sorted(found)
        at = np.array([self._path.points[i].volume for i in known])
        order = np.argsort(at)
        weights = _hats(at[order], self._path.points[index].volume)
        state = self._starts[index]
        for weight, number in zip(weights, order, strict=True):
            if weight != 0.0:
                near = known[number]
                state = state.moved(weight, _minus(found[near].state, self._starts[near]))
        return state

    def _at(self, index: int, start: State) -> Equilibrium | None:
        point = self._path.points[index]
        by_volume = self._path.by_volume and index > 0
        target = Target(point.pressure, volume=point.volume if by_volume else None)
        return self._solve(start, target)

    def _solve(self, start: State, target: Target) -> Equilibrium | None:
        result = solve_equilibrium(
            self._fine, self._solver, start, target,
            cancelled=lambda: self._stop() is not None, lenience=MONOTONE,
        )  # fmt: skip
        self.iterations += result.iterations
        return result if isinstance(result, Equilibrium) else None

    def _assemble(
        self, found: dict[int, Equilibrium], rest: Path | None, limit: Equilibrium | None
    ) -> Refined:
        points: list[Equilibrium] = []
        for index in range(self.shared):
            if index in found:
                points.append(found[index])
                continue
            state = self._interpolated(index, found)
            volume, _ = self._fine.volume(state)
            pressure = self._interpolated_pressure(index, found)
            points.append(Equilibrium(state, pressure, volume, 0, None))
        last = self._path if rest is None else rest
        solved = len(found)
        if rest is not None:
            points += rest.points
            solved += len(rest.points)
        return Refined(replace(last, points=points, limit=limit), solved)

    def _interpolated_pressure(self, index: int, found: dict[int, Equilibrium]) -> float:
        """A point's pressure: as it was prescribed, or corrected as the states are."""
        coarse = self._path.points
        if not self._path.by_volume:
            return coarse[index].pressure
        known = sorted(found, key=lambda i: coarse[i].volume)
        change = [found[i].pressure - coarse[i].pressure for i in known]
        at = [coarse[i].volume for i in known]
        return coarse[index].pressure + float(np.interp(coarse[index].volume, at, change))


def shared_points(path: Path) -> int:
    """Number of points that every mesh can be expected to have: all, or those well before the
    path's early end or the turn of its volume."""
    count = len(path.points) - path.by_arc
    if path.outcome is Outcome.CONVERGED and path.by_arc == 0:
        return count
    first = path.points[0]
    done = [
        abs(e.volume - first.volume) if path.by_volume else abs(e.pressure)
        for e in path.points[:count]
    ]
    return max(1, sum(share <= NEAR_LIMIT * done[-1] for share in done))


def _prolong(coarse: ContinuumSystem, fine: ContinuumSystem, state: State) -> State:
    return State(
        prolong_nodes(coarse.mesh, fine.mesh) @ state.displacement,
        prolong_pressure(coarse.mesh, fine.mesh, state.pressure),
        prolong_sheet_force(coarse.mesh, fine.mesh, state.sheet),
    )


def _hats(at: np.ndarray, where: float) -> np.ndarray:
    """Weights of piecewise linear interpolation at ``where`` between increasing ``at``."""
    return np.array([np.interp(where, at, row) for row in np.eye(len(at))])


def _minus(a: State, b: State) -> State:
    return a.moved(-1.0, b)
