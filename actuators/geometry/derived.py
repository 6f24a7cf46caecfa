"""What follows from a design's parameters and is worth reading beside them, in border units."""

from dataclasses import dataclass

from actuators.design.base import Design
from actuators.design.oblique import ObliqueDesign
from actuators.design.slab import SlabDesign
from actuators.geometry.volumes import exact_volumes, masses


@dataclass(frozen=True)
class Derived:
    """One value that follows from the design."""

    label: str
    value: float
    unit: str


def derived(design: Design) -> list[Derived]:
    """Lengths, volumes and masses. Raises ``DesignError`` for a material not in the catalogue."""
    if isinstance(design, SlabDesign):
        own = _slab(design)
    elif isinstance(design, ObliqueDesign):
        own = _oblique(design)
    else:
        raise TypeError(f"nothing known about {type(design).__name__}")
    volumes = exact_volumes(design)
    bottom, top = masses(design)
    return [
        *own,
        _value("Cavity volume", volumes.cavity * 1e6, "ml"),
        _value("Rubber volume", volumes.rubber * 1e6, "ml"),
        _value("Mass of bottom layer", bottom * 1e3, "g"),
        _value("Mass of top layer", top * 1e3, "g"),
    ]


def _slab(design: SlabDesign) -> list[Derived]:
    return [
        _value("Total thickness", design.height * 1e3, "mm"),
        _value("Chamber length", design.chamber_length * 1e3, "mm"),
        _value("Wall between chambers", design.wall_length * 1e3, "mm"),
        _value("Shortest chamber arm", float(design.arm_spans().min()) * 1e3, "mm"),
    ]


def _oblique(design: ObliqueDesign) -> list[Derived]:
    return [
        _value("Total thickness", design.height * 1e3, "mm"),
        _value("Chamber pitch", design.pitch * 1e3, "mm"),
        _value("Chamber height", design.chamber_height * 1e3, "mm"),
        _value("Side wall", design.side_wall * 1e3, "mm"),
        _value("End piece", design.end_length * 1e3, "mm"),
    ]


def _value(label: str, value: float, unit: str) -> Derived:
    return Derived(label, float(f"{value:.6g}"), unit)
