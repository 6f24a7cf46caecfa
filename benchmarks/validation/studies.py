"""Which cases are computed, family by family."""

from dataclasses import replace

from actuators.design import preset
from actuators.design.base import Design
from actuators.mechanics.scene import Plate, Scene
from benchmarks.validation.case import Case
from benchmarks.validation.published import BELLOWS

SLABS = tuple(
    f"slab-{planform}-{density}"
    for planform in ("rectangle", "triangle", "ellipse")
    for density in ("low", "high")
)
TOPS = ("ecoflex-00-30", "ecoflex-00-50")
OBLIQUES = (15, 30, 45, 60, 75, 90)
SWEEP = (15, 20, 25, 30, 35, 40, 45, 60, 75, 90)
SWEEP_CHAMBERS = 6
"""As many chambers of oblique-45's cell as its length holds at 15 degrees."""


def slab_cases() -> list[Case]:
    """Six planforms, two silicones, to the paper's 40 kPa under their own weight."""
    return [
        Case(f"{name}-{top}", "slab", preset(name).design.changed(top_material=top),
             Scene(pressure_to=40e3, steps=20), 0.1)
        for name in SLABS
        for top in TOPS
    ]  # fmt: skip


def oblique_cases() -> list[Case]:
    """Six presets to the paper's 60 kPa, without weight, as its model."""
    scene = Scene(pressure_to=60e3, steps=6, gravity=None)
    return [Case(f"oblique-{a}", "oblique", preset(f"oblique-{a}").design, scene, 0.3)
            for a in OBLIQUES]  # fmt: skip


def sweep_design(theta: float) -> Design:
    """oblique-45's cell (its lengths along the axis) turned to ``theta`` [degrees]."""
    return preset("oblique-45").design.changed(chamber_count=SWEEP_CHAMBERS, theta=float(theta))


def sweep_cases() -> list[Case]:
    """One cell, turned: what changes with the angle alone."""
    scene = Scene(pressure_to=10e3, steps=4, gravity=None)
    return [Case(f"theta-{a}", "theta", sweep_design(a), scene, 0.3) for a in SWEEP]


def printed_cases() -> list[Case]:
    """The thesis's two materials; its FE tables start from the straight body, so no weight."""
    base = preset("printed-14").design
    return [
        Case("printed-14-linear", "printed", base.changed(material="ninjaflex-linear"),
             Scene(pressure_to=250e3, steps=25, gravity=None), 0.3),
        Case("printed-14-yeoh", "printed", base.changed(material="ninjaflex-yeoh"),
             Scene(pressure_to=250e3, steps=25, gravity=None), 0.3),
    ]  # fmt: skip


def bellows_cases() -> list[Case]:
    """B's nine bodies at the pressures measured: free, and over a plate 5 mm below."""
    cases: list[Case] = []
    for count, wall, bar, *_ in BELLOWS:
        name = f"bellows-{count}-{wall:.1f}"
        free = Scene(pressure_to=bar * 1e5, steps=1)
        pressed = replace(free, plate=Plate(gap=5e-3, normal=(0.0, 0.0, 1.0)))
        design = preset(name).design
        cases.append(Case(f"{name}-free", "bellows", design, free, 0.3))
        cases.append(Case(f"{name}-plate", "bellows", design, pressed, 0.3))
    return sorted(cases, key=lambda case: case.key.endswith("plate"))


def all_cases() -> list[Case]:
    return [
        *slab_cases(), *sweep_cases(), *printed_cases(), *bellows_cases(), *oblique_cases(),
    ]  # fmt: skip
