"""A linear law under the loads that the plain rod does not know: tip force, outside pressure."""

import numpy as np

from actuators.design import Design
from actuators.mechanics.cell.row import ChamberRow
from actuators.mechanics.rod.follow import Laws, follow_laws
from actuators.mechanics.rod.pieces import layout_of
from actuators.mechanics.rod.solve import RodPath
from actuators.mechanics.rod.surroundings import chain_of, obstacles_of
from actuators.mechanics.scene import Scene

UNSHEARED = 1e3
"""Shear stiffness over the axial one where a rod's law knows no shear."""


def follow_scene(
    design: Design, row: ChamberRow, free: np.ndarray, pressures: np.ndarray, scene: Scene
) -> RodPath:
    """Shapes at ``pressures`` (k,) [Pa] with ``free`` (n, 4) rod strains per pressure."""
    layout = layout_of(design, row)
    s, k = len(layout.length), len(pressures)
    stiffness = np.zeros((s, 6, 6))
    stiffness[:, :4, :4] = layout.stiffness(row.stiffness)
    stiffness[:, 4, 4] = stiffness[:, 5, 5] = UNSHEARED * stiffness[:, 0, 0]
    strains = np.zeros((k, s, 6))
    strains[..., :4] = pressures[:, None, None] * layout.free(free)
    every = np.broadcast_to(stiffness, (k, s, 6, 6))
    moment = float(np.abs(stiffness @ strains[-1][..., None])[:, 1:4].max(initial=0.0))
    obstacles = obstacles_of(design, layout, scene, moment)
    laws = Laws(strains, every, np.zeros((s, 2)))
    path = follow_laws(laws, chain_of(design, layout, scene), obstacles)
    return RodPath(path.strains[..., :4], path.positions, path.frames, path.iterations)
