"""Large bending: the elastica under a dead tip load, a thick block bent to a ring (Rivlin)."""

import numpy as np
import pytest

from benchmarks.verification.beams import (
    Flexure,
    bent_cantilever,
    bent_to_circle,
    elastica_tip,
)

# reference/fe_benchmarks.csv: P L^2/EI -> v/L, u/L
ELASTICA = {
    1.0: (0.30172, 0.05643), 2.0: (0.49346, 0.16064), 5.0: (0.71379, 0.38763),
    10.0: (0.81061, 0.55500),
}  # fmt: skip


def test_elastica_has_the_numbers_in_print() -> None:
    for load, tip in ELASTICA.items():
        assert elastica_tip(load) == pytest.approx(tip, abs=6e-6)


def test_slender_cantilever_is_the_elastica_but_for_its_thickness_squared() -> None:
    exact = np.array([elastica_tip(load) for load in ELASTICA])
    thick, thin = (
        np.array(bent_cantilever(list(ELASTICA), slenderness, (80, 1))) / exact - 1
        for slenderness in (50.0, 100.0)
    )
    assert np.abs(thin).max() < 5e-4
    # what is left is the beam's own: shear and finite strain, (h/L)^2
    assert thick[:, 0] / thin[:, 0] == pytest.approx(4.0, rel=0.1)


def test_block_bent_to_a_full_ring_needs_rivlins_moment() -> None:
    exact = Flexure(2 * np.pi, 8.0)
    found = [bent_to_circle(8.0, parts) for parts in ((6, 1), (12, 2), (24, 4))]
    moment, inner = found[-1]
    assert moment == pytest.approx(exact.moment, rel=1e-4)
    assert inner == pytest.approx(exact.inner, rel=1e-4)
    error = np.abs(np.array([m for m, _ in found]) / exact.moment - 1)
    assert np.log2(error[:-1] / error[1:]).min() > 3.3


def test_slender_flexure_is_a_beam_in_plane_strain() -> None:
    slender = Flexure(1e-3, 1.0)
    assert slender.moment == pytest.approx(slender.rate / 3, rel=1e-5)  # EI = mu h^3 / 3
