"""Fields from a coarse mesh to a finer one of the same body."""

import numpy as np
import scipy.sparse as sp

from actuators.meshing.hex_mesh import HexMesh


def prolong_nodes(coarse: HexMesh, fine: HexMesh) -> sp.csr_matrix:
    """(n_fine, n_coarse) values of the coarse quadratic interpolant at the fine nodes.

    Exact where the lines of ``fine`` contain those of ``coarse``; meshes that are not nested are
    interpolated all the same, as the start of an iteration.
    """
    element_at = _element_lookup(coarse)
    place = [_candidates(coarse.lines[d], fine.lines[d]) for d in range(3)]
    index = fine.node_index
    chosen = np.full(len(index), -1)
    local = np.zeros((len(index), 3))
    for corner in range(8):
        side = (corner & 1, corner >> 1 & 1, corner >> 2)
        cell = np.stack([place[d][0][side[d]][index[:, d]] for d in range(3)], axis=-1)
        element = element_at[tuple(cell.T)]
        take = (chosen < 0) & (element >= 0)
        chosen[take] = element[take]
        for d in range(3):
            local[take, d] = place[d][1][side[d]][index[take, d]]
    if (chosen < 0).any():
        raise ValueError("the two meshes do not belong to the same body")
    weights = _quadratic_weights(local)
    rows = np.repeat(np.arange(len(index)), 27)
    matrix = sp.csr_matrix(
        (weights.ravel(), (rows, coarse.elements[chosen].ravel())),
        shape=(len(index), len(coarse.nodes)),
    )
    matrix.eliminate_zeros()
    return matrix


def prolong_pressure(coarse: HexMesh, fine: HexMesh, pressure: np.ndarray) -> np.ndarray:
    """Element-wise linear pressure (m, 4) [value, three slopes in local coordinates]."""
    cell = np.empty((len(fine.box), 3), dtype=int)
    local = np.empty((len(fine.box), 3))
    scale = np.empty((len(fine.box), 3))
    for d in range(3):
        a, b = fine.lines[d][:-1][fine.box[:, d]], fine.lines[d][1:][fine.box[:, d]]
        k = np.searchsorted(coarse.lines[d], (a + b) / 2) - 1
        low, high = coarse.lines[d][k], coarse.lines[d][k + 1]
        cell[:, d] = k
        local[:, d] = (a + b - low - high) / (high - low)
        scale[:, d] = (b - a) / (high - low)
    old = pressure[_element_lookup(coarse)[tuple(cell.T)]]
    new = np.empty_like(old)
    new[:, 0] = old[:, 0] + (old[:, 1:] * local).sum(axis=1)
    new[:, 1:] = old[:, 1:] * scale
    return new


def _element_lookup(mesh: HexMesh) -> np.ndarray:
    shape = tuple(len(line) - 1 for line in mesh.lines)
    lookup = np.full(shape, -1)
    lookup[tuple(mesh.box.T)] = np.arange(len(mesh.box))
    return lookup


def _candidates(
    coarse: np.ndarray, fine: np.ndarray
) -> tuple[tuple[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]:
    """Intervals of ``coarse`` to the left and right of each fine line or middle, and the local
    coordinates there in [-1, 1]."""
    at = np.empty(2 * len(fine) - 1)
    at[::2] = fine
    at[1::2] = (fine[:-1] + fine[1:]) / 2
    slack = 1e-9 * np.diff(coarse).min()
    last = len(coarse) - 2
    left = np.clip(np.searchsorted(coarse, at - slack) - 1, 0, last)
    right = np.clip(np.searchsorted(coarse, at + slack) - 1, 0, last)

    def local(k: np.ndarray) -> np.ndarray:
        return (2 * at - coarse[k] - coarse[k + 1]) / (coarse[k + 1] - coarse[k])

    return (left, right), (local(left), local(right))


def _quadratic_weights(local: np.ndarray) -> np.ndarray:
    """(n, 27) Lagrange weights at local coordinates (n, 3)."""
    one = np.stack(
        [local * (local - 1) / 2, (1 - local) * (1 + local), local * (local + 1) / 2], axis=-1
    )
    x, y, z = one[:, 0], one[:, 1], one[:, 2]
    return np.einsum("nk,nj,ni->nkji", z, y, x).reshape(len(local), 27)
