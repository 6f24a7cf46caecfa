"""What one chamber pitch does at finite strain while it is inflated: the rod law of the interior.

:class:`CellPath` is the answer, :func:`inflate_cell` computes it with the 3D solver's elements
(loaded only then).
"""

from dataclasses import dataclass, field

import numpy as np

from actuators.geometry import Body
from actuators.materials import Material
from actuators.mechanics.cell.periodic import CellMesh
from actuators.mechanics.response import Outcome


@dataclass(frozen=True, eq=False)
class CellPath:
    """One pitch of an endless actuator over pressure: k points, from zero pressure on, in order.

    Rod strains are (stretch, torsion, bending about X2, bending about X3) of the line
    X2 = X3 = 0 per undeformed length, finite: the line is an exact piece of helix, and
    ``rod.equilibrium.shape`` gives its shape. Resultants (force along the line, moments about the
    section's X1, X2, X3) work on them.

    ``pressure``: (k,) [Pa]; ``strain``: (k, 4) in equilibrium without resultants; ``strain_rate``:
    (k, 4) its change per pressure along the path, so that cubics can be laid through the points;
    ``stiffness``: (k, 4, 4) tangent, resultants per strain [N, N m, N m2]; ``volume``: (k,) of the
    cavity per pitch [m3]; ``volume_rate``: (k, 4) its change with the strains at constant pressure
    [m3, m4]; ``compliance``: (k,) its change per pressure along the path [m3/Pa]; ``max_stretch``:
    (k,) largest principal stretch at a Gauss point, ``region_stretch``: (k, r) of each of the
    body's regions; ``contact_pressure``: (k,) largest between the walls of neighbouring chambers
    [Pa], None where none face each other or contact was left out; ``touching_from``: pressure at
    which they meet [Pa], None where they do not; ``wrinkles_from``: pressure [Pa] from which on an
    embedded layer without stiffness against bending would wrinkle, None where it would not;
    ``period``: undeformed pitch [m].

    ``outcome``: ``converged``; ``limit_point``, where the pressure has a maximum (of suction, a
    minimum) and the last point stands there; ``stalled``, where no further point was found.
    ``limit_pressure``: that maximum [Pa], also where it lies up to a quarter beyond the end.
    ``iterations``: tangents factorised; ``notes``: what a reader of the result must know.
    """

    period: float
    pressure: np.ndarray
    strain: np.ndarray
    strain_rate: np.ndarray
    stiffness: np.ndarray
    volume: np.ndarray
    volume_rate: np.ndarray
    compliance: np.ndarray
    max_stretch: np.ndarray
    region_stretch: np.ndarray
    contact_pressure: np.ndarray | None = None
    touching_from: float | None = None
    wrinkles_from: float | None = None
    outcome: Outcome = Outcome.CONVERGED
    limit_pressure: float | None = None
    unknowns: int = 0
    iterations: int = 0
    wall_s: float = 0.0
    notes: tuple[str, ...] = field(default_factory=tuple)


def inflate_cell(
    body: Body,
    materials: tuple[Material, ...],
    *,
    pressure_to: float,
    mesh: CellMesh | None = None,
    contact: bool = True,
) -> CellPath:
    """Path of the periodic cell ``body`` (of ``geometry.build_cell``) from rest to ``pressure_to``
    [Pa], negative for suction, or to the pressure's maximum before it. Walls of neighbouring
    chambers press on each other without friction; without ``contact`` they run through each other.

    ``materials`` by region; ``mesh``: elements per interval, None for the linear cell's own. Not
    reaching the end is a result: see ``CellPath.outcome``.
    """
    from actuators.mechanics.cell.helical.inflate import inflate

    return inflate(body, materials, pressure_to, mesh, contact=contact)
