"""What every hyperelastic law offers."""

from abc import ABC, abstractmethod
from typing import Any, ClassVar

import numpy as np


class HyperelasticLaw(ABC):
    """Isochoric strain energy of an isotropic rubber; volume is governed by the material's bulk
    modulus, added by the solver.

    ``code`` selects the branch of the compiled element kernel, ``coefficients`` are its numbers.
    """

    model: ClassVar[str]
    code: ClassVar[int]

    @property
    @abstractmethod
    def coefficients(self) -> tuple[float, ...]:
        """Numbers the kernel reads, in SI."""

    @property
    @abstractmethod
    def initial_shear_modulus(self) -> float:
        """mu at zero strain [Pa]."""

    @abstractmethod
    def energy(self, stretches: np.ndarray) -> np.ndarray:
        """W [Pa] at isochoric principal stretches, shape (..., 3) -> (...)."""

    @abstractmethod
    def nominal_uniaxial_stress(self, stretch: np.ndarray) -> np.ndarray:
        """dW/dlambda [Pa] of the incompressible uniaxial test, same shape as ``stretch``."""

    @abstractmethod
    def logarithmic_slope(self, log: np.ndarray) -> np.ndarray:
        """dW / dlog(l_i) [Pa] of the incompressible form at logarithmic stretches (..., 3):
        principal Cauchy stresses but for a common pressure."""

    @abstractmethod
    def logarithmic_hessian(self, stretches: np.ndarray) -> np.ndarray:
        """d2W / dlog(l_i) dlog(l_j) [Pa] of the incompressible form, (..., 3) -> (..., 3, 3).

        Only its restriction to volume-preserving increments (sum of dlog l = 0) has a meaning.
        """

    @abstractmethod
    def to_document(self) -> dict[str, Any]:
        """Model and constants with units in their names, for display."""
