"""States that equilibrium allows and a real actuator does not, because something is in the way that
no contact of the model holds up: the walls of the cavity where they have no contact with each
other or are too coarse to feel it, and the mount behind the clamp."""

import numpy as np

from actuators.mechanics.continuum.cavity_gap import CavityWalls
from actuators.mechanics.continuum.kernel.cavity import cavity_volume
from actuators.mechanics.continuum.system import State
from actuators.meshing import HexMesh

CROSSED = "walls of the cavity run through each other, and there is no contact inside it here"
MOUNTED = "the body has curled round into its own mount, behind the clamp"
HALVED = (
    "side walls of the cavity have met on the middle plane, where half a body has no contact with "
    "its mirror image"
)
EMPTIED = "the cavity is sucked empty"
EMPTY = 1e-3
"""Of the cavity's volume at rest: with less, walls have met that no contact kept apart."""
BEHIND = 0.02
"""How far behind the clamp's plane the body must be [its height], ..."""
WELL_INSIDE = 0.05
"""... and how far inside the edges of its clamped section [widths and heights], to be in the mount:
next to the clamp it bulges."""


class Unmodelled:
    """Looks at states of ``mesh``; a few differences of positions each. ``cavity_held``: whether
    walls of the cavity are in contact where they meet."""

    def __init__(self, mesh: HexMesh, *, cavity_held: bool) -> None:
        self._mesh = mesh
        self._walls, self._held = CavityWalls(mesh), cavity_held
        self._at_rest = self._volume(mesh.nodes)
        self._outside = np.setdiff1d(np.unique(mesh.outer_faces.nodes), mesh.clamp_nodes)
        section = mesh.nodes[mesh.clamp_nodes][:, 1:]
        low, high = section.min(axis=0, initial=np.inf), section.max(axis=0, initial=-np.inf)
        inset = WELL_INSIDE * (high - low)
        self._low, self._high = low + inset, high - inset
        if mesh.is_half:
            self._low[0] = -self._high[0]
        self._behind = BEHIND * float(np.ptp(mesh.nodes[:, 2]))

    def why(self, state: State) -> str | None:
        """What is in the way of ``state``, None where nothing is."""
        if self._walls.from_the_middle(state.displacement) < 0.0:
            return HALVED
        if not self._held and self._walls.openness(state.displacement) < 0.0:
            return CROSSED
        if self._volume(self._mesh.nodes + state.displacement) < EMPTY * self._at_rest:
            return EMPTIED
        now = self._mesh.nodes[self._outside] + state.displacement[self._outside]
        behind = now[now[:, 0] < -self._behind, 1:]
        inside = ((behind > self._low) & (behind < self._high)).all(axis=1)
        return MOUNTED if inside.any() else None

    def _volume(self, positions: np.ndarray) -> float:
        """Of the cavity [m3] at ``positions`` (n, 3) [m]; 0 without one."""
        faces = self._mesh.cavity_faces.nodes
        return float(cavity_volume(positions, faces, np.empty_like(positions)))
