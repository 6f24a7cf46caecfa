"""Linear elasticity, computed as the neo-Hookean solid with the same initial constants.

Hooke's law is not frame-indifferent at large rotation; the neo-Hookean law of equal mu is, and has
the same small-strain answer.
"""

import math
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from actuators.materials.law import HyperelasticLaw
from actuators.materials.neo_hooke import NeoHooke


@dataclass(frozen=True)
class LinearElastic(HyperelasticLaw):
    """``youngs_modulus`` E [Pa] and Poisson's ratio nu: mu = E / (2 (1 + nu))."""

    model: ClassVar[str] = "linear"
    code: ClassVar[int] = NeoHooke.code

    youngs_modulus: float
    poissons_ratio: float

    @property
    def as_neo_hooke(self) -> NeoHooke:
        """The law that is computed."""
        return NeoHooke(self.initial_shear_modulus)

    @property
    def bulk_to_shear(self) -> float:
        """kappa / mu = 2 (1 + nu) / (3 (1 - 2 nu)); infinite for nu = 1/2."""
        nu = self.poissons_ratio
        if nu == 0.5:
            return math.inf
        return 2 * (1 + nu) / (3 * (1 - 2 * nu))

    @property
    def coefficients(self) -> tuple[float, ...]:
        return self.as_neo_hooke.coefficients

    @property
    def initial_shear_modulus(self) -> float:
        return self.youngs_modulus / (2 * (1 + self.poissons_ratio))

    def energy(self, stretches: np.ndarray) -> np.ndarray:
        return self.as_neo_hooke.energy(stretches)

    def nominal_uniaxial_stress(self, stretch: np.ndarray) -> np.ndarray:
        return self.as_neo_hooke.nominal_uniaxial_stress(stretch)

    def logarithmic_slope(self, log: np.ndarray) -> np.ndarray:
        return self.as_neo_hooke.logarithmic_slope(log)

    def logarithmic_hessian(self, stretches: np.ndarray) -> np.ndarray:
        return self.as_neo_hooke.logarithmic_hessian(stretches)

    def to_document(self) -> dict[str, Any]:
        return {
            "model": self.model,
            "youngs_modulus_kPa": self.youngs_modulus * 1e-3,
            "poissons_ratio": self.poissons_ratio,
            "computed_as": "neo-hooke with the same shear modulus",
        }
