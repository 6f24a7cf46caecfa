"""Equilibria of a loaded rod over a list of laws, one for every pressure."""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.rod.chain import Chain, Law, Obstacles
from actuators.mechanics.rod.kinematics import BEND, sheared_shape
from actuators.mechanics.rod.settle import settle
from actuators.mechanics.rod.solve import RodPath
from actuators.mechanics.rod.touching import obstacle_forces

_SOFTER = (1e3, 1e2, 10.0, 1.0)  # an obstacle met at once is met softly first
SOFTEST = 0.7
"""Share of its stiffness against bending that bending may take from a piece."""
ANYTHING = 1e30
"""A curvature [1/m] that bounds none."""
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
    ``stiffness`` (k, s, 6, 6) tangent resultants per strain, ``bent`` (s, 2) how the
    bending stiffness falls with the curvature, a and b, ``parted`` and ``release`` (k, s, 6) of
    walls that loads can part, None where there are none; see :mod:`.chain`."""

    free: np.ndarray
    stiffness: np.ndarray
    bent: np.ndarray
    parted: np.ndarray | None = None
    release: np.ndarray | None = None

    def at(self, n: int) -> Law:
        """The n-th, as the compiled code takes it."""
        stiffness = np.ascontiguousarray(self.stiffness[n])
        free = np.ascontiguousarray(self.free[n])
        compliance = np.linalg.inv(stiffness)
        if self.parted is None or self.release is None:
            none = np.zeros_like(free)
            bent = believed(self.bent, compliance, stiffness, stiffness)
            return Law(free, stiffness, compliance, bent, none, none, stiffness)
        parted = np.ascontiguousarray(self.parted[n])
        release = np.ascontiguousarray(self.release[n])
        apart = np.linalg.inv(compliance + parted[:, :, None] * release[:, None, :])
        bent = believed(self.bent, compliance, stiffness, apart)
        return Law(free, stiffness, compliance, bent, parted, release, apart)


def believed(
    bent: np.ndarray, compliance: np.ndarray, stiffness: np.ndarray, apart: np.ndarray
) -> np.ndarray:
    """(s, 4) with ``bent`` (s, 2) the range of curvatures in which the stiffness it leaves is
    between a part and a multiple of that of the straight piece, and the law is stable."""
    much = compliance[:, BEND, BEND] * np.maximum(stiffness, apart)[:, BEND, BEND] - 1
    most = np.full(len(bent), SOFTEST)
    least = -SOFTEST / np.maximum(much, 1.0)
    ends = np.stack([_roots(3 * bent[:, 1], bent[:, 0], -end) for end in (most, least)])
    ends = np.moveaxis(ends, 0, -1).reshape(len(bent), -1)
    low = np.where(ends < 0.0, ends, -ANYTHING).max(axis=-1)
    high = np.where(ends > 0.0, ends, ANYTHING).min(axis=-1)
    return np.concatenate([bent, low[:, None], high[:, None]], axis=1)


def _roots(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Real roots (s, 2) of a x^2 + b x + c with c not 0; 0 where there is none."""
    square = b * b - 4 * a * c
    real = square >= 0.0
    q = -(b + np.where(b >= 0.0, 1.0, -1.0) * np.sqrt(np.where(real, square, 0.0))) / 2
    first = np.divide(q, a, out=np.zeros_like(q), where=real & (a != 0.0))
    second = np.divide(c, q, out=np.zeros_like(q), where=real & (q != 0.0))
    return np.stack([first, second], axis=-1)


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
