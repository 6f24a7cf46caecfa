"""A whole actuator at small strain, clamped, without periodicity: the oracle for the cell.

Displacements only; bodies whose boxes are parallelepipeds (rectangular slabs, chambers at 90
degrees), half models."""

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

from actuators.design import Design
from actuators.geometry import CAVITY, build_body
from actuators.materials import material
from actuators.mechanics.cell.element import divergence, stiffness


def tip_turn_per_pressure(design: Design, wall_elements: int = 1) -> float:
    """Turn of the free end about X2 per pressure [rad/Pa], positive towards -X3.

    ``wall_elements``: elements over the height of the second interval from above (free walls)."""
    body = build_body(design).half()
    x, y, z = body.lines
    fill = np.repeat(body.fill, [1] * (len(z) - 3) + [wall_elements, 1], axis=2)
    wall = np.linspace(z[-3], z[-2], wall_elements + 1)[1:-1]
    z = np.sort(np.concatenate([z, wall]))
    corner = body.place(np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1))
    low = corner[:-1, :-1, :-1]
    edges = [corner[1:, :-1, :-1], corner[:-1, 1:, :-1], corner[:-1, :-1, 1:]]
    jacobian = np.stack([(e - low) / 2 for e in edges], axis=-1).reshape(-1, 3, 3)
    shape = np.array(fill.shape) * 2 + 1
    begin = np.stack(np.meshgrid(*[np.arange(n) for n in fill.shape], indexing="ij"), axis=-1)
    c, b, a = np.meshgrid(*[np.arange(3)] * 3, indexing="ij")
    local = np.stack([a.ravel(), b.ravel(), c.ravel()], axis=-1)
    at = 2 * begin.reshape(-1, 1, 3) + local
    nodes = np.ravel_multi_index(tuple(np.moveaxis(at, -1, 0)), tuple(shape))
    dofs = (3 * nodes[..., None] + np.arange(3)).reshape(len(nodes), 81)

    flat = fill.ravel()
    solid, air = flat >= 0, flat == CAVITY
    record = [material(r.material) for r in body.regions]
    shear = np.array([m.shear_modulus for m in record])[flat[solid]]
    bulk = np.array([m.bulk_modulus for m in record])[flat[solid]]
    size = 3 * int(np.prod(shape))
    blocks = stiffness(jacobian[solid], shear, bulk)
    rows, columns = np.repeat(dofs[solid], 81, axis=1), np.tile(dofs[solid], (1, 81))
    matrix = sp.csc_matrix((blocks.ravel(), (rows.ravel(), columns.ravel())), (size, size))
    load = np.bincount(
        dofs[air].ravel(), weights=divergence(jacobian[air])[:, 0].ravel(), minlength=size
    )
    free = np.zeros(size, dtype=bool)
    free[dofs[solid]] = True
    index = np.arange(size // 3)
    ix, iy, iz = np.unravel_index(index, tuple(shape))
    free[(3 * index[ix == 0][:, None] + np.arange(3)).ravel()] = False
    free[3 * index[iy == 0] + 1] = False
    keep = np.flatnonzero(free)
    u = np.zeros(size)
    u[keep] = splu(
        matrix[keep][:, keep], permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    ).solve(load[keep])  # fmt: skip
    # least-squares turn of the end face's X1 displacement over the height, on the middle plane
    end = index[(ix == shape[0] - 1) & (iy == 0)]
    height = np.interp(iz[end], np.arange(shape[2]), _nodes(z))
    return float(np.polyfit(height, u[3 * end], 1)[0])


def _nodes(lines: np.ndarray) -> np.ndarray:
    middles = (lines[:-1] + lines[1:]) / 2
    return np.sort(np.concatenate([lines, middles]))
