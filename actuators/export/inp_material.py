"""Materials as Abaqus and CalculiX write them, in MPa and tonne/mm3.

Both programs use W(isochoric) + sum 1/D_i (J - 1)^(2 i), so that D1 = 2 / kappa is our volumetric
law. Ogden there is sum 2 mu/alpha^2 (...): our ``classical`` convention.
"""

import math

from actuators.errors import QuestionError
from actuators.materials import (
    HyperelasticLaw,
    LinearElastic,
    Material,
    MooneyRivlin,
    NeoHooke,
    Ogden,
    Yeoh,
)

MPA = 1e-6
TONNE_PER_MM3 = 1e-12
STAND_IN_BULK_TO_SHEAR = 1000.0
"""kappa/mu written for an exactly incompressible material: CalculiX has no hybrid elements."""


def material_card(material: Material, name: str) -> list[str]:
    """Lines of ``*MATERIAL``; raises :class:`QuestionError` for a law without a card."""
    bulk = material.bulk_modulus
    lines = [f"** {material.name}; {material.source}"]
    if math.isinf(bulk):
        bulk = STAND_IN_BULK_TO_SHEAR * material.shear_modulus
        lines.append(
            f"** exactly incompressible; written with kappa/mu = {STAND_IN_BULK_TO_SHEAR:g}"
        )
    keyword, numbers = _law(material.law, 2 / (bulk * MPA))
    rows = [numbers[k : k + 8] for k in range(0, len(numbers), 8)]
    return [
        *lines,
        f"*MATERIAL, NAME={name}",
        f"*HYPERELASTIC, {keyword}",
        *(", ".join(f"{value:.9g}" for value in row) for row in rows),
        "*DENSITY",
        f"{material.density * TONNE_PER_MM3:.9g}",
    ]


def _law(law: HyperelasticLaw, d1: float) -> tuple[str, list[float]]:
    """Keyword parameters and constants [MPa, 1/MPa]."""
    if isinstance(law, NeoHooke | LinearElastic):
        return "NEO HOOKE", [law.initial_shear_modulus / 2 * MPA, d1]
    if isinstance(law, Yeoh):
        return "YEOH", [law.c10 * MPA, law.c20 * MPA, law.c30 * MPA, d1, 0.0, 0.0]
    if isinstance(law, MooneyRivlin):
        c10, c01, *second = (c * MPA for c in law.coefficients)
        if not any(second):
            return "MOONEY-RIVLIN", [c10, c01, d1]
        return "POLYNOMIAL, N=2", [c10, c01, *second, d1, 0.0]
    if isinstance(law, Ogden):
        pairs = [(m * alpha / 2 * MPA, alpha) for m, alpha in law.work_terms]
        constants = [number for pair in pairs for number in pair]
        return f"OGDEN, N={len(pairs)}", [*constants, d1, *[0.0] * (len(pairs) - 1)]
    raise QuestionError(
        f"what is inp, but the law {law.model} has no card in Abaqus's terms. "
        "Choose another material, or export vtu.",
        field="what", value="inp", mend="Choose another material, or export vtu.",
    )  # fmt: skip
