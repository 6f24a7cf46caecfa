"""The chambers of a design, one after the other, each answered by its own periodic cell."""

from dataclasses import dataclass

import numpy as np

from actuators.design import BLOCK_FAMILIES, BellowsDesign, Design, SlabDesign
from actuators.geometry import Body, build_cell
from actuators.materials import material
from actuators.mechanics.cell.cache import cell_response
from actuators.mechanics.cell.periodic import box_moments

WIDTHS = 4
"""Cells solved for a tapered slab; the widths between them are interpolated by a cubic, which a
test finds within 0.5 % of a cell of their own (0.24 % measured at the narrow end of a triangle)."""
_DIGITS = 30
"""Binary digits of the largest width that widths are told apart by."""


@dataclass(frozen=True, eq=False)
class ChamberRow:
    """n chambers from the clamp on, one pitch each.

    ``start``: (n,) X1 where each pitch begins [m], possibly before the clamp; ``pitch`` [m];
    ``free``: (n, 4) rod strains per pressure; ``stiffness``: (n, 4, 4); ``line_mass``: (n,) [kg/m];
    ``mass_height``: (n,) height of the centre of mass [m]; ``cavity_volume``: (n,) [m3];
    ``cavity_compliance``: (n,) [m3/Pa]; ``largest_strain``: largest principal strain per pressure
    in any chamber [1/Pa]; ``gap_closing``: largest share of an open gap closed per pressure [1/Pa];
    ``unknowns``: of all cells. See :class:`.periodic.CellResponse`.
    """

    start: np.ndarray
    pitch: float
    free: np.ndarray
    stiffness: np.ndarray
    line_mass: np.ndarray
    mass_height: np.ndarray
    cavity_volume: np.ndarray
    cavity_compliance: np.ndarray
    largest_strain: float
    gap_closing: float
    unknowns: int


def chamber_row(design: Design) -> ChamberRow:
    """Every chamber of the design; chambers of one width share their cell."""
    start, pitch = pitch_starts(design)
    cells, weights = row_cells(design)
    answers = [cell_response(cell) for cell in cells]
    masses = np.array([_mass(cell) for cell in cells])
    mass, moment = (weights @ masses).T

    def along(values: list[np.ndarray] | list[float]) -> np.ndarray:
        return np.tensordot(weights, np.array(values), axes=1)

    return ChamberRow(
        start=start,
        pitch=pitch,
        free=along([a.free for a in answers]),
        stiffness=along([a.stiffness for a in answers]),
        line_mass=mass / pitch,
        mass_height=moment / mass,
        cavity_volume=along([a.cavity_volume for a in answers]),
        cavity_compliance=along([a.cavity_compliance for a in answers]),
        largest_strain=max(a.largest_strain for a in answers),
        gap_closing=max(a.gap_closing for a in answers),
        unknowns=sum(a.unknowns for a in answers),
    )


def row_cells(design: Design) -> tuple[list[Body], np.ndarray]:
    """Cells that answer for the chambers, and their weights (n, cells) in each one's answer."""
    if isinstance(design, (*BLOCK_FAMILIES, BellowsDesign)):
        return [build_cell(design, 0)], np.ones((design.chamber_count, 1))
    if isinstance(design, SlabDesign):
        return _slab_cells(design)
    raise TypeError(f"no periodic cell for {type(design).__name__}")


def pitch_starts(design: Design) -> tuple[np.ndarray, float]:
    """X1 where each chamber's pitch begins (n,) [m], possibly before the clamp, and the pitch."""
    if isinstance(design, BLOCK_FAMILIES):
        first, pitch = design.bar.end_length, design.bar.pitch
    elif isinstance(design, BellowsDesign):
        first, pitch = design.end_length, design.pitch
    elif isinstance(design, SlabDesign):
        first, pitch = design.root_wall - design.wall_length / 2, design.pitch
    else:
        raise TypeError(f"no chambers for {type(design).__name__}")
    return first + pitch * np.arange(design.chamber_count), pitch


def _slab_cells(design: SlabDesign) -> tuple[list[Body], np.ndarray]:
    """Prismatic cells, and their weights (n, cells) in the answer of each chamber."""
    middles = design.chamber_starts() + design.chamber_length / 2
    widths = 2 * np.asarray(design.half_width(middles))
    # widths that differ by rounding are one
    step = np.ldexp(1.0, int(np.frexp(widths.max())[1]) - _DIGITS)
    distinct, member = np.unique(np.round(widths / step) * step, return_inverse=True)
    if len(distinct) <= WIDTHS:
        weights = np.eye(len(distinct))[member]
    else:
        low, high = distinct[0], distinct[-1]
        nodes = (low + high) / 2 - (high - low) / 2 * np.cos(
            np.pi * np.arange(WIDTHS) / (WIDTHS - 1)
        )
        weights = _lagrange(nodes, widths)
        distinct = nodes
    prismatic = [
        design.model_copy(update={"planform": "rectangle", "width": float(w)}) for w in distinct
    ]
    return [build_cell(d, 0) for d in prismatic], weights


def _lagrange(nodes: np.ndarray, at: np.ndarray) -> np.ndarray:
    """Values (len(at), len(nodes)) of the polynomials that are 1 at one node and 0 at the rest."""
    difference = at[:, None, None] - nodes  # (at, polynomial, node)
    span = nodes[:, None] - nodes
    own = np.eye(len(nodes), dtype=bool)
    ratio = np.where(own, 1.0, difference / np.where(own, 1.0, span))
    return ratio.prod(axis=-1)


def _mass(cell: Body) -> tuple[float, float]:
    """Mass [kg] and its first moment over the height [kg m] of one cell."""
    density = np.array([material(r.material).density for r in cell.regions] + [0.0])
    mass, moment = np.einsum("xyz,xyzm->m", density[np.maximum(cell.fill, -1)], box_moments(cell))
    return float(mass), float(moment)
