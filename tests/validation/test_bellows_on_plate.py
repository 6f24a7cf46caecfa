"""Round bellows pressing on a plate, against an independent code on the same curved mesh."""

import numpy as np
import pytest

from actuators.mechanics.continuum.contact import ContactLaw
from actuators.mechanics.continuum.contact.surface import law_pressure
from actuators.meshing import mesh_body
from benchmarks.peer_entry import ngsolve, ours
from benchmarks.peer_problems import PROBLEMS

PROBLEM, COARSEST = PROBLEMS["bellows"], PROBLEMS["bellows"].ladder[0]


@pytest.mark.slow
def test_tip_and_plate_force_are_those_of_ngsolve() -> None:
    pytest.importorskip(
        "ngsolve", reason="NGSolve IS MISSING: contact is NOT checked against another code"
    )
    mine, other = ours(PROBLEM, COARSEST), ngsolve(PROBLEM, COARSEST)
    assert mine.force is not None
    assert other.force is not None
    # both stop at corrections of 1e-5 of the body; the stiff plate makes 1e-4 of the force of that
    assert np.linalg.norm(mine.tip - other.tip) < 1e-5 * np.linalg.norm(mine.tip)
    assert mine.force == pytest.approx(other.force, rel=5e-4)


def test_ngsolve_energy_of_contact_has_our_pressure_as_its_slope() -> None:
    ngs = pytest.importorskip("ngsolve", reason="NGSolve IS MISSING: its contact is NOT checked")
    from netgen.geom2d import unit_square

    from benchmarks.ngsolve_engine import contact_energy

    law = ContactLaw(stiffness=3e9, onset=4e-6)
    gaps, small = np.linspace(-12e-6, 8e-6, 41), 1e-10
    gap = ngs.Parameter(0.0)
    square = ngs.Mesh(unit_square.GenerateMesh(maxh=1))
    energy, anywhere = contact_energy(gap, law), square(0.4, 0.4)

    def at(value: float) -> float:
        gap.Set(value)
        return float(energy(anywhere))

    slope = np.array([(at(g + small) - at(g - small)) / (2 * small) for g in gaps.tolist()])
    # differences over 1e-10 m of energies of 0.1 J/m2 keep six digits of the largest pressure
    assert -slope == pytest.approx(law_pressure(gaps, law), abs=1e-6 * 36e3)


def test_ngsolve_mesh_has_the_volume_of_the_round_body() -> None:
    ngs = pytest.importorskip("ngsolve", reason="NGSolve IS MISSING: its mesh is NOT checked")
    from benchmarks.ngsolve_engine import NgsolveProblem

    mesh = mesh_body(PROBLEM.half(), layers=COARSEST)
    other = NgsolveProblem(mesh, PROBLEM.materials, (0.0, 0.0, -9.81))
    theirs = float(ngs.Integrate(ngs.CF(1.0) * ngs.dx(bonus_intorder=4), other.mesh))
    assert theirs == pytest.approx(_volume(mesh.nodes[mesh.elements]), rel=1e-6)


def _volume(nodes: np.ndarray) -> float:
    """Volume [m3] of quadratic hexahedra (m, 27, 3), by 4 x 4 x 4 Gauss points."""
    points, weights = np.polynomial.legendre.leggauss(4)
    line = np.stack([points * (points - 1) / 2, 1 - points**2, points * (points + 1) / 2])
    slope = np.stack([points - 0.5, -2 * points, points + 0.5])
    patch = nodes.reshape(-1, 3, 3, 3, 3)  # third, second, first direction
    parts = [
        np.einsum("mkjix,ka,jb,ic->mabcx", patch, *(slope if d == e else line for d in range(3)))
        for e in (2, 1, 0)
    ]
    det = np.einsum("...x,...x->...", parts[0], np.cross(parts[1], parts[2]))
    return float(np.einsum("mabc,a,b,c->", det, weights, weights, weights))
