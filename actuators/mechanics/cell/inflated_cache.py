"""Inflated cells kept by their own content: what does not touch the cell costs no solve.

A path answers questions of its own end only. A longer one would answer shorter ones too, but its
points lie elsewhere, and so would the answer, by up to 1e-3 of the tip's way: what was asked before
must not change what a question is answered.
"""

from actuators.geometry import Body
from actuators.materials import material
from actuators.mechanics.cell.inflated import CellPath, inflate_cell
from actuators.mechanics.cell.kept import Kept, nonlinear_key

_answers: Kept[CellPath] = Kept(512)


def cell_path(body: Body, pressure_to: float, *, contact: bool = True) -> CellPath:
    """Answer of :func:`inflate_cell` up to ``pressure_to`` [Pa], with the catalogue's materials on
    the coarse mesh."""
    materials = tuple(material(region.material) for region in body.regions)
    return _answers.get(
        (nonlinear_key(body, materials), float(pressure_to), contact),
        lambda: inflate_cell(body, materials, pressure_to=pressure_to, contact=contact),
    )


def forget_paths() -> None:
    """Empty the store (benchmarks time a new cell with it)."""
    _answers.forget()
