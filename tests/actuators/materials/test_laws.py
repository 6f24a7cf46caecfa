"""Laws and catalogue: conventions, moduli, derivatives, and numbers that must not cancel."""

import numpy as np
import pytest

from actuators.errors import DesignError
from actuators.materials import (
    CATALOGUE,
    HyperelasticLaw,
    LinearElastic,
    MooneyRivlin,
    NeoHooke,
    Ogden,
    Yeoh,
    material,
)

LAWS: dict[str, HyperelasticLaw] = {key: record.law for key, record in CATALOGUE.items()}


@pytest.mark.parametrize("key", LAWS)
def test_uniaxial_stress_is_the_slope_of_the_energy(key: str) -> None:
    law = LAWS[key]
    stretch = np.array([0.7, 1.2, 1.8, 2.6])

    def energy(x: np.ndarray) -> np.ndarray:
        return law.energy(np.stack([x, x**-0.5, x**-0.5], axis=-1))

    h = 1e-4  # central differences: error h^2 W'''/6, relative 1e-7 here
    slope = (energy(stretch + h) - energy(stretch - h)) / (2 * h)
    assert law.nominal_uniaxial_stress(stretch) == pytest.approx(slope, rel=1e-5)


@pytest.mark.parametrize("key", LAWS)
def test_logarithmic_slope_gives_the_uniaxial_stress(key: str) -> None:
    stretch = np.array([0.7, 1.2, 1.8])
    slope = LAWS[key].logarithmic_slope(np.log(stretch)[:, None] * [1.0, -0.5, -0.5])
    # nothing pulls across: the common pressure is the slope there
    nominal = (slope[:, 0] - slope[:, 1]) / stretch
    assert nominal == pytest.approx(LAWS[key].nominal_uniaxial_stress(stretch), rel=1e-9)


@pytest.mark.parametrize("key", LAWS)
def test_initial_slope_is_three_times_the_shear_modulus(key: str) -> None:
    law = LAWS[key]
    slope = law.nominal_uniaxial_stress(np.array([1 + 1e-6])) / 1e-6
    assert slope[0] == pytest.approx(3 * law.initial_shear_modulus, rel=1e-4)


def test_conventions_of_ogden_are_one_law_after_translation() -> None:
    classical = Ogden(((2e5, 1.7), (-3e4, -2.0)), "classical")
    translated = Ogden(classical.work_terms, "work-conjugate")
    stretch = np.linspace(0.6, 3.0, 9)
    assert translated.initial_shear_modulus == pytest.approx(classical.initial_shear_modulus)
    assert translated.nominal_uniaxial_stress(stretch) == pytest.approx(
        classical.nominal_uniaxial_stress(stretch)
    )


def test_ogden_with_alpha_2_is_neo_hooke() -> None:
    ogden, neo_hooke = Ogden(((5e4, 2.0),), "classical"), NeoHooke(5e4)
    stretch = np.linspace(0.5, 4.0, 8)
    assert ogden.nominal_uniaxial_stress(stretch) == pytest.approx(
        neo_hooke.nominal_uniaxial_stress(stretch), rel=1e-12
    )


def test_mooney_rivlin_without_c01_is_yeoh() -> None:
    polynomial, yeoh = MooneyRivlin(2e4, 0.0, 3e3), Yeoh(2e4, 3e3)
    stretch = np.linspace(0.5, 3.0, 6)
    assert polynomial.nominal_uniaxial_stress(stretch) == pytest.approx(
        yeoh.nominal_uniaxial_stress(stretch), rel=1e-12
    )


def test_second_constant_of_mooney_rivlin_shows_where_ogden_with_alpha_minus_2_does() -> None:
    polynomial = MooneyRivlin(2e4, 3e4)
    ogden = Ogden(((4e4, 2.0), (6e4, -2.0)), "classical")
    stretch = np.linspace(0.5, 3.0, 6)
    assert polynomial.nominal_uniaxial_stress(stretch) == pytest.approx(
        ogden.nominal_uniaxial_stress(stretch), rel=1e-12
    )
    assert polynomial.initial_shear_modulus == ogden.initial_shear_modulus


def test_mooney_rivlin_set_of_the_bellows_has_a_positive_modulus() -> None:
    record = CATALOGUE["ninjaflex-mooney-rivlin-5"]
    assert record.law.coefficients[0] < 0
    assert 3 * record.shear_modulus == pytest.approx(13.974e6, rel=1e-12)


def test_bellows_sets_have_the_moduli_that_fix_their_convention() -> None:
    # the papers themselves imply 17.1 and 10.4 MPa in the work-conjugate convention
    assert 3 * CATALOGUE["ninjaflex-ogden-002"].shear_modulus == pytest.approx(17.1e6, rel=5e-3)
    assert 3 * CATALOGUE["ninjaflex-ogden-005"].shear_modulus == pytest.approx(10.4e6, rel=5e-3)
    assert Ogden(((-1214e6, -0.0054),), "classical").initial_shear_modulus < 0


def test_tiny_exponent_does_not_cancel() -> None:
    # alpha -> 0 with m alpha fixed: m (l^alpha - l^(-alpha/2)) -> 1.5 m alpha log l
    law = Ogden(((-1214e6, -0.0054),), "work-conjugate")
    stretch = 1 + 1e-7
    expected = 1.5 * 1214e6 * 0.0054 * np.log(stretch) / stretch
    # next term of the series: relative alpha log(l) / 4
    assert law.nominal_uniaxial_stress(np.array([stretch]))[0] == pytest.approx(expected, rel=1e-8)


def test_linear_record_keeps_its_modulus() -> None:
    elastosil = material("elastosil-m4601")
    assert isinstance(elastosil.law, LinearElastic)
    assert elastosil.youngs_modulus == pytest.approx(483.5e3, rel=1e-12)


def test_default_ecoflex_stiffens_where_neo_hooke_does_not() -> None:
    default, plain = material("ecoflex-00-30"), material("ecoflex-00-30-neo-hooke")
    assert isinstance(default.law, Yeoh)
    assert default.shear_modulus == plain.shear_modulus
    four = np.array([4.0])
    ratio = default.law.nominal_uniaxial_stress(four) / plain.law.nominal_uniaxial_stress(four)
    assert ratio[0] == pytest.approx(1.30, abs=0.01)


def test_unknown_material_names_the_field_and_near_ones() -> None:
    with pytest.raises(DesignError) as caught:
        material("ecoflex-00-3", field="top_material")
    assert caught.value.field == "top_material"
    assert "ecoflex-00-30" in caught.value.mend


def test_every_record_says_where_it_comes_from() -> None:
    for key, record in CATALOGUE.items():
        assert record.key == key
        assert record.source
        assert 900 < record.density < 1300
