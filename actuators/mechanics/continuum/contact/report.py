"""What contact did along a path: forces, pressures, penetrations."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from actuators.mechanics.continuum.contact.obstacle import Obstacle
from actuators.mechanics.continuum.contact.self_contact import SelfContact
from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.system import ContinuumSystem
from actuators.mechanics.obstacles import Cylinder, Plate

UNSEEN = 0.2
"""Of a cylinder's radius: deeper than that it has slipped between the points of contact."""
_Measure = Callable[[np.ndarray], float]


@dataclass(frozen=True, eq=False)
class Touching:
    """One pair of surfaces along a path of k points: ``force`` (k,) resultant on an obstacle [N],
    of the whole body (zero for the body against itself), ``pressure`` (k,) the largest [Pa],
    ``depth`` the largest penetration [m]."""

    force: np.ndarray
    pressure: np.ndarray
    depth: float


@dataclass(frozen=True, eq=False)
class ContactReport:
    """What was looked for and found; None for what was not part of the problem."""

    plate: Touching | None
    cylinder: Touching | None
    itself: Touching | None

    @property
    def pressure(self) -> np.ndarray | None:
        """(k,) largest contact pressure anywhere [Pa], None where nothing could touch."""
        parts = [t.pressure for t in (self.plate, self.cylinder, self.itself) if t is not None]
        return np.max(parts, axis=0) if parts else None


def contact_report(system: ContinuumSystem, points: Sequence[Equilibrium]) -> ContactReport:
    """Contact at every point; where a point was interpolated, so are force and pressure: contact
    is too stiff for the positions there."""
    found: dict[type, Touching] = {}
    halves = 2.0 if system.mesh.is_half else 1.0
    for interaction in system.interactions:
        if isinstance(interaction, Obstacle):
            found[type(interaction.obstacle)] = _obstacle(system, points, interaction, halves)
        elif isinstance(interaction, SelfContact):
            pressure = _along(system, points, interaction.largest_pressure)
            depth = _deepest(system, points, interaction)
            if SelfContact in found:  # of the cavity's walls, and of the outside
                pressure = np.maximum(pressure, found[SelfContact].pressure)
                depth = max(depth, found[SelfContact].depth)
            found[SelfContact] = Touching(np.zeros(len(points)), pressure, depth)
    return ContactReport(found.get(Plate), found.get(Cylinder), found.get(SelfContact))


def unseen_notes(system: ContinuumSystem, points: Sequence[Equilibrium]) -> list[str]:
    """A note on a cylinder so thin that it enters the body between the points where contact is
    looked for."""
    notes: list[str] = []
    for interaction in system.interactions:
        if not isinstance(interaction, Obstacle) or isinstance(interaction.obstacle, Plate):
            continue
        nodes = system.mesh.nodes
        depth = max((interaction.depth(nodes + p.state.displacement) for p in points), default=0.0)
        if depth > UNSEEN * interaction.obstacle.radius:
            notes.append(
                f"The cylinder enters the body by {depth * 1e3:.2g} mm between the points where "
                "this mesh looks for contact: its force is too small. Take a finer mesh, or a "
                "cylinder of a larger radius."
            )
    return notes


def contact_pressure(system: ContinuumSystem, found: Equilibrium) -> np.ndarray:
    """(n,) contact pressure [Pa] at the mesh's nodes, per area as it is; of an equilibrium that was
    solved, not interpolated."""
    positions = system.mesh.nodes + found.state.displacement
    total = np.zeros(len(positions))
    for interaction in system.interactions:
        total += interaction.contact_pressure(positions)
    return total


def obstacle_force(system: ContinuumSystem, found: Equilibrium) -> float | None:
    """Force on the plate, or else on the cylinder [N], of the mesh's own part; None where there is
    neither."""
    positions = system.mesh.nodes + found.state.displacement
    forces = [i.force(positions) for i in system.interactions if isinstance(i, Obstacle)]
    return float(np.linalg.norm(forces[0])) if forces else None


def _obstacle(
    system: ContinuumSystem, points: Sequence[Equilibrium], obstacle: Obstacle, halves: float
) -> Touching:
    mirror = np.array([1.0, 0.0, 1.0]) if halves == 2.0 else np.ones(3)

    def force(positions: np.ndarray) -> float:
        return halves * float(np.linalg.norm(mirror * obstacle.force(positions)))

    return Touching(
        _along(system, points, force),
        _along(system, points, obstacle.largest_pressure),
        _deepest(system, points, obstacle),
    )


def _along(system: ContinuumSystem, points: Sequence[Equilibrium], measure: _Measure) -> np.ndarray:
    """(k,) a measure of positions at the solved points, interpolated by volume between them."""
    solved = [e for e in points if e.iterations > 0]
    if not solved:
        return np.zeros(len(points))
    values = [measure(system.mesh.nodes + e.state.displacement) for e in solved]
    order = np.argsort([e.volume for e in solved])
    at = np.array([e.volume for e in solved])[order]
    spread = np.interp([e.volume for e in points], at, np.array(values)[order])
    exact = dict(zip(map(id, solved), values, strict=True))
    return np.array([exact.get(id(e), v) for e, v in zip(points, spread, strict=True)])


def _deepest(
    system: ContinuumSystem,
    points: Sequence[Equilibrium],
    interaction: Obstacle | SelfContact,
) -> float:
    depth = [
        interaction.depth(system.mesh.nodes + e.state.displacement)
        for e in points
        if e.iterations > 0
    ]
    return max(0.0, *depth) if depth else 0.0
