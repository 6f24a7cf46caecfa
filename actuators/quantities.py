"""Quantities as people write them at the border: a number with its unit, read into SI.

A bare number is refused, because 30 may be kPa, bar or mm; silence about units is how moulds get
cut in inches.
"""

import difflib
import math
import re
from collections.abc import Mapping
from typing import Literal

from actuators.errors import InputError

Dimension = Literal["length", "angle", "pressure", "fraction", "time"]

UNITS: Mapping[Dimension, Mapping[str, float]] = {
    "length": {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "um": 1e-6, "µm": 1e-6, "in": 0.0254},
    "angle": {"deg": math.pi / 180, "°": math.pi / 180, "rad": 1.0},
    "pressure": {
        "kPa": 1e3, "Pa": 1.0, "hPa": 1e2, "MPa": 1e6, "bar": 1e5, "mbar": 1e2,
        "psi": 6894.757293168361,
    },
    "fraction": {"%": 0.01},
    "time": {"s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0},
}  # fmt: skip

_NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*", re.DOTALL)


def parse_quantity(text: str, dimension: Dimension, *, field: str) -> float:
    """Value of ``text`` in SI (a fraction for percent). Raises :class:`InputError` about ``field``
    for a bare number, an unknown unit or no number at all."""
    known = UNITS[dimension]
    first = next(iter(known))
    match = _NUMBER.fullmatch(text)
    if match is None:
        raise InputError(
            f"{field} is {text!r}; it must be a number with a unit, such as 4{first}.",
            field=field, value=text, mend=f"Write for example 4{first}.",
        )  # fmt: skip
    number, unit = match.groups()
    if not unit:
        raise InputError(
            f"{field} is {text!r}, a number without a unit. Write {number}{first}, or another of "
            f"{', '.join(known)}.",
            field=field, value=text, mend=f"Write {number}{first}.",
        )  # fmt: skip
    if unit not in known:
        near = difflib.get_close_matches(unit.casefold(), [u.casefold() for u in known], n=1)
        hint = next((f" Did you mean {u}?" for u in known if near and u.casefold() == near[0]), "")
        raise InputError(
            f"{field} is {text!r}, whose unit {unit!r} is not one of {', '.join(known)}.{hint}",
            field=field, value=text, mend=f"Use one of {', '.join(known)}.",
        )  # fmt: skip
    value = float(number) * known[unit]
    if not math.isfinite(value):
        raise InputError(
            f"{field} is {text!r}, which is too large to compute with.",
            field=field, value=text, mend=f"Give {field} as a finite number.",
        )  # fmt: skip
    return value


def parse_number(text: str, *, field: str) -> float:
    """A number without dimension: a count or a ratio."""
    match = _NUMBER.fullmatch(text)
    if match is None or match.group(2):
        raise InputError(
            f"{field} is {text!r}; it must be a plain number without a unit.",
            field=field, value=text, mend=f"Give {field} as a plain number.",
        )  # fmt: skip
    return float(match.group(1))


def two_digits(value: float) -> str:
    """For what is not known better; no power of ten for what is some hundreds."""
    return f"{float(f'{value:.2g}'):g}"


def kilopascals(pressure: float, digits: int = 4) -> str:
    """A pressure [Pa] to read, in kPa: no power of ten, thousands apart ("10 000")."""
    value = float(f"{pressure / 1e3:.{digits}g}")
    return f"{value:,.10g}".replace(",", " ") if abs(value) >= 1e4 else f"{value:.10g}"


def percent(share: float) -> str:
    """A fraction in words: two digits, and no more than anybody can picture."""
    if not math.isfinite(share) or share > 10.0:
        return "over 1000 %"
    if share == 0.0:
        return "0 %"
    return "below 0.01 %" if share < 1e-4 else f"{two_digits(100 * share)} %"


def about(share: float) -> str:
    """As :func:`percent`, of what is an estimate: ``about 12 %``."""
    text = percent(share)
    return f"about {text}" if text[0].isdigit() else text
