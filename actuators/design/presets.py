"""The actuators of the source papers, by name."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from actuators.design.base import Design
from actuators.design.bellows import BellowsDesign
from actuators.design.oblique import ObliqueDesign
from actuators.design.printed import PrintedDesign
from actuators.design.slab import SlabDesign
from actuators.errors import DesignError


@dataclass(frozen=True)
class Preset:
    """A named starting point. ``pressure_to`` is the pressure it opens at [Pa], which its 3D path
    reaches."""

    name: str
    title: str
    description: str
    source: str
    design: Design
    pressure_to: float


Planform = Literal["rectangle", "triangle", "ellipse"]

# S, Table 1. The tip wall is the remainder that makes h1 = h2 round to the table's value; the side
# wall is what 2 w1 + w0 leaves of the width at the first chamber. Border units (mm).
_SLAB: Mapping[tuple[Planform, str], dict[str, Any]] = {
    ("rectangle", "low"): {"chamber_count": 6, "root_wall": 6.0, "tip_wall": 3.0,
                           "channel_width": 4.0, "side_wall": 3.5},
    ("rectangle", "high"): {"chamber_count": 11, "root_wall": 6.0, "tip_wall": 3.0,
                            "channel_width": 4.0, "side_wall": 3.5},
    ("triangle", "low"): {"chamber_count": 5, "root_wall": 15.7, "tip_wall": 10.3,
                          "channel_width": 5.9, "side_wall": 2.5},
    ("triangle", "high"): {"chamber_count": 11, "root_wall": 11.6, "tip_wall": 10.2,
                           "channel_width": 4.9, "side_wall": 3.3},
    ("ellipse", "low"): {"chamber_count": 6, "root_wall": 4.0, "tip_wall": 4.0,
                         "channel_width": 1.3, "side_wall": 2.56},
    ("ellipse", "high"): {"chamber_count": 9, "root_wall": 12.3, "tip_wall": 13.8,
                          "channel_width": 0.5, "side_wall": 3.87},
}  # fmt: skip

# G, Table 1: t1, t2, t3, l (mm), n
_OBLIQUE: Mapping[int, tuple[float, float, float, float, int]] = {
    15: (3.0, 3.865, 2.135, 104.0, 2),
    30: (1.5, 2.0, 1.0, 104.0, 8),
    45: (1.5, 1.415, 1.085, 107.0, 11),
    60: (1.0, 1.155, 0.845, 104.0, 13),
    75: (1.0, 1.035, 0.965, 104.0, 13),
    90: (1.0, 1.0, 1.0, 104.0, 15),
}


def _slabs() -> list[Preset]:
    presets: list[Preset] = []
    for (planform, density), values in _SLAB.items():
        presets.append(
            Preset(
                name=f"slab-{planform}-{density}",
                title=f"Slab, {planform}, {density} density",
                description=f"{planform.capitalize()} planform, {values['chamber_count']} "
                "chambers, stiff Elastosil bottom under soft Ecoflex. The paper inflated it to "
                "40 kPa; with the assumed thicknesses 3D FE finds limit points from 11.7 to "
                "15.8 kPa.",
                source="Piri and Berezvai 2026 (S), Table 1",
                design=SlabDesign().changed(planform=planform, **values),
                pressure_to=10e3,
            )
        )
    return presets


def _obliques() -> list[Preset]:
    presets: list[Preset] = []
    for theta, (t1, t2, t3, length, n) in _OBLIQUE.items():
        design = ObliqueDesign.from_document(
            {"theta_deg": theta, "half_gap_mm": t1, "wall_thickness_mm": t2,
             "half_chamber_mm": t3, "length_mm": length, "chamber_count": n}
        )  # fmt: skip
        twist = "bends only" if theta == 90 else "bends and twists"
        presets.append(
            Preset(
                name=f"oblique-{theta}",
                title=f"Oblique chambers, {theta} degrees",
                description=f"{n} chambers at {theta} degrees to the axis: {twist}. The paper went "
                "to 60 kPa; with its dimensions 3D FE ends between 30 and 46 kPa.",
                source="Generalized Pneu-Net (G), Table 1",
                design=design,
                pressure_to=20e3,
            )
        )
    return presets


def _printed() -> list[Preset]:
    return [
        Preset(
            name="printed-14",
            title="Printed pneu-net, 14 chambers",
            description="Printed in one piece from NinjaFlex, with a layer in the bottom that "
            "cannot stretch. The thesis inflated it to 250 kPa; length, width, number of chambers "
            "and layer are its own, the other dimensions are assumed.",
            source="Printed pneu-net thesis (P)",
            design=PrintedDesign(),
            pressure_to=250e3,
        )
    ]


# B, Tables 1 and 5: wall (mm) and the pressure it was tested at (bar)
_BELLOWS_WALLS: Mapping[float, float] = {1.6: 1.0, 2.0: 2.0, 2.4: 3.0}


def _bellows() -> list[Preset]:
    return [
        Preset(
            name=f"bellows-{count}-{wall}",
            title=f"Bellows, {count} with {wall} mm walls",
            description=f"{count} rounded bellows with {wall} mm walls, printed sideways; the "
            f"paper inflated them to {bar * 100:g} kPa. The bottom is assumed to be as thick as "
            "the walls.",
            source="3D-printed soft pneumatic actuators (B), Table 1",
            design=BellowsDesign().changed(
                chamber_count=count, wall_thickness=wall, bottom_thickness=wall
            ),
            pressure_to=bar * 1e5,
        )
        for count in (9, 11, 13)
        for wall, bar in _BELLOWS_WALLS.items()
    ]


PRESETS: Mapping[str, Preset] = {
    p.name: p for p in [*_slabs(), *_obliques(), *_printed(), *_bellows()]
}


def preset(name: str) -> Preset:
    """The preset called ``name``; raises :class:`DesignError` naming near ones."""
    if name in PRESETS:
        return PRESETS[name]
    import difflib

    near = difflib.get_close_matches(name, PRESETS, n=3, cutoff=0.3)
    raise DesignError(
        f"design is {name!r}, which is no preset. Try {', '.join(near) or ', '.join(PRESETS)}.",
        field="design", value=name, mend=f"Try {', '.join(near) or ', '.join(PRESETS)}.",
    )  # fmt: skip
