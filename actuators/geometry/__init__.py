"""Designs to bodies: block-structured geometry with named regions and the cavity."""

from actuators.design import BLOCK_FAMILIES, BellowsDesign, Design, SlabDesign
from actuators.geometry.bellows_body import bellows_body, bellows_cell
from actuators.geometry.block_body import block_body, block_cell
from actuators.geometry.body import CAVITY, OUTSIDE, Body, Membrane, Region
from actuators.geometry.slab_body import slab_body, slab_cell


def build_body(design: Design) -> Body:
    """The undeformed body of any family."""
    if isinstance(design, SlabDesign):
        return slab_body(design)
    if isinstance(design, BLOCK_FAMILIES):
        return block_body(design.bar)
    if isinstance(design, BellowsDesign):
        return bellows_body(design)
    raise TypeError(f"no geometry for {type(design).__name__}")


def build_cell(design: Design, index: int) -> Body:
    """One periodic chamber: chamber ``index`` counted from the clamp."""
    if isinstance(design, SlabDesign):
        return slab_cell(design, index)
    if isinstance(design, BLOCK_FAMILIES):
        return block_cell(design.bar)
    if isinstance(design, BellowsDesign):
        return bellows_cell(design)
    raise TypeError(f"no periodic cell for {type(design).__name__}")


__all__ = ["CAVITY", "OUTSIDE", "Body", "Membrane", "Region", "build_body", "build_cell"]
