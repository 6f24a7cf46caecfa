"""Mooney-Rivlin with two or five constants: a polynomial in x = I1 - 3 and y = I2 - 3,
W = C10 x + C01 y + C20 x^2 + C11 x y + C02 y^2.
"""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from actuators.materials.law import HyperelasticLaw


@dataclass(frozen=True)
class MooneyRivlin(HyperelasticLaw):
    """Constants [Pa]; the last three are 0 in the form with two. mu = 2 (C10 + C01).

    A fit may have a negative constant: B's has C10 < 0. Only the sum must be positive.
    """

    model: ClassVar[str] = "mooney-rivlin"
    code: ClassVar[int] = 2

    c10: float
    c01: float
    c20: float = 0.0
    c11: float = 0.0
    c02: float = 0.0

    @property
    def coefficients(self) -> tuple[float, ...]:
        return (self.c10, self.c01, self.c20, self.c11, self.c02)

    @property
    def initial_shear_modulus(self) -> float:
        return 2 * (self.c10 + self.c01)

    def energy(self, stretches: np.ndarray) -> np.ndarray:
        x, y = _invariants(stretches)
        return (
            x * (self.c10 + self.c20 * x + self.c11 * y) + y * (self.c01 + self.c02 * y)
        )  # fmt: skip

    def slopes(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """dW/dx and dW/dy."""
        return (
            self.c10 + 2 * self.c20 * x + self.c11 * y,
            self.c01 + self.c11 * x + 2 * self.c02 * y,
        )

    def nominal_uniaxial_stress(self, stretch: np.ndarray) -> np.ndarray:
        x, y = stretch**2 + 2 / stretch - 3, 2 * stretch + stretch**-2.0 - 3
        first, second = self.slopes(x, y)
        return 2 * (stretch - stretch**-2.0) * (first + second / stretch)

    def logarithmic_slope(self, log: np.ndarray) -> np.ndarray:
        first, second = self.slopes(*_invariants(np.exp(log)))
        return 2 * (first[..., None] * np.exp(2 * log) - second[..., None] * np.exp(-2 * log))

    def logarithmic_hessian(self, stretches: np.ndarray) -> np.ndarray:
        square, inverse = stretches**2, stretches**-2.0
        x, y = _invariants(stretches)
        first, second = self.slopes(x, y)
        a, b = 2 * square, -2 * inverse  # dx/dlog l, dy/dlog l
        diagonal = 4 * (first[..., None] * square + second[..., None] * inverse)
        cross = a[..., :, None] * b[..., None, :]
        return (
            diagonal[..., None] * np.eye(3)
            + 2 * self.c20 * a[..., :, None] * a[..., None, :]
            + 2 * self.c02 * b[..., :, None] * b[..., None, :]
            + self.c11 * (cross + np.swapaxes(cross, -1, -2))
        )

    def to_document(self) -> dict[str, Any]:
        document: dict[str, Any] = {
            "model": self.model, "C10_kPa": self.c10 * 1e-3, "C01_kPa": self.c01 * 1e-3,
        }  # fmt: skip
        if (self.c20, self.c11, self.c02) != (0.0, 0.0, 0.0):
            document |= {
                "C20_kPa": self.c20 * 1e-3, "C11_kPa": self.c11 * 1e-3, "C02_kPa": self.c02 * 1e-3,
            }  # fmt: skip
        return document


def _invariants(stretches: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """I1 - 3 and I2 - 3 of isochoric stretches (..., 3)."""
    return (stretches**2).sum(axis=-1) - 3, (stretches**-2.0).sum(axis=-1) - 3
