"""The materials of the source papers, and other published sets for the same rubbers.

Published constants of one silicone differ by a factor of two and more; every set keeps its own key
and source, so that the spread can be seen.
"""

import difflib
from collections.abc import Mapping

from actuators.errors import DesignError
from actuators.materials.law import HyperelasticLaw
from actuators.materials.linear import LinearElastic
from actuators.materials.material import Material
from actuators.materials.mooney_rivlin import MooneyRivlin
from actuators.materials.neo_hooke import NeoHooke
from actuators.materials.ogden import Ogden
from actuators.materials.variants import varied
from actuators.materials.yeoh import Yeoh

kPa, MPa = 1e3, 1e6

_RAW = (
    "least-squares fit of the raw uniaxial curve (Soft Robotics Materials Database) over 0 to "
    "300 % engineering strain"
)
_SOROTOKI = "Sorotoki toolkit, material preset"
_THESIS = "printed pneu-net thesis (P)"
_BELLOWS = "bellows paper (B), Table 4, W = sum mu/alpha (...)"
# S, Table 2 for Ecoflex and Elastosil; the others from the makers' data sheets
_ECOFLEX, _ELASTOSIL, _DRAGON_10, _DRAGON, _NINJAFLEX = 1070.0, 1130.0, 1070.0, 1080.0, 1190.0

_ELASTOSIL_LINEAR = LinearElastic(483.5 * kPa, 0.499)
_ECOFLEX_30_LINEAR = LinearElastic(125 * kPa, 0.499)
_NINJAFLEX_LINEAR = LinearElastic(12 * MPa, 0.48)


def _yeoh(c10: float, c20: float, c30: float) -> Yeoh:
    """Yeoh law from constants in MPa."""
    return Yeoh(c10 * MPa, c20 * MPa, c30 * MPa)


def _record(
    key: str, name: str, law: HyperelasticLaw, density: float, source: str, note: str = "",
    tested_to_stretch: float | None = None,
) -> Material:  # fmt: skip
    if isinstance(law, LinearElastic):
        return Material(key, name, law, density, source, note, law.bulk_to_shear)
    return Material(key, name, law, density, source, note, tested_to_stretch=tested_to_stretch)


_RECORDS = (
    _record(
        "elastosil-m4601", "Elastosil M4601", _ELASTOSIL_LINEAR, _ELASTOSIL,
        "G, Table 1: E = 483.5 kPa, nu = 0.499",
        "Computed as neo-Hooke with the same shear modulus; no strain stiffening.",
    ),
    _record(
        "ecoflex-00-30", "Ecoflex 00-30", _yeoh(0.00783, 0.0001034, -0.00000081), _ECOFLEX,
        f"{_RAW}; RMS 0.46 % of the maximum",
        "Default because it follows a measured curve over the stretches that an actuator reaches; "
        "neo-Hooke with the same initial modulus is 23 % too soft at stretch 4.",
        tested_to_stretch=4.0,
    ),
    _record(
        "ecoflex-00-50", "Ecoflex 00-50", _yeoh(0.010668, 0.0002605, -0.0000032), _ECOFLEX,
        f"{_RAW}; RMS 0.40 % of the maximum", tested_to_stretch=4.0,
    ),
    _record(
        "elastosil-m4601-sorotoki", "Elastosil M4601 (Sorotoki)", _yeoh(0.11, 0.02, 0.0),
        _ELASTOSIL, _SOROTOKI,
    ),
    _record(
        "ecoflex-00-30-neo-hooke", "Ecoflex 00-30 (neo-Hooke)", NeoHooke(15.66 * kPa), _ECOFLEX,
        "initial shear modulus of the raw curve's Yeoh fit",
        "For comparison: without strain stiffening, limit pressures come out too low.",
    ),
    _record(
        "ecoflex-00-30-gpnsa", "Ecoflex 00-30 (G)", _ECOFLEX_30_LINEAR, _ECOFLEX,
        "G, text: E = 125 kPa, nu = 0.499",
        "Computed as neo-Hooke with the same shear modulus; 2.7 times as stiff as the raw curve.",
    ),
    _record(
        "ecoflex-00-30-sorotoki", "Ecoflex 00-30 (Sorotoki)", _yeoh(0.017, -0.0002, 0.000023),
        _ECOFLEX, _SOROTOKI,
    ),
    _record(
        "ecoflex-00-30-sorotoki-earlier", "Ecoflex 00-30 (Sorotoki, earlier)",
        _yeoh(0.0084, 0.0001, 0.0), _ECOFLEX, "Sorotoki toolkit, earlier material preset",
    ),
    _record(
        "ecoflex-00-30-secondary", "Ecoflex 00-30 (secondary script)",
        _yeoh(0.0127, 0.000423, -0.00000146), _ECOFLEX, "secondary script, origin not stated",
    ),
    _record(
        "ecoflex-00-50-sorotoki", "Ecoflex 00-50 (Sorotoki)", _yeoh(0.0145, 0.0001, 0.0),
        _ECOFLEX, _SOROTOKI,
    ),
    _record(
        "dragon-skin-10", "Dragon Skin 10 Medium", _yeoh(0.02429, 0.002251, -0.0000543),
        _DRAGON_10, f"{_RAW}; RMS 0.77 % of the maximum", tested_to_stretch=4.0,
    ),
    _record(
        "dragon-skin-10-sorotoki", "Dragon Skin 10 (Sorotoki)", _yeoh(0.036, 0.00025, 0.000023),
        _DRAGON_10, _SOROTOKI,
    ),
    _record(
        "dragon-skin-20", "Dragon Skin 20", _yeoh(0.0704, 0.005223, -0.0001127), _DRAGON,
        f"{_RAW}; RMS 0.63 % of the maximum", tested_to_stretch=4.0,
    ),
    _record(
        "dragon-skin-30", "Dragon Skin 30", _yeoh(0.10055, 0.006387, -0.0001492), _DRAGON,
        f"{_RAW}; RMS 0.61 % of the maximum", tested_to_stretch=4.0,
    ),
    _record(
        "dragon-skin-30-sorotoki", "Dragon Skin 30 (Sorotoki)", _yeoh(0.1536, 0.0016, 0.0),
        _DRAGON, _SOROTOKI,
    ),
    _record(
        "ninjaflex-linear", "NinjaFlex (linear)", _NINJAFLEX_LINEAR, _NINJAFLEX,
        f"{_THESIS}, Table 2: E = 12 MPa, nu = 0.48",
        "Computed as neo-Hooke with the same shear modulus.",
    ),
    _record(
        "ninjaflex-yeoh", "NinjaFlex (Yeoh)", _yeoh(1.653, 0.0324, 0.000468), _NINJAFLEX,
        f"{_THESIS}, Table 3",
    ),
    _record(
        "ninjaflex-mooney-rivlin-5", "NinjaFlex (Mooney-Rivlin 5)",
        MooneyRivlin(-0.233 * MPa, 2.562 * MPa, 0.116 * MPa, -0.561 * MPa, 0.900 * MPa), _NINJAFLEX,
        "bellows paper (B), Table 3: polynomial in I1 - 3 and I2 - 3",
        "C10 is negative; the initial modulus 6 (C10 + C01) = 14.0 MPa is not.",
    ),
    _record(
        "ninjaflex-ogden-002", "NinjaFlex (Ogden 002)",
        Ogden(((1.13 * MPa, 3.11), (-13.17 * MPa, -0.6)), "work-conjugate"), _NINJAFLEX, _BELLOWS,
        "Read in the convention that gives a positive modulus (17.1 MPa).",
    ),
    _record(
        "ninjaflex-ogden-005", "NinjaFlex (Ogden 005)",
        Ogden(((0.13 * MPa, 3.05), (-1214 * MPa, -0.0054)), "work-conjugate"), _NINJAFLEX, _BELLOWS,
        "Read in the convention that gives a positive modulus (10.4 MPa).",
    ),
)  # fmt: skip

CATALOGUE: Mapping[str, Material] = {record.key: record for record in _RECORDS}


def material(key: str, *, field: str = "material") -> Material:
    """The record called ``key``; with :data:`.INCOMPRESSIBLE` after the key, the exactly
    incompressible one; with other changes after it, see :mod:`variants`. Raises
    :class:`DesignError` about ``field``, naming near ones."""
    plain, changed, changes = key.partition("@")
    if plain in CATALOGUE:
        record = CATALOGUE[plain]
        return varied(record, changes, field=field) if changed else record
    near = ", ".join(difflib.get_close_matches(key, CATALOGUE, n=3, cutoff=0.4) or CATALOGUE)
    raise DesignError(
        f"{field} is {key!r}, which is not in the catalogue of materials. Try {near}.",
        field=field, value=key, mend=f"Try {near}.",
    )  # fmt: skip
