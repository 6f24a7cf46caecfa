"""How a chamber gives way as loads bend it: two more equilibria of the periodic cell.

Soft bodies droop by their weight alone until their floor is pressed and their roof drawn out, which
a law tangent to the straight chamber does not know. At rest the cell is put under the moments +M
and -M about X2. With C the linear compliance and k the curvature,

    C M = k - a k^2/2 - b k^3:

the stiffness falls with the curvature, nearly as its first power in slabs (2 % per 1/m towards
their stiff floors), by its square too in bellows. Told by the moment instead, k = C M + c M^2/2,
the same two equilibria miss 5 % of a slab that hangs down (20/m, a quarter of strain at its top).
"""

from dataclasses import dataclass

import numpy as np

from actuators.geometry import Body
from actuators.materials import Material
from actuators.mechanics.cell.periodic import coarse_mesh

BENDING = 2
STRAINS = (0.1, 0.04)
"""Strain at the body's top at which the change is measured, by the linear law: the first at which
both equilibria are found."""


@dataclass(frozen=True)
class BendingChange:
    """``growth``: a [m] and ``further``: b [m2]; ``iterations``: tangents factorised; ``missing``:
    why there are none (then 0), empty where there are."""

    growth: float
    further: float
    iterations: int
    missing: str = ""


def bending_change(
    body: Body, materials: tuple[Material, ...], stiffness: np.ndarray
) -> BendingChange:
    """Of the cell at rest; ``stiffness``: (4, 4) its linear one."""
    from actuators.mechanics.cell.helical.domain import half_pitch
    from actuators.mechanics.cell.helical.newton import Missed, Solver
    from actuators.mechanics.cell.helical.system import CellSystem
    from actuators.mechanics.cell.helical.tangent import Target

    solver = Solver(CellSystem(half_pitch(body, coarse_mesh(body)), materials))
    height = float(body.lines[2][-1] - body.lines[2][0])
    soft = float(np.linalg.inv(stiffness)[BENDING, BENDING])
    reason = ""
    for strain in STRAINS:
        ways: list[tuple[float, float]] = []
        for linear in (strain / height, -strain / height):
            resultants = np.zeros(4)
            resultants[BENDING] = linear / soft
            target = Target(0.0, resultants=resultants, held=True)
            found = solver.solve(solver.system.rest(), target)
            if isinstance(found, Missed):
                reason = found.reason
                break
            curvature = float(found.state.strain[BENDING])
            ways.append((curvature, 2 * (curvature - linear) / curvature**2))
        if len(ways) == 2:
            (far, growth), (back, shrinkage) = ways
            # 2 (k - C M)/k^2 = a + 2 b k on either side
            further = (growth - shrinkage) / (2 * (far - back))
            return BendingChange(growth - 2 * further * far, further, solver.tangents)
    return BendingChange(
        0.0, 0.0, solver.tangents,
        f"The chamber bent by loads was not found ({reason}): bending is taken to be as stiff "
        "under load as without.",
    )  # fmt: skip
