"""The store of inflated cells."""

import pytest

from actuators.design import Design, SlabDesign, preset
from actuators.geometry import build_cell
from actuators.materials import material
from actuators.mechanics.cell import inflated_cache
from actuators.mechanics.cell.cache import cell_response, forget_cells
from actuators.mechanics.cell.inflated_cache import cell_path, forget_paths
from actuators.mechanics.cell.kept import linear_key, nonlinear_key


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


def _scaled(design: Design, factor: float) -> SlabDesign:
    assert isinstance(design, SlabDesign)
    lengths = [p.name for p in design.parameters() if p.kind == "length"]
    return design.model_copy(update={n: factor * getattr(design, n) for n in lengths})


@pytest.mark.parametrize("size", [1.0, 1e-3, 1e-6, 1e3])
def test_cells_a_thousandth_of_a_wall_apart_are_told_apart_at_any_size(size: float) -> None:
    design = _scaled(preset("slab-rectangle-low").design, size)
    thicker = design.model_copy(update={"roof_thickness": 1.001 * design.roof_thickness})
    same = _scaled(design, 1 + 1e-14)
    cells = [build_cell(d, 0) for d in (design, thicker, same)]
    materials = tuple(material(region.material) for region in cells[0].regions)
    for key in (linear_key, nonlinear_key):
        own, other, again = (key(cell, materials) for cell in cells)
        assert own != other
        assert own == again


def test_a_cell_of_micrometres_is_not_answered_with_its_neighbours_answer() -> None:
    # a body of 74 nm, where the thicker roof differs by 6 pm: as a body of 74 mm, a millionth long
    forget_cells()
    design = preset("slab-rectangle-low").design
    free: list[float] = []
    for size in (1.0, 1e-6):
        for roof in (1.0, 1.001):
            changed = _scaled(design, size)
            changed = changed.model_copy(update={"roof_thickness": roof * changed.roof_thickness})
            free.append(float(cell_response(build_cell(changed, 0)).free[2]) * size)
    assert free[1] != pytest.approx(free[0], rel=1e-5)
    assert free[2:] == pytest.approx(free[:2], rel=1e-10)
    forget_cells()
