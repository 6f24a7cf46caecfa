"""Cells kept by their own content: a slider outside the cell costs no solve."""

from actuators.geometry import Body
from actuators.materials import material
from actuators.mechanics.cell.kept import Kept, linear_key
from actuators.mechanics.cell.periodic import CellResponse, coarse_mesh, solve_cell

_answers: Kept[CellResponse] = Kept(2048)


def cell_response(body: Body) -> CellResponse:
    """Answer of :func:`solve_cell` on the coarse mesh, from this process's store if the same cell
    (positions, filling, moduli) was asked for before."""
    materials = tuple(material(region.material) for region in body.regions)
    return _answers.get(
        linear_key(body, materials), lambda: solve_cell(body, materials, coarse_mesh(body))
    )


def forget_cells() -> None:
    """Empty the store (benchmarks time a new cell with it)."""
    _answers.forget()
