"""Volumes of rubber and air in closed form, and the masses that follow: to check meshes, surfaces
and moulds against, and to weigh out the silicone."""

import math
from dataclasses import dataclass

import numpy as np

from actuators.design import BLOCK_FAMILIES, BellowsDesign, BlockBar, Design, SlabDesign
from actuators.materials import material


@dataclass(frozen=True)
class Volumes:
    """Undeformed volumes [m3]: rubber of the bottom layer, rubber above it, air under pressure."""

    bottom: float
    top: float
    cavity: float

    @property
    def rubber(self) -> float:
        """Both castings together [m3]."""
        return self.bottom + self.top


def exact_volumes(design: Design) -> Volumes:
    """Volumes of the design itself, arcs and shear included; no mesh involved."""
    if isinstance(design, SlabDesign):
        return _slab(design)
    if isinstance(design, BLOCK_FAMILIES):
        return _blocks(design.bar)
    if isinstance(design, BellowsDesign):
        return _bellows(design)
    raise TypeError(f"no volumes for {type(design).__name__}")


def masses(design: Design) -> tuple[float, float]:
    """Mass of the bottom layer and of the rubber above it [kg]."""
    volumes = exact_volumes(design)
    lower, upper = (
        material(getattr(design, name), field=name).density for name in design.layer_materials
    )
    return volumes.bottom * lower, volumes.top * upper


def planform_area(design: SlabDesign, start: float, end: float, *, inset: float = 0.0) -> float:
    """Area between X1 = ``start`` and ``end`` inside the outline moved inwards across the body by
    ``inset`` on either side [m2]."""
    return 2 * (_half_area(design, end) - _half_area(design, start) - inset * (end - start))


def slab_planform_area(design: SlabDesign) -> float:
    """Area of the whole outline [m2]."""
    return planform_area(design, 0.0, design.length)


def slab_cavity_area(design: SlabDesign) -> float:
    """Area of the chambers and the channel between them, seen from above [m2]."""
    chambers = sum(
        planform_area(design, start, start + design.chamber_length, inset=design.side_wall)
        for start in map(float, design.chamber_starts())
    )
    walls = (design.chamber_count - 1) * design.wall_length
    return chambers + walls * design.channel_width


def _slab(design: SlabDesign) -> Volumes:
    planform = slab_planform_area(design)
    cavity = slab_cavity_area(design) * design.chamber_height
    return Volumes(
        bottom=planform * design.bottom_thickness,
        top=planform * (design.chamber_height + design.roof_thickness) - cavity,
        cavity=cavity,
    )


def _half_area(design: SlabDesign, x: float) -> float:
    """Integral of the half width from the clamp to ``x`` [m2]."""
    half = design.width / 2
    if design.planform == "rectangle":
        return half * x
    if design.planform == "triangle":
        return half * x + (design.tip_width / 2 - half) / design.length * x**2 / 2
    radius, middle = design.side_radius, design.length / 2
    return (half - radius) * x + _arc(x - middle, radius) - _arc(-middle, radius)


def _arc(s: float, radius: float) -> float:
    """Antiderivative of sqrt(radius^2 - s^2)."""
    return (s * math.sqrt(radius**2 - s**2) + radius**2 * math.asin(s / radius)) / 2


def _blocks(bar: BlockBar) -> Volumes:
    # shear along the axis keeps every area, so the angle does not enter
    n, width = bar.chamber_count, bar.width
    area = bar.length * width
    open_gaps = n * 2 * bar.half_gap * width * (bar.wall_height + bar.roof_thickness)
    chambers = n * 2 * bar.half_chamber * bar.chamber_width * bar.chamber_height
    links = (n - 1) * 2 * (bar.wall_thickness + bar.half_gap)
    channel = 0.0
    if bar.channel_width > 0:
        channel = links * bar.channel_width * bar.channel_height
    cavity = chambers + channel
    above = area * (bar.height - bar.bottom_thickness)
    return Volumes(
        bottom=area * bar.bottom_thickness, top=above - open_gaps - cavity, cavity=cavity
    )


def _bellows(design: BellowsDesign) -> Volumes:
    count, top = design.chamber_count, np.array(design.height)
    cavity = count * float(design.wave.air_below(top)) * design.inner_width
    profile = count * float(design.wave.body_below(top)) + 2 * design.end_length * design.end_height
    bottom = design.length * design.width * design.bottom_thickness
    return Volumes(bottom=bottom, top=profile * design.width - cavity - bottom, cavity=cavity)
