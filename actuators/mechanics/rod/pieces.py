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


def rod_of(design: Design, row: ChamberRow, free: np.ndarray, *, finest: int = FINEST) -> Rod:
    """Rod of the design with ``free`` (n, 4) rod strains per pressure in its chambers."""
    begin = np.clip(row.start, 0.0, design.length)
    end = np.clip(row.start + row.pitch, 0.0, design.length)
    # a pitch that the clamp or the tip cuts off still holds a whole chamber: keep what it turns
    whole = row.pitch / (end - begin)
    spans = [(float(b), float(e)) for b, e in zip(begin, end, strict=True)]
    frees = [f * w for f, w in zip(free, whole, strict=True)]
    stiffness = [d / w for d, w in zip(row.stiffness, whole, strict=True)]
    mass = list(row.line_mass)
    height = list(row.mass_height)
    chambered = [True] * len(spans)
    solid = [(0.0, float(begin[0])), (float(end[-1]), design.length)]
    kept = [span for span in solid if span[1] - span[0] > 1e-9]
    for left, right in kept:
        section, line_mass, centre = _solid_end(design, (left + right) / 2)
        at = 0 if left == 0.0 else len(spans)
        spans.insert(at, (left, right))
        frees.insert(at, np.zeros(4))
        chambered.insert(at, False)
        stiffness.insert(at, section)
        mass.insert(at, line_mass)
        height.insert(at, centre)
    span = np.array([b - a for a, b in spans])
    parts = np.ceil(span / (design.length / finest) - 1e-9).astype(int)
    compliance = np.linalg.inv(np.array(stiffness))
    rigid = np.linalg.inv(compliance[:, 1:, 1:])
    length = np.repeat(span / parts, parts)
    per_length = np.repeat(np.array(mass), parts)
    return Rod(
        length=length,
        free=np.repeat(np.array(frees), parts, axis=0),
        compliance=np.repeat(compliance, parts, axis=0),
        bending=np.repeat(rigid, parts, axis=0),
        mass=per_length * length,
        mass_height=np.repeat(np.array(height), parts),
        chambered=np.repeat(chambered, parts),
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
