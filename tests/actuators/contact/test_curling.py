"""A soft body that, inflated, curls round until its tip presses on its own underside."""

from dataclasses import dataclass

import numpy as np
import pytest

from actuators.geometry import CAVITY, OUTSIDE, Body, Region
from actuators.materials import Material, NeoHooke
from actuators.mechanics.continuum.contact import ContactLaw, Interaction, SelfContact, outside
from actuators.mechanics.continuum.contact.build import expected_pressure, interactions
from actuators.mechanics.continuum.contact.points import WALL_POINTS, contact_areas
from actuators.mechanics.continuum.contact.surface import ContactSurface, contact_law
from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.sections import rod_shape
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.continuum.tracer import Path
from actuators.mechanics.direct_solver import open_solver
from actuators.mechanics.response import Outcome
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh, mesh_body

MATERIALS = (
    Material("bottom", "bottom", NeoHooke(0.3e6), 1070.0, "test"),
    Material("top", "top", NeoHooke(0.04e6), 1070.0, "test"),
)
ROOT, BLOCK, GAP, CHAMBERS, END = 14.0, (0.5, 1.5, 0.5), 1.0, 10, 2.0
PRESSURE = 9.7e3
SCENE = Scene(PRESSURE, gravity=None)


def curler() -> Body:
    """50 mm long, 5.2 mm high, 6.2 mm wide: a solid root, then ten soft chambers that stand apart
    on a bottom of 0.4 mm, and a thin end."""
    steps = [*[ROOT / 2] * 2, *([*BLOCK, GAP] * CHAMBERS)[:-1], END]
    fill = np.ones((len(steps), 4, 4), dtype=np.int8)
    fill[:, :, 0] = 0
    fill[3:-1:4, 1:3, 2] = CAVITY
    fill[5:-1:4, :, 2:] = OUTSIDE
    fill[-1, :, 2:] = OUTSIDE
    return Body(
        lines=(
            np.concatenate([[0.0], np.cumsum(steps)]) * 1e-3,
            np.array([-3.1, -2.5, 0.0, 2.5, 3.1]) * 1e-3,
            np.array([0.0, 0.4, 0.7, 4.7, 5.3]) * 1e-3,
        ),
        fill=fill,
        regions=(Region("bottom layer", "bottom"), Region("top layer", "top")),
        place=lambda lattice: np.array(lattice, dtype=float),
        symmetric=True,
    )


@dataclass(frozen=True, eq=False)
class Curling:
    """Problem and path; ``contact`` looks at states, whatever the problem holds."""

    system: ContinuumSystem
    path: Path
    contact: SelfContact

    @property
    def onset(self) -> float:
        """Distance [m] at which contact begins."""
        return law_of(self.system.mesh).onset

    def positions(self, found: Equilibrium) -> np.ndarray:
        return self.system.mesh.nodes + found.state.displacement

    def turned(self, found: Equilibrium) -> float:
        """Angle of the free end, in degrees."""
        return float(np.degrees(rod_shape(self.system.mesh, [found.state]).tip_rotation[0]))


@pytest.fixture(scope="module")
def mesh() -> HexMesh:
    return mesh_body(curler().half())


def outer_contact(mesh: HexMesh) -> SelfContact:
    return next(
        each for each in reversed(interactions(mesh, MATERIALS, SCENE))
        if isinstance(each, SelfContact)
    )  # fmt: skip


def law_of(mesh: HexMesh) -> ContactLaw:
    return contact_law(mesh, MATERIALS, expected_pressure(mesh, MATERIALS, SCENE))


def follow(
    mesh: HexMesh, held: tuple[Interaction, ...], after: tuple[Equilibrium, ...] = ()
) -> Curling:
    system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh), interactions=held)
    follower = PathFollower(system, open_solver(system.indptr, system.indices))
    goal = Goal.pressure(PRESSURE)
    path = follower.resume(after, after[0], goal) if after else follower.reach(goal)
    return Curling(system, path, outer_contact(mesh))


@pytest.fixture(scope="module")
def held(mesh: HexMesh) -> Curling:
    return follow(mesh, interactions(mesh, MATERIALS, SCENE))


def faces_under_the_root(mesh: HexMesh, faces: np.ndarray) -> np.ndarray:
    """Mask (f,) of faces of the root's underside."""
    at = mesh.nodes[faces]
    return (at[..., 2] == 0.0).all(axis=1) & (at[..., 0] <= ROOT * 1e-3 + 1e-9).all(axis=1)


def force_under_the_root(found: Curling, at: Equilibrium) -> float:
    """Upward force [N] of contact on the root's underside."""
    mesh, positions = found.system.mesh, found.positions(at)
    faces = outside(mesh, WALL_POINTS).faces
    under = np.unique(faces[faces_under_the_root(mesh, faces)])
    slope = np.zeros_like(positions)
    found.contact.add(positions, slope, None)
    return -float(slope[under, 2].sum())


@pytest.mark.slow
def test_an_inflated_body_that_curls_up_presses_on_its_own_underside(held: Curling) -> None:
    assert held.path.outcome is Outcome.CONVERGED
    last = held.path.points[-1]
    assert last.pressure == pytest.approx(PRESSURE)
    assert 300 < held.turned(last) < 330
    size = float(np.ptp(held.system.mesh.nodes[:, 0]))
    deepest = max(held.contact.depth(held.positions(p)) for p in held.path.points)
    assert deepest < 2e-4 * size, "the tolerance of contact"
    # the root's underside is pressed upwards, and only once the body has come round
    pressed = [force_under_the_root(held, p) for p in held.path.points]
    touching = [k for k, force in enumerate(pressed) if force > 0.0]
    assert len(touching) >= 3
    assert touching == list(range(touching[0], len(pressed)))
    assert held.turned(held.path.points[touching[0]]) > 290
    assert pressed[-1] > 2e-4
    # what comes round is the last chamber's roof
    surface = outside(held.system.mesh, WALL_POINTS)
    near = surface.faces[(held.contact.gaps(held.positions(last)) < held.onset).any(axis=1)]
    along, up = held.system.mesh.nodes[near][:, 4, [0, 2]].T
    assert ((along > 45e-3) & (up > 4.5e-3)).any()


@pytest.mark.slow
def test_contact_of_the_body_with_itself_has_no_resultant(held: Curling) -> None:
    positions = held.positions(held.path.points[-1])
    force = np.zeros_like(positions)
    held.contact.add(positions, force, None)
    largest = float(np.abs(force).sum(axis=0).max())
    assert largest > 1e-3
    mirrored = force.sum(axis=0) * [1.0, 0.0, 1.0]
    assert np.abs(mirrored).max() < 1e-9 * largest


@pytest.mark.slow
def test_without_contact_under_the_root_the_tip_goes_through_it(
    mesh: HexMesh, held: Curling
) -> None:
    surface = outside(mesh, WALL_POINTS)
    kept = np.ascontiguousarray(surface.faces[~faces_under_the_root(mesh, surface.faces)])
    walls = ContactSurface(
        mesh.nodes, kept, contact_areas(mesh.nodes, kept, WALL_POINTS), WALL_POINTS
    )
    alone = SelfContact(walls, law_of(mesh), float(np.ptp(mesh.nodes[:, 2])))
    free = [p for p in held.path.points if held.turned(p) < 285]
    through = follow(mesh, (alone,), (free[-2], free[-1]))
    depth = max(held.contact.depth(through.positions(p)) for p in through.path.points)
    assert depth > 0.2e-3
    assert depth > 20 * max(held.contact.depth(held.positions(p)) for p in held.path.points)


@pytest.mark.slow
def test_with_contact_off_the_body_runs_through_itself(mesh: HexMesh) -> None:
    off = follow(mesh, ())
    last = off.path.points[-1]
    assert off.contact.depth(off.positions(last)) > 0.2e-3
    assert off.turned(last) < 290, "walls that push each other apart had bent it further"
