"""The actuator as a rod: pieces of constant law, exact helical segments, weight."""

from actuators.mechanics.rod.answer import centreline, path_points
from actuators.mechanics.rod.pieces import Rod, rod_of
from actuators.mechanics.rod.rotation import helix, segment
from actuators.mechanics.rod.solve import RodPath, end_turn, follow_pressures, weightless

__all__ = [
    "Rod", "RodPath", "centreline", "end_turn", "follow_pressures", "helix", "path_points",
    "rod_of", "segment", "weightless",
]  # fmt: skip
