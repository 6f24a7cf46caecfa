"""Records with one property changed, named by their key."""

import math

import numpy as np
import pytest

from actuators.errors import DesignError
from actuators.materials import CATALOGUE, material

STRETCH = np.array([0.5, 0.9, 1.3, 2.5])


@pytest.mark.parametrize("key", sorted(CATALOGUE))
def test_stiffness_multiplies_every_stress_and_the_bulk_modulus(key: str) -> None:
    record, changed = material(key), material(f"{key}@stiffness=250")
    np.testing.assert_allclose(
        changed.law.nominal_uniaxial_stress(STRETCH),
        250 * record.law.nominal_uniaxial_stress(STRETCH), rtol=1e-12,
    )  # fmt: skip
    assert changed.bulk_modulus == pytest.approx(250 * record.bulk_modulus, rel=1e-12)


@pytest.mark.parametrize(("nu", "ratio"), [(0.49, 149 / 3), (0.4999999, 4999999.667)])
def test_poissons_ratio_becomes_a_bulk_modulus(nu: float, ratio: float) -> None:
    # 2 (1 + nu) / (3 (1 - 2 nu)); 1 - 2 nu of the last one keeps 9 digits
    assert material(f"ecoflex-00-30@nu={nu}").bulk_to_shear == pytest.approx(ratio, rel=1e-6)


def test_changes_add_up_and_the_key_says_them_all() -> None:
    both = material("dragon-skin-10@stiffness=2@nu=0.5")
    assert both.key == "dragon-skin-10@stiffness=2@nu=0.5"
    assert both.shear_modulus == 2 * material("dragon-skin-10").shear_modulus
    assert math.isinf(both.bulk_modulus)
    assert math.isinf(material("dragon-skin-10@stiffness=2@incompressible").bulk_modulus)


@pytest.mark.parametrize("change", ["nu=0.6", "nu=nan", "stiffness=0", "stiffness=much", "softer",
                                    "bulk=1", ""])  # fmt: skip
def test_a_change_that_is_none_is_refused_with_a_mend(change: str) -> None:
    with pytest.raises(DesignError) as caught:
        material(f"dragon-skin-10@{change}", field="top_material")
    assert caught.value.field == "top_material"
    assert change in str(caught.value)
    assert caught.value.mend
