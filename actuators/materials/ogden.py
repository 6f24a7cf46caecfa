"""Ogden, in either of the two conventions in use; the convention is part of the record.

``classical``: W = sum 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3), mu_0 = sum mu;
``work-conjugate``: W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3), mu_0 = sum mu alpha / 2

Powers are taken as expm1(alpha log l): sets such as mu = -1214 MPa, alpha = -0.0054 (B, Table 4)
cancel to nothing otherwise.
"""

from dataclasses import dataclass
from typing import Any, ClassVar, Literal

import numpy as np

from actuators.materials.law import HyperelasticLaw

Convention = Literal["classical", "work-conjugate"]


@dataclass(frozen=True)
class Ogden(HyperelasticLaw):
    """``terms``: (mu [Pa], alpha) pairs, to be read in ``convention``."""

    model: ClassVar[str] = "ogden"
    code: ClassVar[int] = 1

    terms: tuple[tuple[float, float], ...]
    convention: Convention

    @property
    def work_terms(self) -> tuple[tuple[float, float], ...]:
        """The same law as (m, alpha) pairs of W = sum m/alpha (sum l^alpha - 3)."""
        if self.convention == "work-conjugate":
            return self.terms
        return tuple((2 * mu / alpha, alpha) for mu, alpha in self.terms)

    @property
    def coefficients(self) -> tuple[float, ...]:
        """m1, alpha1, m2, alpha2, ... of :attr:`work_terms`."""
        return tuple(number for term in self.work_terms for number in term)

    @property
    def initial_shear_modulus(self) -> float:
        return sum(m * alpha for m, alpha in self.work_terms) / 2

    def energy(self, stretches: np.ndarray) -> np.ndarray:
        log = np.log(stretches)
        total = np.zeros(log.shape[:-1])
        for m, alpha in self.work_terms:
            total = total + m / alpha * np.expm1(alpha * log).sum(axis=-1)
        return total

    def nominal_uniaxial_stress(self, stretch: np.ndarray) -> np.ndarray:
        log = np.log(stretch)
        total = np.zeros_like(log)
        for m, alpha in self.work_terms:
            # l^alpha - l^(-alpha/2), without subtracting two numbers near 1
            total = total + m * (np.expm1(alpha * log) - np.expm1(-alpha / 2 * log))
        return total / stretch

    def logarithmic_slope(self, log: np.ndarray) -> np.ndarray:
        # m l^alpha less m, which is common to the three
        return sum((m * np.expm1(a * log) for m, a in self.work_terms), np.zeros_like(log))

    def logarithmic_hessian(self, stretches: np.ndarray) -> np.ndarray:
        total = np.zeros_like(stretches, dtype=float)
        for m, alpha in self.work_terms:
            total = total + m * alpha * stretches**alpha
        return total[..., None] * np.eye(3)

    def to_document(self) -> dict[str, Any]:
        document: dict[str, Any] = {"model": self.model, "convention": self.convention}
        for i, (mu, alpha) in enumerate(self.terms, 1):
            document[f"mu{i}_kPa"] = mu * 1e-3
            document[f"alpha{i}"] = alpha
        return document
