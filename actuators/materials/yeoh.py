"""Yeoh: W = C10 (I1 - 3) + C20 (I1 - 3)^2 + C30 (I1 - 3)^3."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from actuators.materials.law import HyperelasticLaw


@dataclass(frozen=True)
class Yeoh(HyperelasticLaw):
    """``c10``, ``c20``, ``c30`` [Pa]; mu = 2 C10."""

    model: ClassVar[str] = "yeoh"
    code: ClassVar[int] = 0

    c10: float
    c20: float
    c30: float = 0.0

    @property
    def coefficients(self) -> tuple[float, ...]:
        return (self.c10, self.c20, self.c30)

    @property
    def initial_shear_modulus(self) -> float:
        return 2 * self.c10

    def energy(self, stretches: np.ndarray) -> np.ndarray:
        x = (stretches**2).sum(axis=-1) - 3
        return x * (self.c10 + x * (self.c20 + x * self.c30))

    def nominal_uniaxial_stress(self, stretch: np.ndarray) -> np.ndarray:
        x = stretch**2 + 2 / stretch - 3
        slope = self.c10 + x * (2 * self.c20 + x * 3 * self.c30)
        return 2 * slope * (stretch - stretch**-2.0)

    def logarithmic_slope(self, log: np.ndarray) -> np.ndarray:
        square = np.exp(2 * log)
        x = square.sum(axis=-1, keepdims=True) - 3
        return 2 * (self.c10 + x * (2 * self.c20 + x * 3 * self.c30)) * square

    def logarithmic_hessian(self, stretches: np.ndarray) -> np.ndarray:
        square = stretches**2
        x = square.sum(axis=-1)[..., None, None] - 3
        slope = self.c10 + x * (2 * self.c20 + x * 3 * self.c30)
        bend = 2 * self.c20 + 6 * self.c30 * x
        return 4 * (
            slope * square[..., None] * np.eye(3)
            + bend * square[..., :, None] * square[..., None, :]
        )

    def to_document(self) -> dict[str, Any]:
        return {
            "model": self.model,
            "C10_kPa": self.c10 * 1e-3,
            "C20_kPa": self.c20 * 1e-3,
            "C30_kPa": self.c30 * 1e-3,
        }
