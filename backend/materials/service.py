"""The catalogue in border units."""

from functools import cache

from actuators.materials import CATALOGUE, Material
from backend.materials.schemas import MaterialInfo


@cache
def catalogue() -> list[MaterialInfo]:
    """Every material, in the catalogue's order."""
    return [_info(record) for record in CATALOGUE.values()]


def _info(record: Material) -> MaterialInfo:
    return MaterialInfo(
        key=record.key,
        name=record.name,
        model=record.law.model,
        shear_modulus_kPa=_rounded(record.shear_modulus / 1e3),
        youngs_modulus_kPa=_rounded(record.youngs_modulus / 1e3),
        density_kg_m3=record.density,
        source=record.source,
        note=record.note,
        tested_to_stretch=record.tested_to_stretch,
        constants=record.law.to_document(),
    )


def _rounded(value: float) -> float:
    """12 digits: Pa to kPa must not leave 15.700000000000001 behind."""
    return float(f"{value:.12g}")
