"""What follows from a design's parameters and is worth reading beside them, in border units."""

from dataclasses import dataclass

from actuators.design import BLOCK_FAMILIES, BellowsDesign, BlockBar, Design, SlabDesign
from actuators.geometry.block_body import sheet_stiffness
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
    elif isinstance(design, BLOCK_FAMILIES):
        own = _blocks(design.bar)
    elif isinstance(design, BellowsDesign):
        own = _bellows(design)
    else:
        raise TypeError(f"nothing known about {type(design).__name__}")
    volumes = exact_volumes(design)
    bottom, top = masses(design)
    cast = [
        _value("Mass of bottom layer", bottom * 1e3, "g"),
        _value("Mass of top layer", top * 1e3, "g"),
    ]
    printed = [_value("Mass", (bottom + top) * 1e3, "g")]
    return [
        *own,
        _value("Cavity volume", volumes.cavity * 1e6, "ml"),
        _value("Rubber volume", volumes.rubber * 1e6, "ml"),
        *(printed if len(set(design.layer_materials)) == 1 else cast),
    ]


def _slab(design: SlabDesign) -> list[Derived]:
    return [
        _value("Total thickness", design.height * 1e3, "mm"),
        _value("Chamber length", design.chamber_length * 1e3, "mm"),
        _value("Wall between chambers", design.wall_length * 1e3, "mm"),
        _value("Shortest chamber arm", float(design.arm_spans().min()) * 1e3, "mm"),
    ]


def _blocks(bar: BlockBar) -> list[Derived]:
    values = [
        _value("Total thickness", bar.height * 1e3, "mm"),
        _value("Chamber pitch", bar.pitch * 1e3, "mm"),
        _value("Chamber height", bar.chamber_height * 1e3, "mm"),
        _value("Side wall", bar.side_wall * 1e3, "mm"),
        _value("End piece", bar.end_length * 1e3, "mm"),
    ]
    if bar.sheet is not None:
        values.append(_value("Stiffness of the layer", sheet_stiffness(bar) / 1e3, "N/mm"))
    return values


def _bellows(design: BellowsDesign) -> list[Derived]:
    return [
        _value("Bellows pitch", design.pitch * 1e3, "mm"),
        _value("Inner radius of the crown", design.wave.crown * 1e3, "mm"),
        _value("Straight wall", design.wave.straight * 1e3, "mm"),
        _value("Inner width", design.inner_width * 1e3, "mm"),
        _value("Height of the end pieces", design.end_height * 1e3, "mm"),
    ]


def _value(label: str, value: float, unit: str) -> Derived:
    return Derived(label, float(f"{value:.6g}"), unit)
