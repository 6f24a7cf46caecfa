"""Designs as stacks of layers: how much of each height is rubber, and how much is chamber."""

from dataclasses import dataclass, replace

import numpy as np

from actuators.design import BLOCK_FAMILIES, BellowsDesign, Design, SlabDesign
from actuators.geometry.block_body import sheet_stiffness
from actuators.materials import material

ROUND_SLICES = 8
"""Layers that stand for a quarter circle of a bellows' profile."""


@dataclass(frozen=True, eq=False)
class Layers:
    """Chambers or designs as layers, batch axes first; m layers.

    ``height``: (..., m + 1) borders [m] from the underside; ``rubber``, ``air``: (..., m) area of a
    layer seen from above, over one pitch [m2]; ``shear_modulus``: (..., m) [Pa]; ``theta``: (...)
    angle from the axis to the chambers. ``sheet``: (...) stiffness of an embedded sheet along the
    axis over one pitch [J], at ``sheet_height`` [m]; both None without one (theta is then 90
    degrees in every family that has one).
    """

    height: np.ndarray
    rubber: np.ndarray
    air: np.ndarray
    shear_modulus: np.ndarray
    theta: np.ndarray
    sheet_height: np.ndarray | None = None
    sheet: np.ndarray | None = None


def oblique_layers(
    *,
    theta: np.ndarray,
    half_gap: np.ndarray,
    wall_thickness: np.ndarray,
    half_chamber: np.ndarray,
    width: np.ndarray,
    chamber_width: np.ndarray,
    bottom_thickness: np.ndarray,
    foot_height: np.ndarray,
    wall_height: np.ndarray,
    roof_thickness: np.ndarray,
    bottom_shear: np.ndarray,
    top_shear: np.ndarray,
) -> Layers:
    """Layers of oblique designs; all arguments broadcast against each other [m, rad, Pa].

    G, Fig. 2b, with the bounds of (4) corrected (docs/theory.md): bottom over the whole
    pitch; foot over 2 (t1 + t2); separate walls over 2 t2; roof over 2 (t2 + t3). Side walls, which
    the paper leaves out, close the chambers. The air channel is left out.
    """
    t1, t2, t3, w, wo, h1, h2, h3, h4, mu1, mu2, angle = np.broadcast_arrays(
        half_gap, wall_thickness, half_chamber, chamber_width, width, bottom_thickness,
        foot_height, wall_height, roof_thickness, bottom_shear, top_shear, theta,
    )  # fmt: skip
    zero = np.zeros_like(t1)
    sides = wo - w
    pitch, block = 2 * (t1 + t2 + t3), 2 * (t2 + t3)
    rubber = [pitch * wo, 2 * (t1 + t2) * wo + 2 * t3 * sides, 2 * t2 * wo + 2 * t3 * sides,
              block * wo]  # fmt: skip
    air = [zero, 2 * t3 * w, 2 * t3 * w, zero]
    return Layers(
        height=np.cumsum(np.stack([zero, h1, h2, h3, h4], axis=-1), axis=-1),
        rubber=np.stack(rubber, axis=-1),
        air=np.stack(air, axis=-1),
        shear_modulus=np.stack([mu1, mu2, mu2, mu2], axis=-1),
        theta=angle,
    )


def slab_layers(
    *,
    chamber_length: np.ndarray,
    wall_length: np.ndarray,
    width: np.ndarray,
    side_wall: np.ndarray,
    channel_width: np.ndarray,
    bottom_thickness: np.ndarray,
    chamber_height: np.ndarray,
    roof_thickness: np.ndarray,
    bottom_shear: np.ndarray,
    top_shear: np.ndarray,
) -> Layers:
    """Layers of slab chambers, each with its own ``width``; arguments broadcast [m, Pa]. Chamber
    and wall share the pitch, the channel cuts the wall; theta is 90 degrees."""
    ch, wl, w, side, w0, hb, hc, hr, mu1, mu2 = np.broadcast_arrays(
        chamber_length, wall_length, width, side_wall, channel_width, bottom_thickness,
        chamber_height, roof_thickness, bottom_shear, top_shear,
    )  # fmt: skip
    zero = np.zeros_like(ch)
    whole = (ch + wl) * w
    air = ch * (w - 2 * side) + wl * w0
    return Layers(
        height=np.cumsum(np.stack([zero, hb, hc, hr], axis=-1), axis=-1),
        rubber=np.stack([whole, whole - air, whole], axis=-1),
        air=np.stack([zero, air, zero], axis=-1),
        shear_modulus=np.stack([mu1, mu2, mu2], axis=-1),
        theta=np.full_like(ch, np.pi / 2),
    )


def bellows_layers(design: BellowsDesign) -> Layers:
    """Layers of bellows, all alike; the round parts in slices of equal height, each with the mean
    of its area. Side walls fill the cavity's profile with rubber."""
    wave = design.wave
    high = wave.crown_centre
    height = np.concatenate(
        [
            [0.0, wave.floor, wave.floor + wave.channel],
            np.linspace(wave.floor + wave.channel, wave.valley_centre, ROUND_SLICES + 1)[1:],
            np.linspace(high, high + wave.crown, ROUND_SLICES + 1),
            [design.height],
        ]
    )
    thickness = np.diff(height)
    air = np.diff(wave.air_below(height)) * design.inner_width / thickness
    rubber = np.diff(wave.body_below(height)) * design.width / thickness - air
    count = design.chamber_count
    shear = np.full(len(thickness), material(design.material).shear_modulus)
    return Layers(
        height=np.tile(height, (count, 1)),
        rubber=np.tile(rubber, (count, 1)),
        air=np.tile(air, (count, 1)),
        shear_modulus=np.tile(shear, (count, 1)),
        theta=np.full(count, np.pi / 2),
    )


def design_layers(design: Design) -> Layers:
    """Layers of every chamber of a design, from the clamp on; batch axis (n,)."""
    if isinstance(design, BLOCK_FAMILIES):
        bar = design.bar
        layers = oblique_layers(
            theta=np.full(bar.chamber_count, bar.theta),
            half_gap=np.array(bar.half_gap),
            wall_thickness=np.array(bar.wall_thickness),
            half_chamber=np.array(bar.half_chamber),
            width=np.array(bar.width),
            chamber_width=np.array(bar.chamber_width),
            bottom_thickness=np.array(bar.bottom_thickness),
            foot_height=np.array(bar.foot_height),
            wall_height=np.array(bar.wall_height),
            roof_thickness=np.array(bar.roof_thickness),
            bottom_shear=np.array(material(bar.bottom_material).shear_modulus),
            top_shear=np.array(material(bar.top_material).shear_modulus),
        )
        if bar.sheet is None:
            return layers
        sheet = sheet_stiffness(bar) * bar.width * bar.pitch
        count = bar.chamber_count
        return replace(
            layers,
            sheet=np.full(count, sheet),
            sheet_height=np.full(count, bar.sheet.height),
        )
    if isinstance(design, BellowsDesign):
        return bellows_layers(design)
    if isinstance(design, SlabDesign):
        middles = design.chamber_starts() + design.chamber_length / 2
        return slab_layers(
            chamber_length=np.array(design.chamber_length),
            wall_length=np.array(design.wall_length),
            width=2 * design.half_width(middles),
            side_wall=np.array(design.side_wall),
            channel_width=np.array(design.channel_width),
            bottom_thickness=np.array(design.bottom_thickness),
            chamber_height=np.array(design.chamber_height),
            roof_thickness=np.array(design.roof_thickness),
            bottom_shear=np.array(material(design.bottom_material).shear_modulus),
            top_shear=np.array(material(design.top_material).shear_modulus),
        )
    raise TypeError(f"no layers for {type(design).__name__}")
