"""Thick spheres, thin balloons and the thick cylinder against their closed forms."""

import numpy as np
import pytest

from benchmarks.verification.inflation import (
    cylinder_pressure,
    found_extreme,
    inflated_cylinder,
    inflated_sphere,
    sphere_limit,
    sphere_pressure,
)

# reference/fe_benchmarks.csv: inner stretch -> p/mu, A/B = 0.5
SPHERE = {1.1: 0.287155, 1.25: 0.551869, 1.5: 0.755433, 2.0: 0.806927}
CYLINDER = {1.1: 0.131562, 1.25: 0.275712, 1.5: 0.428228, 2.0: 0.574054, 3.0: 0.660417}


def test_closed_forms_give_the_numbers_in_print() -> None:
    assert {s: sphere_pressure(s, 0.5, 0.5) for s in SPHERE} == pytest.approx(SPHERE, abs=1e-6)
    assert {s: cylinder_pressure(s, 0.5, 1.0) for s in CYLINDER} == pytest.approx(
        CYLINDER, abs=1e-6
    )
    assert sphere_limit(0.5, 0.5) == pytest.approx((1.8281, 0.816424), abs=1e-4)
    assert sphere_limit(0.8, 0.5) == pytest.approx((1.4922, 0.275039), abs=1e-4)
    # a balloon without thickness: 7^(1/6); Mooney with c2/c1 = 0.1: 1.476 and 3.143
    thin = 1 - 1e-4
    assert sphere_limit(thin, 0.5)[0] == pytest.approx(7 ** (1 / 6), abs=1e-4)
    assert sphere_limit(thin, 1.0, 0.1, between=(1.1, 2.2))[0] == pytest.approx(1.476, abs=5e-4)
    assert sphere_limit(thin, 1.0, 0.1, between=(2.3, 4.5), minimum=True)[0] == pytest.approx(
        3.143, abs=5e-4
    )


def test_sphere_follows_its_closed_form_past_the_limit_point() -> None:
    found = dict(zip(SPHERE, inflated_sphere(0.5, 0.5, 0.0, list(SPHERE), (2, 2, 4)), strict=True))
    assert found == pytest.approx(SPHERE, rel=1e-4)


def test_sphere_converges_with_the_order_of_the_energy() -> None:
    errors = [
        abs(
            inflated_sphere(0.5, 0.5, 0.0, [1.1], (2, 2, n))[0] / sphere_pressure(1.1, 0.5, 0.5) - 1
        )
        for n in (1, 2, 4)
    ]
    # quadratic displacement: the pressure, conjugate to the volume, converges with order 4
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders.min() > 3.3


@pytest.mark.parametrize("ratio", [0.5, 0.8])
def test_sphere_has_its_limit_point_where_the_closed_form_has_it(ratio: float) -> None:
    stretch, pressure = sphere_limit(ratio, 0.5)
    assert found_extreme(ratio, 0.5, 0.0, stretch, (2, 2, 4)) == pytest.approx(
        (stretch, pressure), rel=1e-4
    )


def test_mooney_balloon_has_a_maximum_and_a_minimum() -> None:
    for minimum, between in ((False, (1.1, 2.2)), (True, (2.3, 4.5))):
        stretch, pressure = sphere_limit(0.98, 1.0, 0.1, between=between, minimum=minimum)
        found = found_extreme(0.98, 1.0, 0.1, stretch, (3, 3, 1), step=0.05)
        assert found == pytest.approx((stretch, pressure), rel=1e-3)


def test_cylinder_follows_its_closed_form_and_converges_with_order_4() -> None:
    coarse, fine = (inflated_cylinder(0.5, 1.0, list(CYLINDER), n) for n in ((4, 2), (8, 4)))
    exact = np.array(list(CYLINDER.values()))
    assert fine == pytest.approx(exact, rel=1e-4)
    closed = np.array([cylinder_pressure(s, 0.5, 1.0) for s in CYLINDER])
    order = np.log2(np.abs(coarse / closed - 1) / np.abs(fine / closed - 1))
    assert order.min() > 3.3
