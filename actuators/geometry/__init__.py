"""Designs to bodies: block-structured geometry with named regions and the cavity."""

from actuators.design.base import Design
from actuators.design.oblique import ObliqueDesign
from actuators.design.slab import SlabDesign
from actuators.geometry.body import CAVITY, OUTSIDE, Body, Membrane, Region
from actuators.geometry.oblique_body import oblique_body, oblique_cell
from actuators.geometry.slab_body import slab_body, slab_cell


def build_body(design: Design) -> Body:
    """The undeformed body of any family."""
    if isinstance(design, SlabDesign):
        return slab_body(design)
    if isinstance(design, ObliqueDesign):
        return oblique_body(design)
    raise TypeError(f"no geometry for {type(design).__name__}")


def build_cell(design: Design, index: int) -> Body:
    """One periodic chamber: chamber ``index`` counted from the clamp."""
    if isinstance(design, SlabDesign):
        return slab_cell(design, index)
    if isinstance(design, ObliqueDesign):
        return oblique_cell(design)
    raise TypeError(f"no periodic cell for {type(design).__name__}")


__all__ = ["CAVITY", "OUTSIDE", "Body", "Membrane", "Region", "build_body", "build_cell"]
