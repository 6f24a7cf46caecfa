"""The cells of a design: paths over pressure; shear and bending, kept by their own content."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np

from actuators.design import Design, SlabDesign
from actuators.geometry import CAVITY, Body
from actuators.geometry.volumes import exact_volumes
from actuators.materials import Material, material
from actuators.mechanics.cell.cache import cell_response
from actuators.mechanics.cell.inflated import CellPath
from actuators.mechanics.cell.inflated_cache import cell_path
from actuators.mechanics.cell.kept import Kept, linear_key, nonlinear_key
from actuators.mechanics.cell.row import row_cells
from actuators.mechanics.cell.shear import shear_compliance, sideways_shear
from actuators.mechanics.cell_rod.bending import BendingChange, bending_change
from actuators.mechanics.response import Outcome
from actuators.mechanics.scene import Scene

AMPLY = 1.05
"""Growth of the cells over the one wanted, to spare for what weight takes of the cavity."""
PROLONGED = 1.5

_bendings: Kept[BendingChange] = Kept(512)
_shears: Kept[tuple[float, float]] = Kept(512)


def row_paths(design: Design, scene: Scene) -> tuple[tuple[CellPath, ...], np.ndarray]:
    """Paths of the design's cells as far as the scene goes, and their weights (n, cells)."""
    cells, weights = row_cells(design)
    path = partial(cell_path, contact=scene.choice("self_contact") != "off")
    if scene.pressure_to is not None:
        return tuple(path(cell, scene.pressure_to) for cell in cells), weights
    growth = float(scene.volume_to or 0.0) - exact_volumes(design).cavity
    return _grown_by(cells, weights, growth, path), weights


def row_apart(design: Design, paths: tuple[CellPath, ...]) -> tuple[CellPath, ...] | None:
    """The same cells to where ``paths`` come, with walls that run through each other; None where
    none meet. What loads do to walls that touch lies between the two."""
    if not any(path.touching_from is not None for path in paths):
        return None
    cells, _ = row_cells(design)
    return tuple(
        path if path.touching_from is None
        else cell_path(cell, float(path.pressure[-1]), contact=False)
        for cell, path in zip(cells, paths, strict=True)
    )  # fmt: skip


def _grown_by(
    cells: list[Body], weights: np.ndarray, growth: float, path: Callable[[Body, float], CellPath]
) -> tuple[CellPath, ...]:
    """Paths on which the cells together grow by ``growth`` [m3]: begun with what their linear
    compliance says, and prolonged where they stiffen."""
    linear = np.array([cell_response(cell).cavity_compliance for cell in cells])
    pressure = growth / float((weights @ linear).sum())
    paths = tuple(path(cell, pressure) for cell in cells)
    for _ in range(4):
        grown = float((weights @ [abs(p.volume[-1] - p.volume[0]) for p in paths]).sum())
        if grown > abs(growth) * AMPLY or any(p.outcome is not Outcome.CONVERGED for p in paths):
            break
        pressure *= PROLONGED
        paths = tuple(path(cell, pressure) for cell in cells)
    return paths


def row_shear(design: Design) -> np.ndarray:
    """Stiffness of the design's cells against shear along X2 and X3, (cells, 2) [N]."""
    return np.array([_shear(cell) for cell in row_cells(design)[0]])


def row_bending(design: Design) -> tuple[BendingChange, ...]:
    """How the stiffness of the design's cells changes as loads bend them."""
    return tuple(_bending(cell) for cell in row_cells(design)[0])


def end_bending(design: Design) -> BendingChange | None:
    """How the stiffness of a slab's solid ends changes as loads bend them: that of its first cell,
    filled. None of other families: their ends are stiff beside a floor between blocks."""
    if not isinstance(design, SlabDesign):
        return None
    cell = row_cells(design)[0][0]
    fill = cell.fill.copy()
    fill[fill == CAVITY] = len(cell.regions) - 1
    return _bending(replace(cell, fill=fill))


def _bending(cell: Body) -> BendingChange:
    materials = tuple(material(region.material) for region in cell.regions)
    return _bendings.get(
        nonlinear_key(cell, materials),
        lambda: bending_change(cell, materials, cell_response(cell).stiffness),
    )


def _shear(cell: Body) -> tuple[float, float]:
    materials = tuple(material(region.material) for region in cell.regions)
    return _shears.get(linear_key(cell, materials), lambda: _solve_shear(cell, materials))


def _solve_shear(cell: Body, materials: tuple[Material, ...]) -> tuple[float, float]:
    return sideways_shear(cell, materials), 1 / shear_compliance(cell, materials)


def forget_shear_and_bending() -> None:
    """Empty the stores (benchmarks time a new cell with it)."""
    _shears.forget()
    _bendings.forget()
