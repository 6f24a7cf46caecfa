"""A material: a law, a density, a bulk stiffness, and where its numbers come from."""

import math
from dataclasses import dataclass, replace

from actuators.materials.law import HyperelasticLaw
from actuators.materials.stability import StableRange, stable_range

INCOMPRESSIBLE = "@incompressible"
"""After a record's key, asks for the record with kappa infinite."""
LARGEST_BULK_TO_SHEAR = 1e5
"""kappa/mu above which only arithmetic tells a solid from an incompressible one: displacements
differ by about 1e-5 of their size."""


@dataclass(frozen=True)
class Material:
    """Record of the catalogue.

    ``bulk_to_shear`` is kappa/mu of the nearly incompressible solid, infinite for an exactly
    incompressible one (:attr:`incompressible`). ``tested_to_stretch`` is the
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
        """kappa [Pa], infinite for an exactly incompressible solid."""
        return self.bulk_to_shear * self.law.initial_shear_modulus

    @property
    def finite_bulk_modulus(self) -> float:
        """kappa [Pa], at most :data:`LARGEST_BULK_TO_SHEAR` mu: for a stiffness that must stay a
        number."""
        return min(self.bulk_to_shear, LARGEST_BULK_TO_SHEAR) * self.law.initial_shear_modulus

    @property
    def incompressible(self) -> "Material":
        """The same law, exactly incompressible; its key ends in :data:`INCOMPRESSIBLE`."""
        return replace(
            self, key=self.key + INCOMPRESSIBLE, name=f"{self.name}, incompressible",
            bulk_to_shear=math.inf,
        )  # fmt: skip

    @property
    def youngs_modulus(self) -> float:
        """Initial E [Pa] of the nearly incompressible solid, 9 mu / (3 + mu / kappa)."""
        return 9 * self.shear_modulus / (3 + 1 / self.bulk_to_shear)
