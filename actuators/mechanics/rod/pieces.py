"""A design as pieces of rod: solid ends that do not answer to pressure, chambers that do."""

from dataclasses import dataclass

import numpy as np

from actuators.design import BLOCK_FAMILIES, BellowsDesign, Design, SlabDesign
from actuators.geometry.block_body import sheet_stiffness
from actuators.materials import material
from actuators.mechanics.cell.row import ChamberRow
from actuators.mechanics.rod.section import layered_section, sheet_section

FINEST = 24
"""Pieces no longer than 1/24 of the length: weight bends them by their middle's moment, an error
below 0.1 % of the droop (a test halves them)."""
SOLID = -1
NO_END = 1e-9
"""Of the length: an end as short as this is none."""


@dataclass(frozen=True, eq=False)
class Layout:
    """s pieces from the clamp on, whatever their law. ``length``: (s,) [m]; ``chamber``: (s,) the
    chamber in whose pitch each lies, ``SOLID`` for ends; ``whole``: (s,) the pitch over what clamp
    and tip leave of it; ``solid``: (s, 4, 4) stiffness of the ends, 0 elsewhere; ``mass``: (s,)
    [kg]; ``mass_height``: (s,) [m]."""

    length: np.ndarray
    chamber: np.ndarray
    whole: np.ndarray
    solid: np.ndarray
    mass: np.ndarray
    mass_height: np.ndarray

    @property
    def chambered(self) -> np.ndarray:
        """Mask of the pieces that carry chambers, (s,)."""
        return self.chamber != SOLID

    @property
    def stations(self) -> np.ndarray:
        """X1 of the borders between pieces, (s + 1,) [m]."""
        return np.concatenate([[0.0], np.cumsum(self.length)])

    def free(self, chambers: np.ndarray) -> np.ndarray:
        """Free strains (..., s, c) of the pieces, of those of the chambers (..., n, c). A pitch
        that clamp or tip cuts off still holds a whole chamber: it keeps what it turns."""
        along = np.where(self.chambered, self.whole, 0.0)
        return chambers[..., self.chamber, :] * along[:, None]

    def stiffness(self, chambers: np.ndarray) -> np.ndarray:
        """Stiffness (..., s, 4, 4) of the pieces, of that of the chambers (..., n, 4, 4)."""
        share = np.where(self.chambered, 1 / self.whole, 0.0)
        return chambers[..., self.chamber, :, :] * share[:, None, None] + self.solid


@dataclass(frozen=True, eq=False)
class Rod:
    """s pieces from the clamp on. ``length``: (s,) [m]; ``free``: (s, 4) rod strains per pressure;
    ``compliance``: (s, 4, 4) rod strains per resultant; ``bending``: (s, 3, 3) stiffness against
    torsion and both bendings at constant axial force; ``mass``: (s,) [kg]; ``mass_height``: (s,)
    [m]; ``chambered``: (s,) bool."""

    length: np.ndarray
    free: np.ndarray
    compliance: np.ndarray
    bending: np.ndarray
    mass: np.ndarray
    mass_height: np.ndarray
    chambered: np.ndarray

    @property
    def stations(self) -> np.ndarray:
        """X1 of the borders between pieces, (s + 1,) [m]."""
        return np.concatenate([[0.0], np.cumsum(self.length)])


def layout_of(design: Design, row: ChamberRow, *, finest: int = FINEST) -> Layout:
    """Pieces of the design, from the clamp to the tip."""
    begin = np.clip(row.start, 0.0, design.length)
    end = np.clip(row.start + row.pitch, 0.0, design.length)
    spans = [(float(b), float(e)) for b, e in zip(begin, end, strict=True)]
    number = list(range(len(spans)))
    mass, height = list(row.line_mass), list(row.mass_height)
    solid = [np.zeros((4, 4)) for _ in spans]
    for left, right in ((0.0, float(begin[0])), (float(end[-1]), design.length)):
        if right - left <= NO_END * design.length:
            continue
        section, line_mass, centre = _solid_end(design, (left + right) / 2)
        at = 0 if left == 0.0 else len(spans)
        spans.insert(at, (left, right))
        number.insert(at, SOLID)
        solid.insert(at, section)
        mass.insert(at, line_mass)
        height.insert(at, centre)
    span = np.array([b - a for a, b in spans])
    parts = np.ceil(span / (design.length / finest) - 1e-9).astype(int)
    length = np.repeat(span / parts, parts)
    return Layout(
        length=length,
        chamber=np.repeat(number, parts),
        whole=np.repeat(np.where(np.array(number) == SOLID, 1.0, row.pitch / span), parts),
        solid=np.repeat(np.array(solid), parts, axis=0),
        mass=np.repeat(np.array(mass), parts) * length,
        mass_height=np.repeat(np.array(height), parts),
    )


def rod_of(design: Design, row: ChamberRow, free: np.ndarray, *, finest: int = FINEST) -> Rod:
    """Rod of the design with ``free`` (n, 4) rod strains per pressure in its chambers."""
    layout = layout_of(design, row, finest=finest)
    compliance = np.linalg.inv(layout.stiffness(row.stiffness))
    return Rod(
        length=layout.length,
        free=layout.free(free),
        compliance=compliance,
        bending=np.linalg.inv(compliance[:, 1:, 1:]),
        mass=layout.mass,
        mass_height=layout.mass_height,
        chambered=layout.chambered,
    )


def outline(design: Design, x: np.ndarray) -> tuple[np.ndarray, float]:
    """Width (k,) at X1 = ``x`` [m] and height of the body's outside [m]."""
    if isinstance(design, SlabDesign):
        return 2 * np.asarray(design.half_width(x)), design.height
    if isinstance(design, BLOCK_FAMILIES):
        return np.full(len(x), design.bar.width), design.bar.height
    if isinstance(design, BellowsDesign):
        return np.full(len(x), design.width), design.height
    raise TypeError(f"no outline for {type(design).__name__}")


def end_height(design: Design) -> float:
    """Height of the free end's face [m]."""
    return (
        design.end_height
        if isinstance(design, BellowsDesign)
        else outline(design, np.array([design.length]))[1]
    )


def _solid_end(design: Design, at: float) -> tuple[np.ndarray, float, float]:
    """Stiffness (4, 4), line mass [kg/m] and height of the mass [m] of the solid section at X1."""
    bottom, top = (material(getattr(design, name)) for name in design.layer_materials)
    sheet: tuple[float, float] = (0.0, 0.0)
    if isinstance(design, SlabDesign):
        width, lower, height = (
            2 * float(design.half_width(at)),
            design.bottom_thickness,
            design.height,
        )
    elif isinstance(design, BLOCK_FAMILIES):
        bar = design.bar
        width, lower, height = bar.width, bar.bottom_thickness, bar.height
        if bar.sheet is not None:
            sheet = (sheet_stiffness(bar), bar.sheet.height)
    elif isinstance(design, BellowsDesign):
        width, lower, height = design.width, design.bottom_thickness, design.end_height
    else:
        raise TypeError(f"no sections for {type(design).__name__}")
    thickness = np.array([lower, height - lower])
    section = layered_section(
        width,
        thickness,
        np.array([bottom.youngs_modulus, top.youngs_modulus]),
        np.array([bottom.shear_modulus, top.shear_modulus]),
    ) + sheet_section(width, *sheet)
    masses = np.array([bottom.density, top.density]) * thickness * width
    centres = np.array([lower / 2, (lower + height) / 2])
    return section, float(masses.sum()), float(masses @ centres / masses.sum())
