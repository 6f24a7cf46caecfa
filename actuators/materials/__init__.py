"""Hyperelastic laws and the catalogue of rubbers."""

from actuators.materials.catalogue import CATALOGUE, material
from actuators.materials.law import HyperelasticLaw
from actuators.materials.linear import LinearElastic
from actuators.materials.material import INCOMPRESSIBLE, Material
from actuators.materials.mooney_rivlin import MooneyRivlin
from actuators.materials.neo_hooke import NeoHooke
from actuators.materials.ogden import Ogden
from actuators.materials.stability import StableRange
from actuators.materials.yeoh import Yeoh

__all__ = [
    "CATALOGUE", "INCOMPRESSIBLE", "HyperelasticLaw", "LinearElastic", "Material", "MooneyRivlin",
    "NeoHooke", "Ogden", "StableRange", "Yeoh", "material",
]  # fmt: skip
