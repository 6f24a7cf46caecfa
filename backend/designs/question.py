"""From documents at the border to a checked design and scene."""

from collections.abc import Mapping
from typing import Any

from actuators.design import Design, parse_design
from actuators.materials import material
from actuators.mechanics.scene import Scene


def read_design(document: Mapping[str, Any]) -> Design:
    """Design whose parameters and materials can be used; raises InputError otherwise."""
    design = parse_design(document)
    for parameter in design.parameters():
        if parameter.kind == "material":
            material(getattr(design, parameter.name), field=parameter.name)
    return design


def read_scene(document: Mapping[str, Any]) -> Scene:
    """Scene that can be computed; raises InputError otherwise."""
    return Scene.from_document(document)
