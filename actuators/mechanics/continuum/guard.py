"""Looks after what was left out: whether surfaces that were expected to stay apart come to touch.

A few differences of positions a state, no search. A state that passes is an equilibrium with
contact too, for contact begins at a smaller distance; one that does not is solved again with it.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from actuators.mechanics.continuum.cavity_gap import CavityWalls
from actuators.mechanics.continuum.contact.surface import ONSET
from actuators.mechanics.continuum.facing_walls import FacingWalls
from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.system import State
from actuators.mechanics.effects.contacts import NEAR
from actuators.mechanics.effects.reach import self_clearance
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh

STILL_OPEN = 0.15
"""Share of its distance at rest to which a gap may close before contact is switched on: faces bulge
between the nodes that are compared."""
ONSETS = 2.0
"""Distances at which contact sets in that must be left besides."""
KEPT = 2


@dataclass(frozen=True)
class Alarm:
    """The effect that a state calls for, and what was seen there."""

    name: str
    seen: str


class Guard:
    """Watches the effects ``watched`` of ``scene`` on ``mesh``. :meth:`see` is told every state of
    a path in order; after an alarm it remembers the last states before it."""

    def __init__(self, mesh: HexMesh, scene: Scene, watched: Sequence[str]) -> None:
        self._mesh, self._scene, self._watched = mesh, scene, tuple(watched)
        size = float(np.ptp(mesh.nodes, axis=0).max())
        self._least = ONSETS * ONSET * size
        width, height = np.ptp(mesh.nodes[:, 1:], axis=0)
        self._thickness = max(float(width) * (2.0 if mesh.is_half else 1.0), float(height))
        watches = "self_contact" in self._watched
        self._walls = FacingWalls(mesh) if watches else None
        self._cavity = CavityWalls(mesh) if watches else None
        self.alarm: Alarm | None = None
        self.at: Equilibrium | None = None
        self.before: list[Equilibrium] = []

    def see(self, found: Equilibrium) -> None:
        """Look at the next state of the path."""
        if self.alarm is not None:
            return
        self.alarm = self.look(found.state)
        if self.alarm is None:
            self.before = [*self.before, found][-KEPT:]
        else:
            self.at = found

    def look(self, state: State) -> Alarm | None:
        """The first effect that ``state`` calls for."""
        for name in self._watched:
            seen = self._self(state) if name == "self_contact" else self._obstacle(name, state)
            if seen is not None:
                return Alarm(name, seen)
        return None

    def _self(self, state: State) -> str | None:
        if self._walls is not None and len(self._walls.at_rest):
            left = self._walls.distances(state.displacement)
            if (left < STILL_OPEN * self._walls.at_rest + self._least).any():
                share = float((left / self._walls.at_rest).min())
                return f"neighbouring walls had closed {1 - share:.0%} of the gap between them"
        if self._cavity is not None:
            share = self._cavity.openness(state.displacement)
            if share < STILL_OPEN:
                return f"walls of the cavity had closed {1 - share:.0%} of the way between them"
        line = self._mesh.underside_line
        clearance = self_clearance(
            self._mesh.nodes[line] + state.displacement[line], self._thickness
        )
        return "the body had curled up onto itself" if clearance < NEAR else None

    def _obstacle(self, name: str, state: State) -> str | None:
        plate = name == "plate_contact"
        obstacle = self._scene.plate if plate else self._scene.cylinder
        if obstacle is None:
            return None
        nodes = self._mesh.nodes
        positions = nodes + state.displacement
        if isinstance(obstacle, Plate):
            normal = np.array(obstacle.normal)
            at_rest = obstacle.gap
            left = float((positions @ normal).min() - (nodes @ normal).min()) + at_rest
        else:
            at_rest, left = _from_cylinder(nodes, obstacle), _from_cylinder(positions, obstacle)
        if left >= STILL_OPEN * at_rest + self._least:
            return None
        return f"the body had come to {left * 1e3:.2g} mm from the {name.removesuffix('_contact')}"


def _from_cylinder(positions: np.ndarray, cylinder: Cylinder) -> float:
    axis = np.array(cylinder.axis)
    away = positions - np.array(cylinder.centre)
    away = away - np.outer(away @ axis, axis)
    return float(np.linalg.norm(away, axis=1).min()) - cylinder.radius
