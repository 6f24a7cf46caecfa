"""Equilibria of a loaded rod over a list of laws, one for every pressure."""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.rod.chain import Chain, Law, Obstacles
from actuators.mechanics.rod.kinematics import sheared_shape
from actuators.mechanics.rod.settle import settle
from actuators.mechanics.rod.solve import RodPath
from actuators.mechanics.rod.touching import obstacle_forces

_SOFTER = (1e3, 1e2, 10.0, 1.0)  # an obstacle met at once is met softly first
_FIRST_SHARE, _SMALLEST_SHARE = 1 / 4, 1 / 64  # of loads that cannot be put on at once


@dataclass(frozen=True, eq=False)
class LoadedPath(RodPath):
    """``obstacle_force``: (k, o, 3) of the rod on every obstacle [N]; ``penetration``: (k, o)
    [m]; ``loads``: share of weight and outer loads that could be put on; below 1 the path is the
    one shape under that share."""

    obstacle_force: np.ndarray
    penetration: np.ndarray
    loads: float = 1.0


@dataclass(frozen=True, eq=False)
class Laws:
    """Laws of s pieces at k pressures: ``free`` (k, s, 6) rod strains without resultants,
    ``stiffness`` (k, s, 6, 6) tangent resultants per strain, ``bent`` (k, s) growth of the bending
    compliance with the moment, ``parted`` and ``release`` (k, s, 6) of walls that loads can part,
    None where there are none; see :mod:`.chain`."""

    free: np.ndarray
    stiffness: np.ndarray
    bent: np.ndarray
    parted: np.ndarray | None = None
    release: np.ndarray | None = None

    def at(self, n: int) -> Law:
        """The n-th, as the compiled code takes it."""
        stiffness = np.ascontiguousarray(self.stiffness[n])
        free, bent = np.ascontiguousarray(self.free[n]), np.ascontiguousarray(self.bent[n])
        compliance = np.linalg.inv(stiffness)
        if self.parted is None or self.release is None:
            none = np.zeros_like(free)
            return Law(free, stiffness, compliance, bent, none, none, stiffness)
        parted = np.ascontiguousarray(self.parted[n])
        release = np.ascontiguousarray(self.release[n])
        apart = np.linalg.inv(compliance + parted[:, :, None] * release[:, None, :])
        return Law(free, stiffness, compliance, bent, parted, release, apart)


def follow_laws(laws: Laws, chain: Chain, obstacles: Obstacles) -> LoadedPath:
    """Equilibrium under every law, each begun from the last; the path ends before the first that
    has none. Where that is the first of all, it holds the shape under the largest share of the
    loads that was found, at worst the unloaded one."""
    found: list[np.ndarray] = []
    total, loads = 0, 1.0
    before: Law | None = None
    for n in range(len(laws.free)):
        law = laws.at(n)
        count, strain, share = _next(found, laws.free, before, law, chain, obstacles)
        total += count
        if share < 1.0 and n > 0:
            break
        found.append(strain)
        before, loads = law, share
        if share < 1.0:
            break
    shapes = [sheared_shape(e, chain.length) for e in found]
    s, o = len(chain.length), len(obstacles.kind)
    pressed = [obstacle_forces(x[::2], r[::2], obstacles) for x, r in shapes]
    return LoadedPath(
        strains=np.array(found).reshape(-1, s, 6),
        positions=np.array([x[::2] for x, _ in shapes]).reshape(-1, s + 1, 3),
        frames=np.array([r[::2] for _, r in shapes]).reshape(-1, s + 1, 3, 3),
        iterations=total,
        obstacle_force=np.array([force for force, _ in pressed]).reshape(len(found), o, 3),
        penetration=np.array([depth for _, depth in pressed]).reshape(len(found), o),
        loads=loads,
    )


def _next(
    found: list[np.ndarray], free: np.ndarray, before: Law | None, law: Law, chain: Chain,
    obstacles: Obstacles,
) -> tuple[int, np.ndarray, float]:  # fmt: skip
    """Equilibrium under ``law``: ahead of the last ones; if not so, from the last one in smaller
    steps; if not so, from the free rod with the loads in shares. Iterations, the strains, and under
    which share of the loads they are: the largest found."""
    n = len(found)
    held = [strain - free[k] for k, strain in enumerate(found)][-2:]
    start = free[n] + sum(held[-1:], np.zeros(1))
    ahead = start + held[1] - held[0] if len(held) == 2 else start
    total, strain = _meet(ahead, chain, law, obstacles)
    if strain is not None:
        return total, strain, 1.0
    if before is not None:
        for parts in (2, 8, 32):
            count, strain = _between(found[-1], before, law, parts, chain, obstacles)
            total += count
            if strain is not None:
                return total, strain, 1.0
    most, share, step = law.free, 0.0, _FIRST_SHARE
    while share < 1.0 and step >= _SMALLEST_SHARE:
        count, strain = _meet(most, chain.scaled(share + step), law, obstacles)
        total += count
        if strain is None:
            step /= 4
        else:
            most, share = strain, share + step
    return total, most, share


def _between(
    strain: np.ndarray | None, before: Law, law: Law, parts: int, chain: Chain,
    obstacles: Obstacles,
) -> tuple[int, np.ndarray | None]:  # fmt: skip
    """From equilibrium under the law ``before`` to that under ``law`` in equal steps."""
    total, ahead = 0, (law.free - before.free) / parts
    for part in range(1, parts + 1):
        if strain is None:
            return total, None
        t = part / parts
        mixed = Law(*(a * (1 - t) + b * t for a, b in zip(before, law, strict=True)))
        count, strain = _meet(strain + ahead, chain, mixed, obstacles)
        total += count
    return total, strain


def _meet(
    start: np.ndarray, chain: Chain, law: Law, obstacles: Obstacles
) -> tuple[int, np.ndarray | None]:
    """Equilibrium near ``start`` (s, 6); where obstacles prevent it, first with softer ones."""
    strain = start.copy()
    total, found = settle(strain, chain, law, obstacles)
    if found:
        return total, strain
    if len(obstacles.kind) > 0:
        strain = start.copy()
        for soft in _SOFTER:
            count, found = settle(strain, chain, law, obstacles.softened(soft))
            total += count
            if not found:
                return total, None
        return total, strain
    return total, None
