"""What the force on an obstacle may be off by, and the tip that it holds.

Beside its clamp a body hardly moves, and the rod feels no obstacle there. One that stands against
the body's underside there is pressed by what the rod does not have: floors that bulge between
walls, with a lever as short as the way from the clamp. If the rod felt it from half a height on
instead of one, a slab's force would be half as much again to three times as large; what 3D finds
lies in between for slabs, and beyond for bellows, whose every chamber presses.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from actuators.mechanics.rod.pieces import outline
from actuators.mechanics.rod.surroundings import BESIDE_CLAMP, obstacles_of
from actuators.mechanics.rod.touching import gap

if TYPE_CHECKING:
    from actuators.mechanics.cell_rod.answer import Question, Solved

AGAINST = 0.02
"""Distance at rest, over the body's height, below which an obstacle counts as against it: floors
bulge by about as much."""
MEASURED = {"slab": 0.1, "oblique": 0.1, "printed": 0.1, "bellows": 0.25}
"""Largest deviation of a plate's force from 3D at the end of presets' paths, over the rod's own
force; plates half a millimetre away and more, with weight and without (docs/cell_rod.md)."""
MEASURED_AGAINST = {"slab": 1.1, "oblique": 0.25, "printed": 0.5, "bellows": 3.0}
"""The same, plates that touch at rest: 3D's force is larger by up to so much."""


def force_estimate(question: Question, solved: Solved) -> float | None:
    """Expected error of the forces on obstacles, over those found; None where none is pressed."""
    if not solved.path.obstacle_force.any():
        return None
    family = question.design.family
    return MEASURED_AGAINST[family] if is_against_the_clamp(question) else MEASURED[family]


def held_by(question: Question, solved: Solved) -> float:
    """What obstacles add to the expected error of the tip, over its way: their surface lies as far
    off as floors bulge (:data:`AGAINST`), and as the rod enters them. Of a long way that is little,
    of the way left by a plate 3 mm off most: the tip of slab-rectangle-low at 5 kPa is 9 % off in
    3D, and 47 % where the plate touches at rest. 0 where none is pressed."""
    path = solved.path
    if not path.obstacle_force.any():
        return 0.0
    rest = np.array([question.design.length, 0.0, 0.0])
    way = float(np.linalg.norm(path.positions[:, -1] - rest, axis=1).max())
    depth = float(path.penetration.max(initial=0.0))
    height = float(outline(question.design, question.layout.stations)[1])
    return (AGAINST * height + depth) / way if way > 0.0 else np.inf


def is_against_the_clamp(question: Question) -> bool:
    """Whether an obstacle touches the undeformed body, or nearly so, where the rod feels none."""
    obstacles = obstacles_of(question.design, question.layout, question.scene, 0.0)
    height = outline(question.design, question.layout.stations)[1]
    beside = np.flatnonzero(question.layout.stations < BESIDE_CLAMP * height)
    normal = np.zeros(3)
    distances = [
        gap(kind, place, direction, radius,
            np.array([question.layout.stations[n], across, above]), normal)
        for n in beside
        for across, above in zip(obstacles.across[n], obstacles.above[n], strict=True)
        for kind, place, direction, radius in zip(
            obstacles.kind, obstacles.place, obstacles.direction, obstacles.radius, strict=True
        )
    ]  # fmt: skip
    return min(distances, default=np.inf) < AGAINST * height
