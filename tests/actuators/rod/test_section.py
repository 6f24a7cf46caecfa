"""Solid end sections: composite beam theory and Saint-Venant torsion."""

import numpy as np
import pytest

from actuators.mechanics.rod.section import layered_section, torsion_constant


@pytest.mark.parametrize(("aspect", "coefficient"), [(1.0, 0.1406), (2.0, 0.229), (10.0, 0.312)])
def test_torsion_constant_is_timoshenkos_table(aspect: float, coefficient: float) -> None:
    """Timoshenko and Goodier, Theory of Elasticity, article 109: k1 = J/(a b^3), three digits."""
    assert torsion_constant(aspect, 1.0) / aspect == pytest.approx(coefficient, rel=2e-3)
    assert torsion_constant(1.0, aspect) == torsion_constant(aspect, 1.0)


def test_two_layers_of_one_rubber_are_one_layer() -> None:
    e, g = np.array([3e5, 3e5]), np.array([1e5, 1e5])
    two = layered_section(0.02, np.array([0.003, 0.005]), e, g)
    one = layered_section(0.02, np.array([0.008]), e[:1], g[:1])
    np.testing.assert_allclose(two, one, rtol=1e-12)
    # about its own middle the section has E b h^3 / 12
    about_middle = one[2, 2] - one[0, 2] ** 2 / one[0, 0]
    assert about_middle == pytest.approx(3e5 * 0.02 * 0.008**3 / 12, rel=1e-12)
