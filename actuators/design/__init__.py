"""Designs: the parameters of each family, their limits, presets and hash."""

from collections.abc import Mapping
from typing import Any

from actuators.design.base import Design
from actuators.design.bellows import BellowsDesign
from actuators.design.blocks import BlockBar
from actuators.design.oblique import ObliqueDesign
from actuators.design.parameter import Parameter
from actuators.design.presets import PRESETS, Preset, preset
from actuators.design.printed import PrintedDesign
from actuators.design.slab import SlabDesign
from actuators.errors import DesignError

FAMILIES: Mapping[str, type[Design]] = {
    "slab": SlabDesign,
    "oblique": ObliqueDesign,
    "printed": PrintedDesign,
    "bellows": BellowsDesign,
}
BLOCK_FAMILIES = (ObliqueDesign, PrintedDesign)
"""Families made of chamber blocks: each has a ``bar``."""


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
    "BLOCK_FAMILIES", "FAMILIES", "PRESETS", "BellowsDesign", "BlockBar", "Design", "DesignError",
    "ObliqueDesign",
    "Parameter", "Preset", "PrintedDesign", "SlabDesign", "parse_design", "preset",
]  # fmt: skip
