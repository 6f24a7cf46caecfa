"""Rung 1: closed form, an equivalent section in pure bending. Below a millisecond, order of
magnitude.

In the spirit of the cantilever theory of P (docs/theory.md), but not its formula
(16), which belongs to the printed family: pressure on the chamber's cross-section, times its lever
arm about the section's neutral axis, bends the section through the chamber,

    kappa = p A (z_A - z_n) / EI,

over the length of the chambers; walls between them stay straight. It covers straight and oblique
chambers alike by their share of the axis, holds no twist, no weight, no bulging of walls (which is
what bends gapped actuators: there it is several times too small), and is linear in pressure.
"""

import numpy as np

from actuators.design import Design, ObliqueDesign, SlabDesign
from actuators.materials import material


def bending_rates(design: Design) -> np.ndarray:
    """Curvature per pressure of each chamber, mean over its pitch, (n,) [1/(Pa m)]."""
    if isinstance(design, ObliqueDesign):
        inner = np.full(design.chamber_count, design.chamber_width)
        outer = np.full(design.chamber_count, design.width)
        share = 2 * design.half_chamber / design.pitch
    elif isinstance(design, SlabDesign):
        middles = design.chamber_starts() + design.chamber_length / 2
        outer = 2 * np.asarray(design.half_width(middles))
        inner = outer - 2 * design.side_wall
        share = design.chamber_length / design.pitch
    else:
        raise TypeError(f"no closed form for {type(design).__name__}")
    lower = material(design.bottom_material).youngs_modulus
    upper = material(design.top_material).youngs_modulus
    z = np.cumsum([0.0, design.bottom_thickness, design.chamber_height, design.roof_thickness])
    stiff = np.stack([lower * outer, upper * (outer - inner), upper * outer], axis=-1)
    axial, first, second = (stiff @ (np.diff(z**n) / n) for n in (1, 2, 3))
    neutral = first / axial
    rigidity = second - first * neutral
    middle = (z[1] + z[2]) / 2
    return inner * design.chamber_height * (middle - neutral) / rigidity * share
