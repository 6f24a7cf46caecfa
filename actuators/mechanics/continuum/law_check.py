"""How far the neo-Hookean laws that were computed are from the materials' own in a state."""

import numpy as np

from actuators.mechanics.continuum.assembly import region_materials
from actuators.mechanics.continuum.surface_fields import StrainRecovery
from actuators.mechanics.continuum.system import ContinuumSystem, State


def law_difference(system: ContinuumSystem, state: State) -> float:
    """Difference of the strain energies of the whole body, each place by the stretches it has, as
    a fraction; 0 for an undeformed body."""
    stretch, _ = StrainRecovery(system).tensors(state)
    isochoric = stretch / np.cbrt(stretch.prod(axis=-1, keepdims=True))
    corner = system.mesh.nodes[system.mesh.elements]
    size = np.ptp(corner, axis=1).prod(axis=1)
    computed = true = 0.0
    for number, own in enumerate(region_materials(system.mesh)):
        here = system.mesh.region == number
        plain = system.materials[number].law.energy(isochoric[here]).mean(axis=-1)
        computed += float(size[here] @ plain)
        true += float(size[here] @ own.law.energy(isochoric[here]).mean(axis=-1))
    return abs(true / computed - 1.0) if computed > 0.0 else 0.0
