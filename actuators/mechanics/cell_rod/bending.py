"""How a chamber gives way as loads bend it: two more equilibria of the periodic cell.

Soft bodies droop by their weight alone until their floor is pressed and their roof drawn out, which
a law tangent to the straight chamber does not know. At rest the cell is put under the moments +M
and -M about X2. With its curvatures k(+M), k(-M), the linear one being C M,

    k = C M + c M^2/2,      c = (k(+M) + k(-M)) / M^2.

What is reported is c / C^2, the growth of the compliance per curvature relative to itself: 2 % per
1/m for slabs with stiff floors, which soften as they bend towards them, less for others.
"""

from dataclasses import dataclass

import numpy as np

from actuators.geometry import Body
from actuators.materials import Material
from actuators.mechanics.cell.periodic import coarse_mesh

BENDING = 2
STRAIN = 0.04
"""Strain at the body's top at which the growth is measured, by the linear law."""


@dataclass(frozen=True)
class BendingChange:
    """``growth``: of the bending compliance per curvature, relative [m]; ``iterations``: tangents
    factorised; ``missing``: why there is none (then 0), empty where there is."""

    growth: float
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
    linear = STRAIN / float(body.lines[2][-1] - body.lines[2][0])
    moment = linear / float(np.linalg.inv(stiffness)[BENDING, BENDING])
    curvatures: list[float] = []
    for sign in (1.0, -1.0):
        resultants = np.zeros(4)
        resultants[BENDING] = sign * moment
        found = solver.solve(solver.system.rest(), Target(0.0, resultants=resultants, held=True))
        if isinstance(found, Missed):
            return BendingChange(
                0.0, solver.tangents,
                f"The chamber bent by loads was not found ({found.reason}): bending is taken to be "
                "as stiff under load as without.",
            )  # fmt: skip
        curvatures.append(float(found.state.strain[BENDING]))
    return BendingChange(sum(curvatures) / linear**2, solver.tangents)
