"""Drucker's stability: the tangent it looks at, and ranges that can be computed otherwise."""

import math

import numpy as np
import pytest

from actuators.materials import CATALOGUE, MooneyRivlin, NeoHooke, Yeoh
from actuators.materials.stability import least_stiffness, stable_range

PLANE = np.array([[1.0, -1.0, 0.0], [1.0, 0.0, -1.0]])


@pytest.mark.parametrize("key", CATALOGUE)
def test_tangent_is_the_second_derivative_of_the_energy(key: str) -> None:
    law = CATALOGUE[key].law
    h = 2e-3
    for log in np.log([[1.0, 1.0, 1.0], [1.8, 0.9, 1 / 1.62], [0.6, 1.2, 1 / 0.72]]):
        hessian = law.logarithmic_hessian(np.exp(log))
        for a in PLANE:
            # fourth-order differences: h^4 leaves 1e-7 where the energy stiffens most
            e = [float(law.energy(np.exp(log + k * h * a))) for k in (-2, -1, 0, 1, 2)]
            slope = (-e[0] + 16 * e[1] - 30 * e[2] + 16 * e[3] - e[4]) / (12 * h * h)
            assert a @ hessian @ a == pytest.approx(slope, rel=1e-5)


def test_at_rest_the_least_stiffness_is_twice_the_shear_modulus() -> None:
    for record in CATALOGUE.values():
        assert least_stiffness(record.law, np.ones(3)) == pytest.approx(2 * record.shear_modulus)


def test_neo_hooke_is_stable_everywhere() -> None:
    found = stable_range(NeoHooke(1e5))
    assert (found.uniaxial, found.equibiaxial, found.planar) == (math.inf,) * 3


def test_uniaxial_limit_of_a_softening_yeoh_law_is_where_its_true_stress_has_its_maximum() -> None:
    law = Yeoh(1e4, 0.0, -10.0)
    limit = stable_range(law).uniaxial
    stretch = np.linspace(1.01, 8.0, 20001)
    true_stress = stretch * law.nominal_uniaxial_stress(stretch)
    assert limit == pytest.approx(stretch[np.argmax(true_stress)], rel=1e-3)


def test_negative_second_constant_makes_compression_unstable() -> None:
    # d2W/dlog2 across the axis: 4 (C10 l^2 + C01 l^-2) turns negative at l^4 = -C01/C10 ...
    law = MooneyRivlin(2e5, -0.5e5)
    tangent = law.logarithmic_hessian(np.ones(3) * 0.70)
    assert tangent[0, 0] < 0
    # ... which uniaxial tension reaches at l^(-1/2)
    assert stable_range(law).uniaxial == pytest.approx(2.0, rel=1e-6)


def test_published_mooney_rivlin_set_is_stable_over_a_short_range_only() -> None:
    found = CATALOGUE["ninjaflex-mooney-rivlin-5"].stable_range
    assert found.smallest[0] == "equibiaxial"
    assert found.smallest[1] == pytest.approx(1.476, abs=1e-3)
    # beyond it two equal stretches part: energy falls along (1, -1, 0), before it rises
    law, h = CATALOGUE["ninjaflex-mooney-rivlin-5"].law, 1e-3
    for stretch, sign in ((1.46, 1), (1.49, -1)):
        log = np.log(stretch) * np.array([1.0, 1.0, -2.0])
        apart = h * np.array([1.0, -1.0, 0.0])
        parted = law.energy(np.exp(log + apart)) - law.energy(np.exp(log))
        assert np.sign(float(parted)) == sign
