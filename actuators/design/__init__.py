"""Designs: the parameters of each family, their limits, presets and hash."""

from collections.abc import Mapping
from typing import Any

from actuators.design.base import Design
from actuators.design.oblique import ObliqueDesign
from actuators.design.parameter import Parameter
from actuators.design.presets import PRESETS, Preset, preset
from actuators.design.slab import SlabDesign
from actuators.errors import DesignError

FAMILIES: Mapping[str, type[Design]] = {"slab": SlabDesign, "oblique": ObliqueDesign}


def parse_design(document: Mapping[str, Any]) -> Design:
    """Design from a document in border units, of whichever family it names."""
    family = document.get("family")
    if not isinstance(family, str) or family not in FAMILIES:
        raise DesignError(
            f"family is {family!r}; it must be one of {', '.join(FAMILIES)}.",
            field="family", value=repr(family), mend=f"Use one of {', '.join(FAMILIES)}.",
        )  # fmt: skip
    return FAMILIES[family].from_document(document)


__all__ = [
    "FAMILIES", "PRESETS", "Design", "DesignError", "ObliqueDesign", "Parameter", "Preset",
    "SlabDesign", "parse_design", "preset",
]  # fmt: skip
