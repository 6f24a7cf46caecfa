"""The store of inflated cells."""

import pytest

from actuators.design import preset
from actuators.geometry import build_cell
from actuators.mechanics.cell import inflated_cache
from actuators.mechanics.cell.inflated_cache import cell_path, forget_paths


def test_a_path_answers_for_the_same_cell_to_the_same_end_only(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    forget_paths()
    design = preset("slab-rectangle-low").design
    long = cell_path(build_cell(design, 0), 2e3)
    assert cell_path(build_cell(design, 2), 2e3) is long

    asked: list[float] = []

    def counted(*arguments: object, pressure_to: float, contact: bool) -> object:
        asked.append(pressure_to)
        return long

    monkeypatch.setattr(inflated_cache, "inflate_cell", counted)
    cell_path(build_cell(design, 0), 3e3)
    cell_path(build_cell(design, 0), 1e3)
    thicker = design.model_copy(update={"roof_thickness": 6.5e-3})
    cell_path(build_cell(thicker, 0), 1e3)
    softer = design.model_copy(update={"top_material": "ecoflex-00-50"})
    cell_path(build_cell(softer, 0), 1e3)
    cell_path(build_cell(design, 0), -1e3)
    assert asked == [3e3, 1e3, 1e3, 1e3, -1e3]
    forget_paths()
