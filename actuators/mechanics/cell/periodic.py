"""One linear solve of a periodic chamber: what pressure does to it, and its stiffness as a rod.

Small-strain displacement of a rod with constant strains e plus a periodic correction. With X1, X2,
X3 from the chamber's vertical middle axis and the underside,

    stretch e0      (X1, 0, 0)
    torsion e1      (0, -X1 X3, X1 X2)
    bending e2      (X1 X3, 0, -X1^2/2)     positive towards -X3
    bending e3      (-X1 X2, X1^2/2, 0)

whose strains do not depend on X1, so the correction repeats from chamber to chamber. The four e are
unknowns like any other; without resultant forces they are the free response. Pressure works on the
change of the cavity's volume, open ends of the air channel included: what closes them at either end
of the actuator feels the same pressure.
"""

from dataclasses import dataclass

import numpy as np

from actuators.geometry import CAVITY, OUTSIDE, Body
from actuators.materials import Material
from actuators.mechanics.cell import curved, element
from actuators.mechanics.cell.gap import wall_closing
from actuators.mechanics.cell.lattice import HalfCell, curved_nodes, divide, half_cell, intervals
from actuators.mechanics.cell.numbering import numbering
from actuators.mechanics.cell.sheet import BOTTOM_FACE, TOP_FACE, add_sheets

EVEN = (0, 1, 2)
"""Rod strains that the half turn leaves unchanged; bending about X3 stands alone."""


@dataclass(frozen=True, eq=False)
class CellResponse:
    """One chamber pitch as a piece of rod. Rod strains are (stretch, torsion, bending about X2,
    bending about X3) of the line X2 = X3 = 0; resultants (force along X1, moments about X1, X2, X3)
    work on them.

    ``period``: pitch [m]; ``free``: (4,) rod strains per pressure [1/Pa, 1/(Pa m)]; ``stiffness``:
    (4, 4) resultants per rod strain, mean over the pitch [N, N m, N m2]; ``cavity_volume`` [m3]
    undeformed; ``cavity_compliance``: growth of the cavity per pressure [m3/Pa], coarser than the
    rest (13 % above the refined whole body for oblique-90); ``largest_strain``: largest principal
    strain per pressure, mean over an element [1/Pa]; ``unknowns`` of the solve.
    """

    period: float
    free: np.ndarray
    stiffness: np.ndarray
    cavity_volume: float
    cavity_compliance: float
    largest_strain: float
    gap_closing: float
    unknowns: int


@dataclass(frozen=True)
class CellMesh:
    """Elements per interval along (x, y, z), as :func:`.lattice.intervals` lists the intervals."""

    even: tuple[tuple[int, ...], ...]
    odd: tuple[tuple[int, ...], ...]


def solve_cell(body: Body, materials: tuple[Material, ...], mesh: CellMesh) -> CellResponse:
    """Response and rod stiffness of the periodic cell ``body``; ``materials`` by region."""
    if body.period is None:
        raise ValueError("a cell needs a period")
    shear = np.array([m.shear_modulus for m in materials])
    bulk = np.array([m.finite_bulk_modulus for m in materials])

    cell = half_cell(body, _equal_parts(mesh.even))
    fields = rod_fields(cell.coordinates())
    elements, energy, coupling = _element_energies(cell, fields, shear, bulk)
    if cell.position is None:
        pressure = element.divergence(cell.jacobian[cell.cavity])[:, 0, :, None]
    else:
        pressure = curved.divergence(cell.position[cell.cavity])[:, 0, :, None]
    even = numbering(cell, "even")
    right = np.concatenate(
        [even.gather(pressure, cell.cavity), -even.gather(coupling[..., EVEN], cell.solid)], axis=1
    )
    correction = even.solve(elements, cell.solid, right)
    condensed = np.zeros((4, 4))
    condensed[np.ix_(EVEN, EVEN)] = energy[np.ix_(EVEN, EVEN)] - right[:, 1:].T @ correction[:, 1:]
    work = np.einsum("nai,na->i", fields[cell.cavity], pressure[..., 0])
    load = np.zeros(4)
    load[list(EVEN)] = work[list(EVEN)] + right[:, 1:].T @ correction[:, 0]
    condensed[3, 3] = _bending_about_x3(body, shear, bulk, mesh)

    free = np.linalg.solve(condensed, load)  # both for the half cell
    growth = float(right[:, 0] @ correction[:, 0] + load @ free)
    motion = correction[:, 0] + correction[:, 1:] @ free[list(EVEN)]
    everywhere = even.spread(motion) + fields @ free
    # the growth of a volume under a uniform swelling of 1 is three times the volume
    air = np.einsum("nai,nai->", cell.coordinates()[cell.cavity],
                    pressure.reshape(-1, element.NODES, 3)) / 3  # fmt: skip
    return CellResponse(
        period=body.period,
        free=free,
        stiffness=2 * condensed / body.period,
        cavity_volume=float(2 * air),
        cavity_compliance=2 * growth,
        largest_strain=_largest_strain(cell, everywhere[cell.solid]),
        gap_closing=wall_closing(cell, body.period, everywhere, free),
        unknowns=even.count,
    )


def _bending_about_x3(body: Body, shear: np.ndarray, bulk: np.ndarray, mesh: CellMesh) -> float:
    """Stiffness of the half cell against bending about X3, per curvature squared [N m3]."""
    cell = half_cell(body, _equal_parts(mesh.odd))
    fields = rod_fields(cell.coordinates())
    elements, energy, coupling = _element_energies(cell, fields, shear, bulk)
    odd = numbering(cell, "odd")
    right = -odd.gather(coupling[..., 3:], cell.solid)
    correction = odd.solve(elements, cell.solid, right)
    return float(energy[3, 3] - right[:, 0] @ correction[:, 0])


def _element_energies(
    cell: HalfCell, fields: np.ndarray, shear: np.ndarray, bulk: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of the solid elements: stiffness (m, 81, 81), energy of the rod strains (4, 4), forces that
    they raise (m, 81, 4)."""
    elements = cell_elements(cell, shear, bulk)
    solid = fields[cell.solid]
    coupling = elements @ solid
    energy = np.tensordot(solid, coupling, axes=([0, 1], [0, 1]))
    return elements, energy, coupling


def cell_elements(cell: HalfCell, shear: np.ndarray, bulk: np.ndarray) -> np.ndarray:
    """Stiffness (m, 81, 81) of the solid elements, embedded sheets included; moduli by region."""
    region = cell.fill[cell.solid]
    if cell.position is None:
        elements = element.stiffness(cell.jacobian[cell.solid], shear[region], bulk[region])
    else:
        elements = curved.stiffness(cell.position[cell.solid], shear[region], bulk[region])
    if cell.sheets.any():
        position = cell.coordinates()[cell.solid]
        for side, nodes in zip(cell.sheets, (BOTTOM_FACE, TOP_FACE), strict=True):
            add_sheets(elements, position, nodes, side[cell.solid])
    return elements


def rod_fields(position: np.ndarray) -> np.ndarray:
    """Displacement of unit rod strains at nodes (n, 27, 3) [m], shape (n, 81, 4)."""
    x, y, z = np.moveaxis(position, -1, 0)
    field = np.zeros((*position.shape, 4))
    field[..., 0, 0] = x
    field[..., 1, 1] = -x * z
    field[..., 2, 1] = x * y
    field[..., 0, 2] = x * z
    field[..., 2, 2] = -x * x / 2
    field[..., 0, 3] = -x * y
    field[..., 1, 3] = x * x / 2
    return field.reshape(len(position), 3 * element.NODES, 4)


def _largest_strain(cell: HalfCell, local: np.ndarray) -> float:
    """Largest principal strain, mean over an element, of the solid's displacements (n, 81)."""
    if cell.position is not None:
        return curved.largest_strain(cell.position[cell.solid], local)
    table = element.reference_divergence()[:, : element.NODES] / 8
    gradient = np.einsum("pa,nai,npj->nij", table, local.reshape(-1, element.NODES, 3),
                         np.linalg.inv(cell.jacobian[cell.solid]))  # fmt: skip
    strain = (gradient + np.swapaxes(gradient, 1, 2)) / 2
    return float(np.linalg.eigvalsh(strain)[:, -1].max())


def _equal_parts(counts: tuple[tuple[int, ...], ...]) -> list[list[list[float]]]:
    return [[[1 / n] * n for n in axis] for axis in counts]


def coarse_mesh(body: Body) -> CellMesh:
    """The coarsest mesh found to keep bending, torsion and stiffness within 2 % of a converged one
    (tests measure it).

    One element per interval, except in walls that bulge as plates between open gaps: there two over
    the free height and two along the arm, three where the chamber stands at less than 45 degrees;
    and in bellows, two across the air.
    Bending about X3 does not bulge them and takes one throughout.
    """
    x, y, z, fill = intervals(body)
    once = [[1] * (len(lines) - 1) for lines in (x, y, z)]
    even = [axis.copy() for axis in once]
    if body.curved:
        even[1][0] = 2
    elif np.any(fill == OUTSIDE):
        arm = len(y) - 3  # the last interval is the side wall, before it the arm's length
        even[1][arm] = 3 if _slant(body) > 1 + 1e-9 else 2
        even[2][-2] = 2
    return CellMesh(*(tuple(tuple(axis) for axis in counts) for counts in (even, once)))


def _slant(body: Body) -> float:
    """How far chambers run along X1 per distance across, |cot theta|."""
    x, y, z = body.lines
    begin, end = body.place(np.array([[x[0], y[0], z[0]], [x[0], y[-1], z[0]]]))
    return abs(float((end - begin)[0] / (end - begin)[1]))


def volumes_of(cell: Body) -> tuple[float, float]:
    """Rubber and air of a cell of parallelepipeds [m3]."""
    volume = box_moments(cell)[..., 0]
    return float(volume[cell.fill >= 0].sum()), float(volume[cell.fill == CAVITY].sum())


CURVED_PARTS = 4


def box_moments(body: Body) -> np.ndarray:
    """Volume [m3] of every box and its first moment over the height [m4], shape (nx, ny, nz, 2).
    Curved boxes are integrated in ``CURVED_PARTS`` quadratic pieces along x'."""
    x, y, z = body.lines
    if not body.curved:
        corners = body.place(np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1))
        dx, dy = np.diff(corners[:, 0, 0, 0]), np.diff(corners[0, :, 0, 1])
        heights = corners[0, 0, :, 2]
        power = np.stack([np.diff(heights), np.diff(heights**2 / 2)], axis=-1)
        return np.einsum("x,y,zm->xyzm", dx, dy, power)
    fine = divide(x, [[1 / CURVED_PARTS] * CURVED_PARTS] * (len(x) - 1))
    position = curved_nodes(body, [fine, y, z], np.zeros(3))
    volume = curved.volumes(position)
    height = np.einsum("ga,na->ng", curved.VALUES, position[..., 2])
    moments = np.stack([volume.sum(axis=1), (volume * height).sum(axis=1)], axis=-1)
    shape = (len(x) - 1, CURVED_PARTS, len(y) - 1, len(z) - 1, 2)
    return moments.reshape(shape).sum(axis=1)
