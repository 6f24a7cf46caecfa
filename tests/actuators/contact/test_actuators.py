"""Actuators in contact: neighbouring walls, a plate below, a cylinder beside."""

import numpy as np
import pytest

from actuators.design import preset
from actuators.errors import QuestionError
from actuators.geometry import build_body
from actuators.mechanics.continuum import solve
from actuators.mechanics.continuum.contact.report import contact_pressure
from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.level import Level, open_level
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.tracer import Path
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.response import Effect, Outcome, Response
from actuators.mechanics.scene import Scene
from actuators.meshing import mesh_body

TWO_WALLS = preset("oblique-90").design.changed(
    chamber_count=2, length=26, channel_width=0, half_gap=0.15
)
SLAB = preset("slab-rectangle-low").design.changed(chamber_count=2, length=36, width=20)


def effect(response: Response, name: str) -> Effect:
    return next(e for e in response.effects if e.name == name)


def on_the_coarsest_mesh(scene: Scene) -> tuple[Level, Path]:
    level = open_level(mesh_body(build_body(SLAB).half()), scene)
    goal = Goal.of(scene, is_half=True)
    return level, PathFollower(level.system, level.solver).reach(goal)


def test_walls_that_meet_carry_pressure_and_bend_the_actuator_further() -> None:
    scene = Scene(pressure_to=8e3, gravity=None)
    touching = solve(TWO_WALLS, scene, accuracy=0.5)
    apart = solve(TWO_WALLS, Scene(8e3, gravity=None, self_contact="off"), accuracy=0.5)
    last = touching.path[-1]
    assert last.pressure == pytest.approx(8e3)
    assert last.max_contact_pressure is not None
    # walls are held between the pressures of two chambers; edges carry a few times that
    assert 8e3 < last.max_contact_pressure < 40e3
    assert not touching.notes or "overlap" not in " ".join(touching.notes)
    assert effect(touching, "self_contact").on
    assert not effect(apart, "self_contact").on
    assert apart.path[-1].max_contact_pressure is None
    # chambers that push each other apart bend more
    assert last.tip_displacement[2] < 1.2 * apart.path[-1].tip_displacement[2] < 0


def test_facing_walls_press_each_other_alike_and_hardly_enter() -> None:
    scene = Scene(pressure_to=4e3, gravity=None)
    mesh = mesh_body(build_body(TWO_WALLS).half())
    level = open_level(mesh, scene)
    path = PathFollower(level.system, level.solver).reach(Goal.of(scene, is_half=True))
    found = path.points[-1]
    pressure = contact_pressure(level.system, found)
    touched = np.flatnonzero(pressure > 0)
    # each node of one wall has its opposite number on the other, 0.3 mm away
    pairs = 0
    for node in touched:
        apart = np.abs(mesh.nodes[touched] - mesh.nodes[node] - [0.3e-3, 0.0, 0.0])
        opposite = touched[(apart < 1e-9).all(axis=1)]
        pairs += len(opposite)
        if len(opposite) == 0:
            continue
        assert pressure[opposite[0]] == pytest.approx(
            pressure[node], rel=0.2, abs=0.05 * pressure.max()
        )
    assert pairs > 2
    gaps = level.system.interactions[-1].gaps(mesh.nodes + found.state.displacement)  # type: ignore[attr-defined]
    assert gaps.min() > -1e-5


def test_plate_force_and_clamp_carry_the_weight() -> None:
    level, path = on_the_coarsest_mesh(Scene(pressure_to=4e3, plate=Plate(0.5e-3)))
    system, found = level.system, path.points[-1]
    contact = system.interactions[0]
    residual = system.balance(found.state, found.pressure).residual
    clamp = residual[system.mesh.clamp_nodes].sum(axis=0)
    on_plate = contact.force(system.mesh.nodes + found.state.displacement)  # type: ignore[attr-defined]
    mass = sum(m.density * v for m, v in zip(system.materials, _volumes(level), strict=True))
    # forces on the body: the clamp's, the plate's (against that on the plate) and its weight
    assert clamp[2] - on_plate[2] - 9.81 * mass == pytest.approx(0.0, abs=1e-3 * 9.81 * mass)
    assert on_plate[2] < 0


def _volumes(level: Level) -> list[float]:
    """Undeformed volume of each region by its boxes, exact for straight ones."""
    mesh = level.system.mesh
    corner = mesh.nodes[mesh.elements]
    size = np.ptp(corner, axis=1).prod(axis=1)
    return [float(size[mesh.region == r].sum()) for r in range(len(mesh.regions))]


def test_a_plate_stops_the_tip_and_its_force_grows() -> None:
    found = solve(SLAB, Scene(pressure_to=6e3, steps=3, plate=Plate(0.5e-3)), accuracy=0.3)
    forces = [p.plate_force for p in found.path]
    assert forces == sorted(forces, key=lambda f: f or 0.0)
    assert forces[-1] is not None
    assert forces[-1] > 0.05
    assert found.path[-1].tip_displacement[2] == pytest.approx(-0.5e-3, abs=0.02e-3)
    assert "force" in found.error_estimates
    assert effect(found, "plate_contact").on


def test_a_plate_far_away_changes_nothing() -> None:
    _, without = on_the_coarsest_mesh(Scene(pressure_to=4e3, steps=2))
    _, far = on_the_coarsest_mesh(Scene(pressure_to=4e3, steps=2, plate=Plate(50e-3)))
    for one, other in zip(without.points, far.points, strict=True):
        assert np.array_equal(one.state.displacement, other.state.displacement)


def test_a_cylinder_in_the_way_is_pressed_and_one_inside_the_body_refused() -> None:
    below = Cylinder(5e-3, (30e-3, 0.0, -5.5e-3))
    found = solve(SLAB, Scene(pressure_to=4e3, steps=2, cylinder=below), accuracy=0.5)
    force = found.path[-1].cylinder_force
    assert force is not None
    assert force > 0.01
    assert found.path[-1].plate_force is None
    with pytest.raises(QuestionError, match="undeformed body"):
        solve(SLAB, Scene(pressure_to=4e3, cylinder=Cylinder(5e-3, (30e-3, 0.0, 0.0))))


def test_large_slanted_faces_are_not_taken_for_the_curled_up_end() -> None:
    """At 15 degrees the faces of the end pieces reach over half the bar: sides and underside of
    one corner are near each other without ever meeting."""
    with_contact, without = (
        solve(preset("oblique-15").design, Scene(0.0, self_contact=choice), mesh="coarse")
        for choice in ("auto", "off")
    )
    assert with_contact.outcome is Outcome.CONVERGED
    assert with_contact.path[0].tip == pytest.approx(without.path[0].tip, rel=1e-6)
