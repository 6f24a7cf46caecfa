"""A material: a law, a density, a bulk stiffness, and where its numbers come from."""

from dataclasses import dataclass

from actuators.materials.law import HyperelasticLaw
from actuators.materials.stability import StableRange, stable_range


@dataclass(frozen=True)
class Material:
    """Record of the catalogue.

    ``bulk_to_shear`` is kappa/mu of the nearly incompressible solid. ``tested_to_stretch`` is the
    largest uniaxial stretch the source covers, None where it does not say.
    """

    key: str
    name: str
    law: HyperelasticLaw
    density: float
    source: str
    note: str = ""
    bulk_to_shear: float = 1000.0
    tested_to_stretch: float | None = None

    @property
    def stable_range(self) -> StableRange:
        """Stretches up to which the law is stable after Drucker."""
        return stable_range(self.law)

    @property
    def shear_modulus(self) -> float:
        """Initial mu [Pa]."""
        return self.law.initial_shear_modulus

    @property
    def bulk_modulus(self) -> float:
        """kappa [Pa]."""
        return self.bulk_to_shear * self.law.initial_shear_modulus

    @property
    def youngs_modulus(self) -> float:
        """Initial E [Pa] of the nearly incompressible solid, 9 k mu / (3 k + mu)."""
        k, mu = self.bulk_modulus, self.shear_modulus
        return 9 * k * mu / (3 * k + mu)
