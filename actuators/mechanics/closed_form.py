"""Rung 1: closed form, an equivalent section in pure bending. Below a millisecond, order of
magnitude.

In the spirit of the cantilever theory of P (docs/theory.md), but not its formula
(16), which belongs to the printed family: pressure on the chamber's cross-section, times its lever
arm about the section's neutral axis, bends the section through the chamber,

    kappa = p A (z_A - z_n) / EI,

over the length of the chambers; walls between them stay straight; an embedded sheet counts with its
stiffness along the axis. It covers straight and oblique
chambers alike by their share of the axis, holds no twist, no weight, no bulging of walls (which is
what bends gapped actuators: there it is several times too small), and is linear in pressure.
"""

import numpy as np

from actuators.design import BLOCK_FAMILIES, Design, SlabDesign
from actuators.geometry.block_body import sheet_stiffness
from actuators.materials import material


def bending_rates(design: Design) -> np.ndarray:
    """Curvature per pressure of each chamber, mean over its pitch, (n,) [1/(Pa m)]."""
    sheet = np.zeros(3)
    if isinstance(design, BLOCK_FAMILIES):
        bar = design.bar
        inner = np.full(bar.chamber_count, bar.chamber_width)
        outer = np.full(bar.chamber_count, bar.width)
        share = 2 * bar.half_chamber / bar.pitch
        heights = [bar.bottom_thickness, bar.chamber_height, bar.roof_thickness]
        keys = (bar.bottom_material, bar.top_material)
        if bar.sheet is not None:
            sheet = sheet_stiffness(bar) * bar.width * bar.sheet.height ** np.arange(3)
    elif isinstance(design, SlabDesign):
        middles = design.chamber_starts() + design.chamber_length / 2
        outer = 2 * np.asarray(design.half_width(middles))
        inner = outer - 2 * design.side_wall
        share = design.chamber_length / design.pitch
        heights = [design.bottom_thickness, design.chamber_height, design.roof_thickness]
        keys = (design.bottom_material, design.top_material)
    else:
        raise TypeError(f"no closed form for {type(design).__name__}")
    lower, upper = (material(key).youngs_modulus for key in keys)
    z = np.cumsum([0.0, *heights])
    stiff = np.stack([lower * outer, upper * (outer - inner), upper * outer], axis=-1)
    axial, first, second = (
        stiff @ (np.diff(z**n) / n) + held for n, held in zip((1, 2, 3), sheet, strict=True)
    )
    neutral = first / axial
    rigidity = second - first * neutral
    middle = (z[1] + z[2]) / 2
    return inner * heights[1] * (middle - neutral) / rigidity * share
