"""Unknowns counted on the lattice, beside those of meshes."""

import pytest

from actuators.design import preset
from actuators.geometry import build_body
from actuators.mechanics.continuum.level import condensed_size
from actuators.meshing import mesh_body
from actuators.meshing.counting import condensed_unknowns


@pytest.mark.parametrize("layers", [(0, 0, 0), (1, 0, 1), (2, 1, 0)])
@pytest.mark.parametrize("name", ["slab-ellipse-low", "oblique-45", "printed-14", "bellows-9-2.0"])
def test_a_mesh_is_as_large_as_counted_without_it(name: str, layers: tuple[int, int, int]) -> None:
    body = build_body(preset(name).design)
    for part in (body, body.half()) if body.symmetric else (body,):
        counted = condensed_unknowns(part, layers)
        assert counted == condensed_size(mesh_body(part, layers=layers))
