"""Neo-Hooke: W = mu/2 (I1 - 3) = C10 (I1 - 3)."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from actuators.materials.law import HyperelasticLaw


@dataclass(frozen=True)
class NeoHooke(HyperelasticLaw):
    """``shear_modulus`` mu = 2 C10 [Pa]."""

    model: ClassVar[str] = "neo-hooke"
    code: ClassVar[int] = 0

    shear_modulus: float

    @property
    def coefficients(self) -> tuple[float, ...]:
        """(C10, C20 = 0, C30 = 0): the kernel reads it as a Yeoh law."""
        return (self.shear_modulus / 2, 0.0, 0.0)

    @property
    def initial_shear_modulus(self) -> float:
        return self.shear_modulus

    def energy(self, stretches: np.ndarray) -> np.ndarray:
        return self.shear_modulus / 2 * ((stretches**2).sum(axis=-1) - 3)

    def nominal_uniaxial_stress(self, stretch: np.ndarray) -> np.ndarray:
        return self.shear_modulus * (stretch - stretch**-2.0)

    def logarithmic_slope(self, log: np.ndarray) -> np.ndarray:
        return self.shear_modulus * np.exp(2 * log)

    def logarithmic_hessian(self, stretches: np.ndarray) -> np.ndarray:
        return 2 * self.shear_modulus * (stretches**2)[..., None] * np.eye(3)

    def to_document(self) -> dict[str, Any]:
        return {"model": self.model, "C10_kPa": self.shear_modulus / 2 * 1e-3}
