"""A record of the catalogue with one property changed: ``KEY@nu=0.4999``, ``KEY@bulk=1e6``,
``KEY@stiffness=1e-3``, ``KEY@incompressible``, in any order one after the other.

What a hard case, or a designer who asks "what if it were stiffer", needs without a record of its
own. The key says it all, so that equal keys are equal materials on every machine.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import cast

from actuators.errors import DesignError
from actuators.materials.law import HyperelasticLaw
from actuators.materials.linear import LinearElastic
from actuators.materials.material import Material
from actuators.materials.mooney_rivlin import MooneyRivlin
from actuators.materials.neo_hooke import NeoHooke
from actuators.materials.ogden import Ogden
from actuators.materials.yeoh import Yeoh

LEAST_NU = 0.45
"""Softer in volume than this no rubber is, and the elements are not made for it."""
STIFFNESS_RANGE = (1e-9, 1e9)


def varied(record: Material, changes: str, *, field: str) -> Material:
    """``record`` with the ``changes`` that stand after its key, such as ``nu=0.4999@stiffness=2``.
    Raises :class:`DesignError` about ``field`` for a change that is none."""
    for change in changes.split("@"):
        name, equals, text = change.partition("=")
        if name == "incompressible" and not equals:
            record = record.incompressible
        elif name in _CHANGES:
            key = f"{record.key}@{change}"
            record = replace(_CHANGES[name](record, _number(name, text, field)), key=key)
        else:
            raise _refused(field, f"@{change}", "is no change of a material", _MEND)
    return record


def _number(name: str, text: str, field: str) -> float:
    low, high = _LIMITS[name]
    mend = f"Give a number from {low:g} to {high:g}."
    try:
        value = float(text)
    except ValueError as error:
        raise _refused(field, f"@{name}={text}", "holds no number", mend) from error
    if not low <= value <= high:
        raise _refused(field, f"@{name}={text}", "is out of its range", mend)
    return value


def _refused(field: str, given: str, why: str, mend: str) -> DesignError:
    return DesignError(f"{field} has {given}, which {why}. {mend}", field=field, value=given,
                       mend=mend)  # fmt: skip


def _with_nu(record: Material, nu: float) -> Material:
    """kappa / mu = 2 (1 + nu) / (3 (1 - 2 nu)), mu as it is."""
    ratio = math.inf if nu == 0.5 else 2 * (1 + nu) / (3 * (1 - 2 * nu))
    return replace(record, bulk_to_shear=ratio, name=f"{record.name}, nu = {nu:.9g}")


def _with_bulk(record: Material, ratio: float) -> Material:
    return replace(record, bulk_to_shear=ratio, name=f"{record.name}, kappa = {ratio:g} mu")


def _stiffened(record: Material, factor: float) -> Material:
    name = f"{record.name}, {factor:g} times as stiff"
    return replace(record, law=stiffened(record.law, factor), name=name)


def stiffened(law: HyperelasticLaw, factor: float) -> HyperelasticLaw:
    """``law`` with every stress multiplied by ``factor``."""
    if isinstance(law, NeoHooke):
        return NeoHooke(factor * law.shear_modulus)
    if isinstance(law, LinearElastic):
        return LinearElastic(factor * law.youngs_modulus, law.poissons_ratio)
    if isinstance(law, Ogden):
        terms = tuple((factor * mu, alpha) for mu, alpha in law.terms)
        return Ogden(terms, law.convention)
    if isinstance(law, Yeoh | MooneyRivlin):
        scaled = (factor * number for number in law.coefficients)
        return cast("HyperelasticLaw", type(law)(*scaled))
    raise TypeError(f"no stiffening for {type(law).__name__}")


_CHANGES: Mapping[str, Callable[[Material, float], Material]] = {
    "nu": _with_nu, "bulk": _with_bulk, "stiffness": _stiffened,
}  # fmt: skip
_LIMITS: Mapping[str, tuple[float, float]] = {
    "nu": (LEAST_NU, 0.5), "bulk": (10.0, 1e12), "stiffness": STIFFNESS_RANGE,
}  # fmt: skip
_MEND = "Use @incompressible, @nu=0.4999, @bulk=1e4 (kappa/mu) or @stiffness=10 (all stresses)."
