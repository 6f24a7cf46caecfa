"""Loads on the outside: their tangent, what balances what, a beam's elastica."""

import numpy as np
import pytest

from actuators.materials import NeoHooke
from actuators.mechanics.continuum.newton import Equilibrium, Target, solve_equilibrium
from actuators.mechanics.continuum.outer_loads import (
    OuterLoads,
    end_faces,
    outer_loads,
    underside_faces,
)
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.system import ContinuumSystem, State, clamped
from actuators.mechanics.direct_solver import open_solver
from actuators.mechanics.scene import Scene
from actuators.meshing import mesh_body
from tests.actuators.continuum.boxes import LAWS, block, rubber, skewed_mesh


def test_all_round_pressure_lets_go_of_the_body_but_for_the_inside() -> None:
    """Outside pressure on every outer face is the cavity's underpressure, and a pressure in the
    rubber that no shape feels."""
    mesh = mesh_body(block(), uniform=(2, 2, 2))
    pressure = 6e3
    outside = OuterLoads(np.zeros_like(mesh.nodes), mesh.outer_faces.nodes, pressure)
    # held by six displacements, so that the surface is closed and all of it is free to shrink
    free = np.ones((len(mesh.nodes), 3), dtype=bool)
    at = [int(np.linalg.norm(mesh.nodes - x, axis=1).argmin()) for x in np.array(
        [[0, -6, 0], [12, -6, 0], [0, 6, 0]]) * 1e-3]  # fmt: skip
    free[at[0]], free[at[1], 1:], free[at[2], 2] = False, False, False
    shapes: list[np.ndarray] = []
    for loads, inner in ((outside, 0.0), (None, -pressure)):
        system = ContinuumSystem(mesh, [rubber(LAWS["yeoh"])], free=free, outer_loads=loads)
        solver = open_solver(system.indptr, system.indices)
        found = solve_equilibrium(system, solver, system.rest(), Target(inner), tolerance=1e-10)
        assert isinstance(found, Equilibrium)
        shapes.append(found.state.displacement)
    size = np.abs(shapes[1]).max()
    assert size > 0.1e-3
    # they differ by the rubber's volumetric shrinkage alone, pressure over bulk modulus
    kappa = rubber(LAWS["yeoh"]).bulk_modulus
    assert np.abs(shapes[0] - shapes[1]).max() < 2 * pressure / kappa * 12e-3


def test_pressure_tangent_is_the_symmetric_part_of_the_derivative() -> None:
    mesh = skewed_mesh()
    faces = underside_faces(mesh)
    assert len(faces) == 9
    loads = OuterLoads(np.zeros_like(mesh.nodes), faces, 700.0)
    rng = np.random.default_rng(3)
    positions = mesh.nodes + 5e-4 * rng.standard_normal(mesh.nodes.shape)

    def derivative(step: np.ndarray) -> np.ndarray:
        ends = []
        for sign in (1, -1):
            residual = np.zeros_like(mesh.nodes)
            loads.add_residual(positions + sign * 1e-3 * step, 0.5, residual)
            ends.append(residual)
        return (ends[0] - ends[1]) / 2e-3

    one, other = rng.standard_normal((2, *mesh.nodes.shape)) * 1e-2
    matrices = loads.tangent(positions, 0.5)
    product = np.einsum("fai,faibj,fbj->", one[faces], matrices, other[faces])
    symmetric = (np.vdot(one, derivative(other)) + np.vdot(other, derivative(one))) / 2
    assert product == pytest.approx(symmetric, rel=1e-6)


def test_system_holds_that_tangent_among_its_own() -> None:
    mesh = skewed_mesh()
    loads = OuterLoads(np.zeros_like(mesh.nodes), underside_faces(mesh), 700.0)
    materials = [rubber(LAWS["neo-hooke"])]
    with_load = ContinuumSystem(mesh, materials, free=clamped(mesh), outer_loads=loads)
    without = ContinuumSystem(mesh, materials, free=clamped(mesh))
    rng = np.random.default_rng(1)
    state = State(1e-4 * rng.standard_normal(mesh.nodes.shape), np.zeros((len(mesh.elements), 4)))
    for system in (with_load, without):
        system.linearise(state, 0.0)
    change = np.zeros((with_load.unknowns, with_load.unknowns))
    row = np.repeat(np.arange(with_load.unknowns), np.diff(with_load.indptr))
    change[row, with_load.indices] = with_load.values - without.values
    step = rng.standard_normal(with_load.unknowns)
    full = change + np.triu(change, 1).T
    moved = np.zeros(mesh.nodes.shape)
    moved[with_load.dof >= 0] = step[with_load.dof[with_load.dof >= 0]]
    faces = underside_faces(mesh)
    matrices = loads.tangent(mesh.nodes + state.displacement, 1.0)
    work = np.einsum("fai,faibj,fbj->", moved[faces], matrices, moved[faces])
    assert step @ full @ step == pytest.approx(work, rel=1e-9)


def test_tip_force_is_spread_with_the_end_faces_area() -> None:
    mesh = mesh_body(block(lambda x: x * np.array([1.0, 2.0, 1.0])), uniform=(1, 2, 1))
    loads = outer_loads(mesh, Scene(0.0, tip_force=(1.0, 2.0, -3.0)))
    assert loads is not None
    assert loads.force.sum(axis=0) == pytest.approx([1.0, 2.0, -3.0])
    held = np.unique(end_faces(mesh))
    assert set(np.flatnonzero(loads.force.any(axis=1))) <= set(held)
    # no moment about the face's own middle
    middle = np.array([12e-3, 0.0, 6e-3])
    moment = np.cross(mesh.nodes - middle, loads.force).sum(axis=0)
    assert moment == pytest.approx(np.zeros(3), abs=1e-12)


@pytest.mark.parametrize("half", [False, True])
def test_outside_pressure_lifts_with_pressure_times_area(half: bool) -> None:
    from actuators.design import preset
    from actuators.geometry import build_body

    design = preset("slab-rectangle-low").design
    body = build_body(design)
    mesh = mesh_body(body.half() if half else body)
    loads = outer_loads(mesh, Scene(0.0, outside_pressure=100.0))
    assert loads is not None
    residual = np.zeros_like(mesh.nodes)
    loads.add_residual(mesh.nodes, 1.0, residual)
    width = np.ptp(mesh.nodes[:, 1])
    lift = 100.0 * design.length * width
    assert -residual.sum(axis=0) == pytest.approx([0.0, 0.0, lift], abs=1e-9 * lift)


# reference/fe_benchmarks.csv: elastica of a cantilever, P L2 / (E I) -> deflection v/L
ELASTICA = {1: 0.30172, 5: 0.71379, 10: 0.81061}


def test_beam_under_a_dead_end_force_follows_the_elastica() -> None:
    from actuators.geometry import Body, Region

    length, side, mu = 100e-3, 2e-3, 1e6
    line = np.array([-side, 0.0, side]) / 2
    body = Body(
        (np.array([0.0, length]), line, np.array([0.0, side])), np.zeros((1, 2, 1), np.int8),
        (Region("a", "test"),), lambda x: np.array(x, float), True,
    ).half()  # fmt: skip
    mesh = mesh_body(body, uniform=(20, 1, 1))
    stiffness = 3 * mu * side**4 / 12
    for load, down in ELASTICA.items():
        force = load * stiffness / length**2
        loads = outer_loads(mesh, Scene(0.0, gravity=None, tip_force=(0.0, 0.0, -force)))
        system = ContinuumSystem(
            mesh, [rubber(NeoHooke(mu))], free=clamped(mesh), outer_loads=loads
        )
        path = PathFollower(system, open_solver(system.indptr, system.indices)).follow(0.0, None)
        middle = np.argmin(np.linalg.norm(mesh.nodes - [length, 0.0, side / 2], axis=1))
        tip = path.points[0].state.displacement[middle]
        assert -tip[2] / length == pytest.approx(down, rel=0.005)


def test_loads_reach_the_answer_and_a_sideways_force_the_whole_body() -> None:
    from actuators.design import preset
    from actuators.mechanics.continuum import solve

    design = preset("slab-rectangle-low").design.changed(chamber_count=2, length=36, width=20)
    plain, lifted, aside = (
        solve(design, Scene(1e3, steps=1, gravity=None, **more), accuracy=1.0).path
        for more in ({}, {"outside_pressure": 50.0}, {"tip_force": (0.0, 2e-2, 0.0)})
    )
    assert lifted[0].tip_displacement[2] > 0.1e-3
    assert lifted[1].tip_displacement[2] > plain[1].tip_displacement[2]
    assert plain[0].tip_displacement == pytest.approx((0.0, 0.0, 0.0), abs=1e-9)
    assert plain[1].tip_displacement[1] == pytest.approx(0.0, abs=1e-12)
    assert aside[0].tip_displacement[1] > 0.1e-3
    # the whole body bends down as its half does, but for its sideways sag
    assert aside[1].tip_displacement[2] == pytest.approx(plain[1].tip_displacement[2], rel=0.02)
