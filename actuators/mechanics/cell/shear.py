"""How a chamber pitch gives way to a transverse force: the shear compliance of the rod.

A rod in bending knows no shear. A row of chambers does: between the walls, floor and roof bend
like the rungs of a ladder. Under a force V along X3 the moment grows linearly along the row,
M = V X1. With u_b = F e + w the periodic answer to the moment 1 (:mod:`.periodic`; e are the rod
strains, w the correction), the displacement is

    u = B + X1 w + v,      B: strains X1 e of the rod's fields, v periodic,

because one pitch on it is the same plus (pitch) u_b and a rigid motion. Forces on the faces between
pitches count half of what the next pitch adds. The energy of a pitch beyond what a rod that only
bends has, V^2/2 of it, is the shear compliance.
"""

import numpy as np

from actuators.geometry import Body
from actuators.materials import Material
from actuators.mechanics.cell import element
from actuators.mechanics.cell.lattice import HalfCell, half_cell
from actuators.mechanics.cell.numbering import numbering
from actuators.mechanics.cell.periodic import EVEN, box_moments, cell_elements, rod_fields

_LOCAL = np.arange(element.NODES)
_LEFT, _RIGHT = _LOCAL % 3 == 0, _LOCAL % 3 == 2
BENDING = 2
SHEAR_SHARE = 5 / 6
"""Timoshenko's share of a rectangle that bears transverse shear."""
_GRADED = [0.2, 0.6, 0.2]


def shear_compliance(body: Body, materials: tuple[Material, ...], *, graded: bool = True) -> float:
    """Shear angle per transverse force along X3, mean over the pitch [rad/N]. ``materials`` by
    region; not ``graded``: one element per interval, 6 % too soft for a slab."""
    if body.period is None:
        raise ValueError("a cell needs a period")
    cell = half_cell(body, _parts(body, graded=graded), rolled=False)
    shear = np.array([m.shear_modulus for m in materials])
    bulk = np.array([m.finite_bulk_modulus for m in materials])
    elements = cell_elements(cell, shear, bulk)
    position = cell.coordinates()[cell.solid]
    fields = rod_fields(position)[..., EVEN]

    even = numbering(cell, "even")
    coupling = elements @ fields
    right = -even.gather(coupling, cell.solid)
    correction = even.solve(elements, cell.solid, right)
    energy = np.einsum("nai,naj->ij", fields, coupling)
    stiffness = 2 * (energy - right.T @ correction) / body.period
    compliance = np.linalg.inv(stiffness)
    strain = compliance[:, BENDING]
    periodic = even.spread(correction @ strain)[cell.solid]
    bent = fields @ strain + periodic

    along = np.repeat(position[..., 0], 3, axis=-1)
    start = _growing_fields(position)[..., EVEN] @ strain + along * periodic
    force = (elements @ start[..., None])[..., 0]
    force += body.period / 2 * _between_pitches(cell, (elements @ bent[..., None])[..., 0])
    odd = numbering(cell, "odd")
    answer = odd.solve(elements, cell.solid, -odd.gather(force[..., None], cell.solid))
    motion = start + odd.spread(answer[:, 0])[cell.solid]
    whole = float(np.einsum("na,nab,nb->", motion, elements, motion))  # twice the half's energy
    bending = float(compliance[BENDING, BENDING]) * body.period**3 / 12
    return (2 * whole - bending) / body.period


def sideways_shear(body: Body, materials: tuple[Material, ...]) -> float:
    """Stiffness against shear along X2 [N]. Sideways a chamber is a wide beam, whose shear hardly
    shows where nothing else bears it: that of its mean section will do."""
    modulus = np.array([m.shear_modulus for m in materials] + [0.0])
    volume = box_moments(body)[..., 0]
    whole = float((modulus[np.maximum(body.fill, -1)] * volume).sum())
    return SHEAR_SHARE * whole / float(body.period or 1.0)


def _between_pitches(cell: HalfCell, bent: np.ndarray) -> np.ndarray:
    """Of the forces (m, 81) on solid elements, those on the faces to the next pitch (against them)
    and to the one before."""
    nx = cell.shape[0] // 2
    column = (np.arange(len(cell.fill)) // (len(cell.fill) // nx))[cell.solid]
    forces = bent.reshape(-1, element.NODES, 3).copy()
    kept = np.zeros_like(forces)
    first, last = column == 0, column == nx - 1
    kept[np.ix_(first, _LEFT)] = forces[np.ix_(first, _LEFT)]
    kept[np.ix_(last, _RIGHT)] -= forces[np.ix_(last, _RIGHT)]
    return kept.reshape(bent.shape)


def _growing_fields(position: np.ndarray) -> np.ndarray:
    """Displacement of rod strains that grow along X1 as X1 does, at nodes (n, 27, 3) [m], shape
    (n, 81, 4)."""
    x, y, z = np.moveaxis(position, -1, 0)
    field = np.zeros((*position.shape, 4))
    field[..., 0, 0] = x * x / 2
    field[..., 1, 1] = -x * x * z / 2
    field[..., 2, 1] = x * x * y / 2
    field[..., 0, 2] = x * x * z / 2
    field[..., 2, 2] = -x * x * x / 6
    field[..., 0, 3] = -x * x * y / 2
    field[..., 1, 3] = x * x * x / 6
    return field.reshape(len(position), 3 * element.NODES, 4)


def _parts(body: Body, *, graded: bool) -> list[list[list[float]]]:
    """Two elements across every height, three along every chamber and wall, thin at its ends, where
    floor and roof are held; curved cells as they are."""
    x, y, z = body.lines
    parts = [[[1.0]] * (len(line) - 1) for line in (x, np.append(0.0, y[y > 0]), z)]
    if graded and not body.curved:
        parts[0] = [_GRADED] * len(parts[0])
        parts[2] = [[0.5, 0.5]] * len(parts[2])
    return parts
