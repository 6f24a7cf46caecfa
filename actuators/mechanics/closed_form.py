"""Rung 1: closed form, an equivalent section in pure bending. Below a millisecond, order of
magnitude.

In the spirit of the cantilever theory of P (docs/theory.md), but not its formula
(16): pressure on the chamber's cross-section, times its lever arm about the section's neutral axis,
bends the section through the chamber,

    kappa = p A (z_A - z_n) / EI,

over the length of the chambers; walls between them stay straight. An embedded sheet counts with its
stiffness along the axis. It covers straight and oblique chambers alike by their share of the axis,
holds no twist, no weight, no bulging of walls (which is what bends gapped actuators: there it is
several times too small, 19 times for the printed preset), and is linear in pressure. The skin of
bellows folds away: there the section under the valleys bends, over their width (about twice what
the periodic chamber gives).
"""

import numpy as np

from actuators.design import BLOCK_FAMILIES, BellowsDesign, Design, SlabDesign
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
    elif isinstance(design, BellowsDesign):
        return np.full(design.chamber_count, _bellows(design))
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
    neutral, rigidity = _section(heights, inner, outer, (lower, upper), sheet)
    middle = heights[0] + heights[1] / 2
    return inner * heights[1] * (middle - neutral) / rigidity * share


def _bellows(design: BellowsDesign) -> float:
    """The skin of a bellows folds away and carries no axial force: what the pressure in the whole
    cross-section bends is the section under the valleys, over their width."""
    heights = [design.bottom_thickness, design.channel_height, design.wall_thickness]
    inner, outer = np.array(design.inner_width), np.array(design.width)
    modulus = material(design.material).youngs_modulus
    neutral, rigidity = _section(heights, inner, outer, (modulus, modulus), np.zeros(3))
    air = design.height - design.bottom_thickness - design.wall_thickness
    middle = design.bottom_thickness + air / 2
    share = 2 * design.wave.valley / design.pitch
    return float(inner * air * (middle - neutral) / rigidity) * share


def _section(
    heights: list[float],
    inner: np.ndarray,
    outer: np.ndarray,
    moduli: tuple[float, float],
    sheet: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Neutral axis above the underside [m] and bending stiffness [N m2] of a hollow section: bottom
    layer, chamber between side walls, roof. ``sheet``: moments 0 to 2 of an embedded sheet."""
    lower, upper = moduli
    z = np.cumsum([0.0, *heights])
    stiff = np.stack([lower * outer, upper * (outer - inner), upper * outer], axis=-1)
    axial, first, second = (
        stiff @ (np.diff(z**n) / n) + held for n, held in zip((1, 2, 3), sheet, strict=True)
    )
    neutral = first / axial
    return neutral, second - first * neutral
