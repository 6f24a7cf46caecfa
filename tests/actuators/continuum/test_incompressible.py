"""Nearly and exactly incompressible rubber: one limit, and no more iterations on the way to it."""

import math
from dataclasses import replace

import numpy as np
import pytest

from actuators.materials import INCOMPRESSIBLE, LinearElastic, Material, material
from actuators.mechanics.cell.cache import cell_response
from actuators.mechanics.continuum.newton import Equilibrium, Target, solve_equilibrium
from actuators.mechanics.continuum.path import PathFollower
from actuators.mechanics.continuum.surface_fields import StrainRecovery
from actuators.mechanics.continuum.system import ContinuumSystem, State, clamped
from actuators.mechanics.direct_solver import open_solver
from actuators.meshing import mesh_body
from benchmarks.mini_pneu_net import GRAVITY, MATERIALS, mini_pneu_net
from tests.actuators.continuum.boxes import LAWS, block, rubber, skewed

RATIOS = (1e2, 1e3, 1e4, 1e9, math.inf)


def follow(ratio: float) -> tuple[np.ndarray, int, ContinuumSystem, State]:
    """Tip displacement, iterations, system and last state of the mini pneu-net at 8 kPa."""
    mesh = mesh_body(mini_pneu_net().half())
    rubbers = [replace(m, bulk_to_shear=ratio) for m in MATERIALS]
    system = ContinuumSystem(mesh, rubbers, free=clamped(mesh), gravity=GRAVITY)
    path = PathFollower(system, open_solver(system.indptr, system.indices)).follow(8e3, None)
    last = path.points[-1]
    assert last.pressure == 8e3
    tip = last.state.displacement[mesh.underside_line[-1]]
    return tip, sum(e.iterations for e in path.points), system, last.state


def test_answers_converge_to_the_incompressible_one_at_a_flat_count_of_iterations() -> None:
    found = [follow(ratio) for ratio in RATIOS]
    limit = found[-1][0]
    away = [float(np.linalg.norm(tip - limit) / np.linalg.norm(limit)) for tip, *_ in found]
    # proportional to mu/kappa, until the tolerance of 1e-6 of the body's size hides it
    assert 10 * away[1] == pytest.approx(away[0], rel=0.2)
    assert 10 * away[2] == pytest.approx(away[1], rel=0.2)
    assert max(away[3:]) < 3e-5
    assert away[1] < 2e-3  # kappa = 1000 mu, as records have it
    counts = [iterations for _, iterations, *_ in found]
    assert max(counts) - min(counts) <= 2


def test_incompressible_elements_keep_their_volume() -> None:
    *_, system, state = follow(math.inf)
    nothing = system.balance(state, 8e3)
    volume = np.ptp(system.mesh.nodes, axis=0).prod() / len(system.mesh.elements)
    assert np.abs(nothing.inner).max() < 1e-7 * volume
    stretch, stress = StrainRecovery(system).at_points(state)
    assert stretch.max() > 1.2
    assert np.isfinite(stress).all()


@pytest.mark.parametrize("name", LAWS)
def test_every_law_converges_incompressible(name: str) -> None:
    mesh = mesh_body(block(skewed))
    law = LAWS[name]
    tips: list[np.ndarray] = []
    for ratio in (1e4, math.inf):
        rubbers = [replace(rubber(law), bulk_to_shear=ratio)]
        system = ContinuumSystem(mesh, rubbers, free=clamped(mesh))
        solver = open_solver(system.indptr, system.indices)
        target = Target(0.2 * law.initial_shear_modulus)
        found = solve_equilibrium(system, solver, system.rest(), target, tolerance=1e-9)
        assert isinstance(found, Equilibrium)
        assert found.iterations <= 6
        tips.append(found.state.displacement)
    scale = np.abs(tips[1]).max()
    assert scale > 1e-4 * 12e-3
    assert np.abs(tips[1] - tips[0]).max() < 1e-3 * scale


def test_a_design_asks_for_it_by_the_end_of_the_key() -> None:
    plain, exact = material("ecoflex-00-30"), material("ecoflex-00-30" + INCOMPRESSIBLE)
    assert exact.key == "ecoflex-00-30@incompressible"
    assert (exact.law, exact.density) == (plain.law, plain.density)
    assert exact.bulk_modulus == math.inf
    assert exact.youngs_modulus == pytest.approx(3 * plain.shear_modulus, rel=1e-15)
    assert "incompressible" in exact.name


def test_poissons_ratio_of_one_half_is_incompressible() -> None:
    law = LinearElastic(3e5, 0.5)
    record = Material("a", "a", law, 1.0, "test", bulk_to_shear=law.bulk_to_shear)
    assert record.bulk_modulus == math.inf
    assert record.youngs_modulus == pytest.approx(3e5, rel=1e-15)


def test_the_periodic_cell_takes_it_too() -> None:
    from actuators.design import preset
    from actuators.geometry import build_cell

    design = preset("oblique-60").design
    exact = design.changed(
        bottom_material=design.to_document()["bottom_material"] + INCOMPRESSIBLE,
        top_material=design.to_document()["top_material"] + INCOMPRESSIBLE,
    )
    a, b = (cell_response(build_cell(d, 0)) for d in (design, exact))
    assert b.free == pytest.approx(a.free, rel=0.02, abs=1e-3 * np.abs(a.free).max())
    assert not np.array_equal(a.free, b.free)
