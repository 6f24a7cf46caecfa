"""Energy model of a chamber, vectorised over chambers and designs."""

from actuators.mechanics.energy_model.constant import (
    Constant,
    check_constant,
    computed_constant,
    published_constant,
)
from actuators.mechanics.energy_model.energy import (
    moments,
    plate_strains,
    plate_strains_compressible,
    rod_strains,
)
from actuators.mechanics.energy_model.layers import (
    Layers,
    design_layers,
    oblique_layers,
    slab_layers,
)

__all__ = [
    "Constant", "Layers", "check_constant", "computed_constant", "design_layers", "moments",
    "oblique_layers", "plate_strains", "plate_strains_compressible", "published_constant",
    "rod_strains", "slab_layers",
]  # fmt: skip
