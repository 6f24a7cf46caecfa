"""One periodic chamber: beam theory where it holds, long actuators, scaling, convergence."""

from typing import cast

import numpy as np
import pytest

from actuators.design import Design, ObliqueDesign, preset
from actuators.geometry import Body, Region, build_cell
from actuators.materials import material
from actuators.mechanics.cell.periodic import CellMesh, CellResponse, coarse_mesh, solve_cell
from actuators.mechanics.rod.section import layered_section
from tests.actuators.cell.chain import tip_turn_per_pressure


def answer(design: Design, mesh: CellMesh | None = None, index: int = 0) -> CellResponse:
    body = build_cell(design, index)
    materials = tuple(material(region.material) for region in body.regions)
    return solve_cell(body, materials, mesh or coarse_mesh(body))


def solid_bar(width: float, lower: float, upper: float) -> Body:
    """A bar of two layers without chambers, its lattice that of a cell."""
    x = np.array([0.0, 0.002, 0.006, 0.008])
    y = np.array([-width / 2, 0.0, width / 2])
    z = np.array([0.0, lower, lower + upper])
    fill = np.zeros((3, 2, 2), dtype=np.int8)
    fill[:, :, 1] = 1
    keys = ("elastosil-m4601", "ecoflex-00-30")
    regions = (Region("lower", keys[0]), Region("upper", keys[1]))
    return Body((x, y, z), fill, regions, lambda p: np.asarray(p, dtype=float), True, 0.008)


def test_a_solid_bar_is_a_beam() -> None:
    body = solid_bar(0.012, 0.004, 0.003)
    records = tuple(material(r.material) for r in body.regions)
    fine = ((1, 1), (4,), (3, 3))
    found = solve_cell(body, records, CellMesh(fine, fine))
    beam = layered_section(
        0.012, np.array([0.004, 0.003]), np.array([m.youngs_modulus for m in records]),
        np.array([m.shear_modulus for m in records]),
    )  # fmt: skip
    # bonded layers of one Poisson ratio bend as a composite beam; their different cross-bending
    # leaves a few thousandths. Torsion of the layered section has only a rough formula: left out.
    for i, j in ((0, 0), (0, 2), (2, 2), (3, 3)):
        assert found.stiffness[i, j] == pytest.approx(beam[i, j], rel=5e-3)
    assert np.all(found.free == 0)


def test_torsion_of_a_solid_bar_is_saint_venants() -> None:
    body = solid_bar(0.012, 0.004, 0.003)
    one = material("elastosil-m4601")
    fine = ((1, 1), (5,), (3, 3))
    found = solve_cell(body, (one, one), CellMesh(fine, ((1, 1), (1,), (1, 1))))
    section = layered_section(
        0.012, np.array([0.007]), np.array([one.youngs_modulus]), np.array([one.shear_modulus])
    )
    assert found.stiffness[1, 1] == pytest.approx(section[1, 1], rel=2e-3)


def test_a_long_slab_gains_exactly_the_cells_curvature_with_every_chamber() -> None:
    """Ten and fourteen chambers solved whole, clamped, without periodicity, on the cell's mesh:
    their difference leaves no end effects, only how far they have died out."""
    base = preset("slab-rectangle-low").design
    pitch = 7.2727272727

    def turn(n: int) -> float:
        length = 6 + 3 + n * pitch * 2 - pitch
        return tip_turn_per_pressure(base.changed(chamber_count=n, length=length))

    cell = answer(base.changed(chamber_count=10, length=9 + 19 * pitch))
    gained = (turn(14) - turn(10)) / 4 / cell.period
    assert gained == pytest.approx(cell.free[2], rel=1e-5)


def test_a_long_gapped_bar_gains_the_cells_curvature_with_every_chamber() -> None:
    base = preset("oblique-90").design.changed(channel_width=0)
    cell = answer(base)

    def turn(n: int) -> float:
        return tip_turn_per_pressure(base.changed(chamber_count=n, length=14 + 6 * n), 2)

    # 3 %, as the issue asks; the oracle takes one element along the arm where the cell takes two
    gained = (turn(14) - turn(10)) / 4 / cell.period
    assert gained == pytest.approx(cell.free[2], rel=0.03)
    assert turn(14) == pytest.approx(14 * cell.period * cell.free[2], rel=0.03)


def test_oblique_90_bends_as_the_published_dimensions_do_in_three_dimensions() -> None:
    """1.90 /m per kPa: 3D FE of another engine, 27 Q2/P1 elements a chamber. Separate chambers.
    That mesh is 1 to 3 % softer than a converged one, this one 1 %."""
    cell = answer(preset("oblique-90").design.changed(channel_width=0))
    assert cell.free[2] * 1e3 == pytest.approx(1.90, rel=0.04)


@pytest.mark.parametrize("name", ["oblique-90", "slab-rectangle-high"])
def test_at_ninety_degrees_pressure_neither_twists_nor_bends_sideways(name: str) -> None:
    cell = answer(preset(name).design)
    assert abs(cell.free[1]) < 1e-6 * cell.free[2]
    assert cell.free[3] == 0
    assert np.abs(cell.stiffness[1, [0, 2]]).max() < 1e-6 * cell.stiffness[1, 1]


@pytest.mark.parametrize("name", ["oblique-45", "slab-ellipse-high"])
def test_rod_stiffness_is_symmetric_and_positive(name: str) -> None:
    stiffness = answer(preset(name).design, index=1).stiffness
    scale = np.sqrt(np.outer(np.diag(stiffness), np.diag(stiffness)))
    np.testing.assert_allclose(stiffness / scale, stiffness.T / scale, atol=1e-9)
    assert np.linalg.eigvalsh(stiffness / scale).min() > 0


def test_a_body_twice_as_large_bends_half_as_much() -> None:
    small = cast(ObliqueDesign, preset("oblique-45").design)
    document = {
        key: value * 2 if key.endswith("_mm") else value
        for key, value in small.to_document().items()
    }
    large = answer(ObliqueDesign.from_document(document))
    one = answer(small)
    np.testing.assert_allclose(large.free[1:3], one.free[1:3] / 2, rtol=1e-8)
    assert large.free[0] == pytest.approx(one.free[0], rel=1e-8)
    assert large.cavity_compliance == pytest.approx(8 * one.cavity_compliance, rel=1e-8)


def test_pressure_opens_the_cavity_and_curls_towards_the_bottom_layer() -> None:
    for name in ("oblique-60", "slab-rectangle-low"):
        cell = answer(preset(name).design)
        assert cell.cavity_compliance > 0
        assert cell.free[2] > 0


def test_twist_grows_as_chambers_turn_away_from_ninety_degrees() -> None:
    twists = [
        answer(preset("oblique-90").design.changed(theta=t)).free[1] for t in (89.0, 80.0, 70.0)
    ]
    assert 0 < twists[0] < twists[1] < twists[2]


@pytest.mark.slow
@pytest.mark.parametrize("theta", [15, 30, 45, 60, 75, 90])
def test_coarse_mesh_is_within_2_percent_of_a_fine_one_oblique(theta: int) -> None:
    design = preset(f"oblique-{theta}").design
    fine = ((3, 2, 3, 2), (1, 3, 2), (1, 1, 1, 3, 2))
    coarse, reference = answer(design), answer(design, CellMesh(fine, fine))
    compare(coarse, reference, 0.025)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["slab-rectangle-low", "slab-ellipse-high", "slab-triangle-high"])
def test_coarse_mesh_is_within_2_percent_of_a_fine_one_slab(name: str) -> None:
    design = preset(name).design
    fine = ((3, 3), (2, 4, 2), (3, 3, 3))
    compare(answer(design), answer(design, CellMesh(fine, fine)), 0.02)


def compare(coarse: CellResponse, reference: CellResponse, tolerance: float) -> None:
    turning = np.hypot(reference.free[1], reference.free[2])
    assert np.abs(coarse.free[1:3] - reference.free[1:3]).max() < tolerance * turning
    # torsion of oblique blocks is the stiffness that converges slowest
    np.testing.assert_allclose(
        np.diag(coarse.stiffness), np.diag(reference.stiffness), rtol=tolerance
    )
