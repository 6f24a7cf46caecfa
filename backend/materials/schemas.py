"""What the materials feature gives."""

from typing import Any

from pydantic import Field

from backend.documents import Answer


class MaterialInfo(Answer):
    """A record of the catalogue."""

    key: str
    name: str
    model: str
    shear_modulus_kPa: float = Field(description="Initial shear modulus [kPa]")
    youngs_modulus_kPa: float = Field(description="Initial Young's modulus [kPa]")
    density_kg_m3: float
    source: str
    note: str
    tested_to_stretch: float | None = Field(
        description="Largest uniaxial stretch of the source; null where it does not say"
    )
    constants: dict[str, Any] = Field(description="Model constants, units in their names")
