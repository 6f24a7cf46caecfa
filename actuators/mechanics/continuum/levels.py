"""The graded meshes, where the solver looks for them; they are chosen without it too."""

from actuators.meshing.levels import (
    LEVELS,
    LEVELS_WITH_GAPS,
    MOST_LAYERS,
    NAMES,
    Layers,
    MeshChoice,
    layers_of,
    levels_of,
)

__all__ = [
    "LEVELS", "LEVELS_WITH_GAPS", "MOST_LAYERS", "NAMES", "Layers", "MeshChoice", "layers_of",
    "levels_of",
]  # fmt: skip
