"""Quantities at the border: numbers with units, or a refusal that says so."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from actuators.errors import InputError
from actuators.quantities import (
    UNITS,
    Dimension,
    about,
    kilopascals,
    parse_number,
    parse_quantity,
    percent,
)


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("30kPa", "pressure", 30e3), ("2bar", "pressure", 2e5), (" 2 bar ", "pressure", 2e5),
        ("1.5e2 mbar", "pressure", 1.5e4), ("1psi", "pressure", 6894.757293168361),
        ("0.5MPa", "pressure", 5e5), ("4mm", "length", 4e-3), (".4cm", "length", 4e-3),
        ("-4mm", "length", -4e-3), ("1in", "length", 25.4e-3), ("45deg", "angle", math.pi / 4),
        ("45°", "angle", math.pi / 4), ("1rad", "angle", 1.0), ("2%", "fraction", 0.02),
    ],
)  # fmt: skip
def test_a_quantity_is_read_into_si(text: str, dimension: Dimension, value: float) -> None:
    assert parse_quantity(text, dimension, field="x") == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize("text", ["30", "3e1", "-0.5", "1."])
def test_a_bare_number_is_an_error_that_says_so(text: str) -> None:
    with pytest.raises(InputError, match="number without a unit") as caught:
        parse_quantity(text, "pressure", field="pressure")
    assert caught.value.field == "pressure"
    assert caught.value.value == text
    assert f"{text}kPa" in caught.value.mend


@pytest.mark.parametrize(
    "text", ["", "kPa", "abc", "1,5kPa", "30kPa 2", "nan kPa", "infkPa", "--4mm"]
)
def test_what_is_no_quantity_is_refused(text: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_quantity(text, "pressure", field="pressure")
    assert caught.value.mend


def test_units_are_told_apart_by_case_and_the_near_one_is_named() -> None:
    with pytest.raises(InputError, match="Did you mean kPa"):
        parse_quantity("30kpa", "pressure", field="pressure")
    with pytest.raises(InputError, match="mm"):
        parse_quantity("30kPa", "length", field="length")


def test_a_number_too_large_for_the_machine_is_refused() -> None:
    with pytest.raises(InputError, match="too large"):
        parse_quantity("1e999kPa", "pressure", field="pressure")


@given(
    st.floats(-1e12, 1e12, allow_subnormal=False),
    st.sampled_from([(d, u) for d, units in UNITS.items() for u in units]),
)
def test_every_unit_scales_as_its_table_says(value: float, unit: tuple[Dimension, str]) -> None:
    dimension, name = unit
    read = parse_quantity(f"{value!r} {name}", dimension, field="x")
    assert read == pytest.approx(value * UNITS[dimension][name], rel=1e-15)


def test_counts_take_no_unit() -> None:
    assert parse_number("6", field="chamber_count") == 6
    with pytest.raises(InputError, match="without a unit"):
        parse_number("6mm", field="chamber_count")


@pytest.mark.parametrize(
    ("share", "text"),
    [
        (0.0, "0 %"), (5e-5, "below 0.01 %"), (0.00123, "0.12 %"), (0.0199, "2 %"),
        (0.996, "100 %"), (1.284, "130 %"), (10.0, "1000 %"), (340.0, "over 1000 %"),
        (math.inf, "over 1000 %"),
    ],
)  # fmt: skip
def test_errors_have_two_digits_and_end_at_what_can_be_pictured(share: float, text: str) -> None:
    assert percent(share) == text
    assert about(share) == (f"about {text}" if text[0].isdigit() else text)


@pytest.mark.parametrize(
    ("pressure", "text"),
    [(13_714.6, "13.71"), (0.0, "0"), (-98e3, "-98"), (2.5e6, "2500"), (10e6, "10 000")],
)
def test_pressures_are_read_without_powers_of_ten(pressure: float, text: str) -> None:
    assert kilopascals(pressure) == text
