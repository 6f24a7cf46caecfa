"""Paths: gravity, limit points, cancellation, what a response holds."""

import math
from dataclasses import replace

import numpy as np
import pytest

from actuators.design import preset
from actuators.errors import QuestionError
from actuators.mechanics.continuum import Progress, solve
from actuators.mechanics.continuum.findings import sag_notes
from actuators.mechanics.continuum.goal import Goal
from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.system import ContinuumSystem, clamped
from actuators.mechanics.direct_solver import open_solver
from actuators.mechanics.response import Outcome, Response
from actuators.mechanics.scene import Scene
from actuators.meshing import mesh_body
from benchmarks.mini_pneu_net import GRAVITY, MATERIALS, mini_pneu_net

SMALL = preset("slab-rectangle-low").design.changed(chamber_count=2, length=36, width=20)


@pytest.fixture(scope="module")
def inflated() -> Response:
    return solve(SMALL, Scene(pressure_to=6e3, steps=4), accuracy=0.1)


def follow_mini(pressure_to: float, report: list[float] | None = None):
    mesh = mesh_body(mini_pneu_net().half())
    system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh), gravity=GRAVITY)
    solver = open_solver(system.indptr, system.indices)
    return mesh, PathFollower(system, solver).follow(pressure_to, report)


def test_limit_point_is_found_and_passed_by_volume() -> None:
    _, path = follow_mini(25e3)
    assert path.outcome is Outcome.LIMIT_POINT
    # an independent engine found 17.04 kPa at V/V0 = 3.35 on this mesh; V is flat there
    assert path.points[-1].pressure == pytest.approx(17.04e3, abs=0.02e3)
    assert path.points[-1].volume / path.points[0].volume == pytest.approx(3.35, abs=0.06)
    assert path.beyond is not None
    assert path.beyond.volume > path.points[-2].volume
    pressures = [e.pressure for e in path.points]
    assert pressures == sorted(pressures)


def test_path_stops_at_the_reported_pressures() -> None:
    _, path = follow_mini(12e3, [4e3, 8e3, 12e3])
    assert path.outcome is Outcome.CONVERGED
    assert [e.pressure for e in path.points] == pytest.approx([0.0, 4e3, 8e3, 12e3])
    assert all(e.negative_eigenvalues in (0, None) for e in path.points)


def test_a_path_resumed_from_its_first_state_makes_its_own_tangent() -> None:
    """As where contact switches itself on at the first step."""
    mesh, path = follow_mini(1e3, [1e3])
    system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh), gravity=GRAVITY)
    again = PathFollower(system, open_solver(system.indptr, system.indices))
    rest = path.points[0]
    resumed = again.resume([rest], rest, Goal.pressure(1e3, [1e3]))
    assert resumed.outcome is Outcome.CONVERGED
    assert resumed.points[-1].volume == pytest.approx(path.points[-1].volume, rel=1e-6)


def test_a_path_that_is_stopped_keeps_how_far_it_came() -> None:
    mesh = mesh_body(mini_pneu_net().half())
    system = ContinuumSystem(mesh, MATERIALS, free=clamped(mesh), gravity=GRAVITY)
    found: list[Equilibrium] = []
    follower = PathFollower(
        system, open_solver(system.indptr, system.indices), seen=found.append,
        stop=lambda: Outcome.CANCELLED if len(found) > 3 else None,
    )  # fmt: skip
    path = follower.follow(12e3, [12e3])
    assert path.outcome is Outcome.CANCELLED
    assert 0.0 < path.points[-1].pressure < 12e3
    assert path.points[-1] is found[-1]


def test_droop_of_a_solid_bar_is_that_of_a_beam() -> None:
    from actuators.geometry import Body, Region
    from actuators.materials import Material, NeoHooke

    length, width, height, mu, rho = 120e-3, 8e-3, 4e-3, 4e5, 1000.0
    body = Body(
        (np.array([0.0, length]), np.array([-width, 0, width]) / 2, np.array([0.0, height])),
        np.zeros((1, 2, 1), np.int8), (Region("a", "a"),), lambda x: np.array(x, float), True,
    ).half()  # fmt: skip
    mesh = mesh_body(body, uniform=(24, 1, 2), layers=(1, 0, 0))
    system = ContinuumSystem(
        mesh, [Material("a", "a", NeoHooke(mu), rho, "test")], free=clamped(mesh),
        gravity=(0.0, 0.0, -0.05),
    )  # fmt: skip
    path = PathFollower(system, open_solver(system.indptr, system.indices)).follow(0.0, None)
    droop = -path.points[0].state.displacement[mesh.underside_line[-1], 2]
    beam = rho * 0.05 * height * length**4 / (8 * 3 * mu * height**3 / 12)
    # the clamp holds Poisson's contraction over about a width (-1.5 %), shear adds 0.1 %
    assert droop == pytest.approx(beam, rel=0.02)


def test_the_error_of_a_way_that_is_mostly_sag_is_said_of_inflation_too(
    inflated: Response,
) -> None:
    tips = np.array([p.tip_displacement for p in inflated.path])
    stroke = float(np.linalg.norm(tips - tips[0], axis=1).max())
    sagged = [
        replace(p, tip_displacement=(0.0, 0.0, -9 * stroke + stroke * (k > 0)))
        for k, p in enumerate(inflated.path)
    ]
    (note,) = sag_notes(sagged, 0.02)
    assert "up to 18 % of what inflation does" in note
    assert sag_notes([replace(p, tip_displacement=(0.0, 0.0, 1e-3 * k)) for k, p in
                      enumerate(inflated.path)], 0.02) == []  # fmt: skip
    assert sag_notes(sagged, None) == []


def test_response_holds_what_the_page_needs(inflated: Response) -> None:
    assert inflated.outcome is Outcome.CONVERGED
    assert [p.pressure for p in inflated.path] == pytest.approx([0, 1.5e3, 3e3, 4.5e3, 6e3])
    assert inflated.error_estimate is not None
    assert inflated.error_estimate < 0.1
    k = len(inflated.path)
    line, surface = inflated.centreline, inflated.surface
    assert line is not None
    assert surface is not None
    assert line.positions.shape == (k, len(line.stations), 3)
    eye = np.swapaxes(line.frames, -1, -2) @ line.frames
    assert eye == pytest.approx(np.broadcast_to(np.eye(3), eye.shape), abs=1e-12)
    assert line.frames[:, 0] == pytest.approx(np.broadcast_to(np.eye(3), (k, 3, 3)), abs=1e-12)
    assert surface.displacement.shape == (k, len(surface.vertices), 3)
    assert surface.stretch.min() >= 1.0
    for point, where in zip(inflated.path, line.positions[:, -1], strict=True):
        assert point.tip == pytest.approx(tuple(where))
    inflated.to_document()


def test_more_pressure_bends_further_down(inflated: Response) -> None:
    angles = [p.bending_angle for p in inflated.path]
    turns = [p.tip_rotation or 0.0 for p in inflated.path]
    curvatures = [p.curvature or 0.0 for p in inflated.path]
    for series in (angles, turns, curvatures):
        assert series == sorted(series)
    # without twist the mean curvature is the tip's turn over the length
    assert curvatures[-1] == pytest.approx(turns[-1] / SMALL.length, rel=1e-6)
    assert inflated.path[-1].torsion == pytest.approx(0.0, abs=1e-9)


def test_surface_is_closed_and_points_out_of_the_rubber(inflated: Response) -> None:
    surface = inflated.surface
    assert surface is not None
    edges = np.concatenate([surface.triangles[:, [a, b]] for a, b in ((0, 1), (1, 2), (2, 0))])
    forward = {tuple(e) for e in edges.tolist()}
    assert len(forward) == len(edges)
    assert all((b, a) in forward for a, b in forward)
    corners = surface.vertices.astype(float)[surface.triangles]
    volume = np.einsum("ti,ti->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    cavity = inflated.path[0].cavity_volume
    assert cavity is not None
    solid = SMALL.length * 20e-3 * SMALL.height
    assert 0.5 * solid < volume < solid


def test_cancelled_job_keeps_the_part_it_found() -> None:
    seen: list[Progress] = []

    def stop() -> bool:
        return any(p.pressure is not None and p.pressure > 2e3 for p in seen)

    found = solve(SMALL, Scene(pressure_to=6e3), progress=seen.append, cancelled=stop)
    assert found.outcome is Outcome.CANCELLED
    assert found.advice is not None
    assert 2e3 < found.path[-1].pressure < 6e3
    assert found.surface is not None
    fractions = [p.fraction for p in seen]
    assert fractions == sorted(fractions)


def test_a_finer_mesh_tells_every_iteration() -> None:
    """On large meshes one takes seconds."""
    seen: list[Progress] = []
    solve(SMALL, Scene(pressure_to=4e3, steps=2), accuracy=0.1, progress=seen.append)
    told = [p.message for p in seen if p.message.startswith("finer mesh")]
    assert any(message.endswith("unknowns, iteration 2") for message in told)
    fractions = [p.fraction for p in seen]
    assert fractions == sorted(fractions)


def test_spent_time_budget_is_an_outcome() -> None:
    found = solve(SMALL, Scene(pressure_to=6e3), time_budget=0.0)
    assert found.outcome is Outcome.BUDGET_SPENT
    (rest,) = found.path  # the body as it was cast
    assert rest.tip_displacement == (0.0, 0.0, 0.0)
    assert "under 0 % of that" in (found.advice or "")
    found.to_document()


def test_the_part_of_its_weight_that_a_body_carries_is_shown() -> None:
    """In a centrifuge at 1000 g, beyond what it can carry."""
    found = solve(SMALL, Scene(1e3, gravity=(0.0, 0.0, -9810.0)), mesh="coarse")
    assert found.outcome is Outcome.STALLED
    (loaded,) = found.path
    assert loaded.pressure == 0.0
    assert loaded.tip_displacement[2] < -1e-3
    assert "before any inflation" in (found.advice or "")


def test_a_sheet_far_too_floppy_for_its_weight_hangs_down() -> None:
    """rho g L^3 / (E h^2) = 160: put on in shares of a thousandth at first."""
    sheet = preset("slab-rectangle-low").design.changed(
        chamber_count=4, length=100, width=20, bottom_thickness=0.5, chamber_height=0.3,
        roof_thickness=0.4, bottom_material="ecoflex-00-30",
    )  # fmt: skip
    found = solve(sheet, Scene(0.0), mesh="coarse")
    assert found.outcome is Outcome.CONVERGED
    assert 80 < math.degrees(found.path[0].bending_angle) < 90


def test_limit_pressure_is_the_answer_when_more_is_asked_for() -> None:
    design = SMALL.changed(roof_thickness=1.5, top_material="ecoflex-00-30-neo-hooke")
    found = solve(design, Scene(pressure_to=40e3), accuracy=0.2)
    assert found.outcome is Outcome.LIMIT_POINT
    assert found.advice is not None
    assert f"{found.path[-1].pressure / 1e3:.3g} kPa" in found.advice
    volumes = [p.cavity_volume or 0.0 for p in found.path]
    assert volumes == sorted(volumes)


def test_walls_overlapping_without_contact_are_reported_with_depth_and_pressure() -> None:
    design = preset("oblique-90").design.changed(
        chamber_count=2, length=26, channel_width=0, half_gap=0.15
    )
    scene = Scene(pressure_to=20e3, gravity=None, self_contact="off")
    found = solve(design, scene, accuracy=0.5)
    note = [n for n in found.notes if "overlap" in n]
    assert len(note) == 1
    assert " mm (at 20 kPa)" in note[0]
    scene = Scene(pressure_to=5e3, gravity=None, self_contact="off")
    apart = solve(design.changed(half_gap=1.5), scene, accuracy=0.5)
    assert not [n for n in apart.notes if "overlap" in n]


def test_accuracy_out_of_range_is_refused() -> None:
    with pytest.raises(QuestionError):
        solve(SMALL, Scene(pressure_to=1e3), accuracy=0.0)
