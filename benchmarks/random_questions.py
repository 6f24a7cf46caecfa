"""Random designs of every family, and scenes around them, from a seed: what studies ask about.

A design is a preset whose lengths are scaled one by one, with fewer chambers so that solving is
cheap. A scene is sized by the energy rung: its pressure by a strain, a plate's gap by the tip's
travel, a force by the body's weight.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from actuators.design import FAMILIES, Design, DesignError, preset
from actuators.mechanics.cell.row import ChamberRow, chamber_row
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.predict import predict
from actuators.mechanics.scene import STRONGEST, Scene

STARTS = {
    "slab": ("slab-rectangle-low", "slab-rectangle-high", "slab-triangle-low", "slab-ellipse-low"),
    "oblique": ("oblique-30", "oblique-45", "oblique-60", "oblique-75", "oblique-90"),
    "printed": ("printed-14",),
    "bellows": ("bellows-9-1.6", "bellows-9-2.0", "bellows-9-2.4"),
}
SPREAD = 0.25
"""Lengths are scaled by exp(+-SPREAD) at most."""
STRAINS = {"slab": (0.03, 0.4), "oblique": (0.03, 0.25), "printed": (0.02, 0.2),
           "bellows": (0.01, 0.08)}  # fmt: skip
"""Largest strain that the energy rung expects at the last pressure, drawn evenly in its logarithm.
Bellows and printed bars are far beyond what their presets are meant for at the upper ends."""
KINDS = (
    "pressure", "pressure", "pressure", "tip force", "outside pressure", "volume", "plate",
    "cylinder", "no self-contact",
)  # fmt: skip


@dataclass(frozen=True)
class RandomQuestion:
    """A design in a scene, and what kind of scene it is."""

    design: Design
    scene: Scene
    kind: str


def random_design(rng: np.random.Generator, family: str, chambers: tuple[int, int]) -> Design:
    """A design of ``family`` that can be built, with a number of chambers in the range given."""
    while True:
        start = preset(str(rng.choice(STARTS[family]))).design
        changes: dict[str, float] = {}
        for p in start.parameters():
            if p.kind == "length":
                value = getattr(start, p.name) / p.si_per_unit
                changes[p.name] = round(float(value * np.exp(rng.uniform(-SPREAD, SPREAD))), 2)
        count = int(rng.integers(chambers[0], chambers[1] + 1))
        before = getattr(start, "chamber_count")  # noqa: B009 (every family has one)
        if family != "oblique" or count < before:
            changes["chamber_count"] = count
            changes["length"] = round(changes["length"] * count / before, 2)
        try:
            return start.changed(**changes)
        except DesignError:
            continue


def random_scene(rng: np.random.Generator, design: Design, kind: str) -> Scene:
    """A scene of ``kind`` that the design can be expected to bear."""
    row = chamber_row(design)
    low, high = np.log(STRAINS[design.family])
    pressure = float(np.exp(rng.uniform(low, high))) / row.largest_strain
    pressure = min(pressure, STRONGEST)
    steps = None if rng.random() < 0.7 else int(rng.integers(4, 13))
    if kind == "volume":
        volume = row.cavity_volume.sum() + row.cavity_compliance.sum() * pressure
        return Scene(volume_to=float(volume), steps=steps)
    more: dict[str, object] = {}
    if kind == "tip force":
        force = _weight(row) * rng.uniform(0.2, 1.0) * rng.choice([-1.0, 1.0])
        more["tip_force"] = (0.0, 0.0, float(force))
    elif kind == "outside pressure":
        more["outside_pressure"] = 0.05 * pressure * float(rng.uniform(-1, 1))
    elif kind == "no self-contact":
        more["self_contact"] = "off"
    elif kind in ("plate", "cylinder"):
        tip = predict(design, Scene(pressure, steps=4)).path[-1].tip
        travel = max(-tip[2], 0.01 * design.length)
        gap = float(travel * rng.uniform(0.2, 0.8))
        if kind == "plate":
            more["plate"] = Plate(gap)
        else:
            radius = float(rng.uniform(0.1, 0.3)) * design.length
            at = float(rng.uniform(0.5, 0.9)) * design.length
            more["cylinder"] = Cylinder(radius, (at, 0.0, -(radius + gap)))
    return Scene(pressure, steps=steps, **more)  # pyright: ignore[reportArgumentType]


def _weight(row: ChamberRow) -> float:
    return float(row.line_mass.sum() * row.pitch * 9.81)


def random_questions(seed: int, chambers: tuple[int, int] = (2, 7)) -> Iterator[RandomQuestion]:
    """Without end: the families in turn, the kinds of scene at random."""
    rng = np.random.default_rng(seed)
    while True:
        for family in FAMILIES:
            design = random_design(rng, family, chambers)
            kind = str(rng.choice(KINDS))
            yield RandomQuestion(design, random_scene(rng, design, kind), kind)
