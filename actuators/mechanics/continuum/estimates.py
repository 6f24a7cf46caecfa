"""How far an answer may be from the exact one, judged by the changes between nested meshes."""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.continuum.contact import SelfContact
from actuators.mechanics.continuum.contact.report import obstacle_force
from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.sections import rod_shape
from actuators.mechanics.continuum.system import ContinuumSystem

SAFETY = 1.25
"""Factor on what a change tells; see docs/performance.md for true errors beside estimates."""
UNSEEN = 0.01
UNSEEN_GROWTH = 0.06
"""What each direction that was not refined may hide, whatever the change: 1 % of the judged
quantities and 6 % of the cavity's growth (oblique-90 hides that much in the third)."""
UNSEEN_WHERE_WALLS_MEET = 0.06
"""What each direction not refined may hide of the judged quantities where walls press on each
other: two chambers of oblique-90 hide 11 % in the third and first when the second is refined."""
JUDGED = ("tip", "angle", "force", "limit_pressure")
"""Quantities that must be as accurate as asked for; the cavity's growth is estimated only."""


@dataclass(frozen=True, eq=False)
class Measured:
    """One mesh's answer at the path's last shared point: ``tip`` displacement (3,) [m], ``angle``
    by which the free end has turned [rad], ``growth`` of the cavity [m3]; ``force`` on an
    obstacle [N] and ``limit_pressure`` [Pa] where there are such; ``walls_meet``: the body presses
    on itself."""

    tip: np.ndarray
    angle: float
    growth: float
    size: float
    rest_volume: float
    force: float | None = None
    limit_pressure: float | None = None
    walls_meet: bool = False


def measure(
    system: ContinuumSystem, found: Equilibrium, limit_pressure: float | None = None
) -> Measured:
    """What is compared between meshes."""
    mesh = system.mesh
    rest, _ = system.volume(system.rest())
    positions = mesh.nodes + found.state.displacement
    return Measured(
        tip=found.state.displacement[mesh.underside_line[-1]],
        angle=float(rod_shape(mesh, [found.state]).tip_rotation[0]),
        growth=found.volume - rest,
        size=float(np.ptp(mesh.nodes[:, 0])),
        rest_volume=rest,
        force=obstacle_force(system, found),
        limit_pressure=limit_pressure,
        walls_meet=any(
            isinstance(each, SelfContact) and each.largest_pressure(positions) > 0.0
            for each in system.interactions
        ),
    )


def change(before: Measured, after: Measured) -> dict[str, float]:
    """Differences as fractions of the later answer. An angle is held against at least the tip's
    displacement over the length, a growth against at least a thousandth of the volume at rest: a
    body that does not turn has no relative error of turning."""
    travel = float(np.linalg.norm(after.tip))
    turn = max(abs(after.angle), travel / after.size)
    growth = max(abs(after.growth), 1e-3 * after.rest_volume)
    found = {
        "tip": _share(float(np.linalg.norm(after.tip - before.tip)), travel),
        "angle": _share(abs(after.angle - before.angle), turn),
        "volume": _share(abs(after.growth - before.growth), growth),
    }
    for name in ("force", "limit_pressure"):
        old, new = getattr(before, name), getattr(after, name)
        if old is not None and new is not None:
            found[name] = _share(abs(new - old), max(abs(old), abs(new)))
    return found


def _share(difference: float, size: float) -> float:
    return difference / size if size > 0.0 else 0.0


def estimates(
    last: dict[str, float], layers: tuple[int, int, int], *, walls_meet: bool = False
) -> dict[str, float]:
    """Estimated errors of an answer as fractions, from its change against the mesh before.

    Meshes are refined in one direction after the other, and a change tells nothing about
    directions not refined yet: each of those is taken to owe as much again.
    """
    unseen = sum(n == 0 for n in layers)
    hidden = UNSEEN_WHERE_WALLS_MEET if walls_meet else UNSEEN
    return {
        name: max(
            SAFETY * (1 + unseen) * value,
            unseen * (UNSEEN_GROWTH if name == "volume" else hidden),
        )
        for name, value in last.items()
    }
