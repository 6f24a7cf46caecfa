"""From forces and stiffness of free mesh nodes to those of sites and rod strains (compiled).

A node at x_a = A y_s + b, with A and b functions of the strains e, moves by
G_a (dy_s, de) = A dy_s + (A_,k y_s + b_,k) de_k. Stiffness becomes G_a^T K_ab G_b for every pair of
nodes. Unknowns numbered below ``count`` stand in the sparse matrix (upper triangle by rows), those
from ``count`` on in the dense border.
"""

import numpy as np
from numba import njit

from actuators.mechanics.continuum.kernel.pattern import place_in_row

WIDTH = 7
"""Unknowns that move one node: three of its site, four strains."""


@njit(cache=True)
def _block(indptr: np.ndarray, values: np.ndarray, a: int, t: int, out: np.ndarray) -> None:
    """The (3, 3) block of node row ``a`` with its ``t``-th neighbour, from the upper triangle."""
    if t == 0:
        for i in range(3):
            for j in range(i, 3):
                out[i, j] = values[indptr[3 * a + i] + j - i]
                out[j, i] = out[i, j]
        return
    for i in range(3):
        begin = indptr[3 * a + i] + 3 * t - i
        for j in range(3):
            out[i, j] = values[begin + j]


@njit(cache=True)
def site_pairs(indptr: np.ndarray, indices: np.ndarray, site: np.ndarray) -> np.ndarray:
    """(m, 2) sites of every block of the nodes' matrix, smaller first; ``site`` of each
    node."""
    count = 0
    for a in range(len(site)):
        count += (indptr[3 * a + 1] - indptr[3 * a]) // 3
    pairs = np.empty((count, 2), dtype=np.int64)
    at = 0
    for a in range(len(site)):
        for t in range((indptr[3 * a + 1] - indptr[3 * a]) // 3):
            b = indices[indptr[3 * a] + 3 * t] // 3
            pairs[at, 0] = min(site[a], site[b])
            pairs[at, 1] = max(site[a], site[b])
            at += 1
    return pairs


@njit(cache=True)
def block_places(
    node_indptr: np.ndarray,
    node_indices: np.ndarray,
    unknown: np.ndarray,
    count: int,
    indptr: np.ndarray,
    indices: np.ndarray,
) -> np.ndarray:
    """(m, 3, 3) place in the reduced matrix of the entries of every node block, -1 for none.

    ``unknown``: (nodes, 7) number of the unknowns that move each node.
    """
    total = 0
    for a in range(len(unknown)):
        total += (node_indptr[3 * a + 1] - node_indptr[3 * a]) // 3
    places = np.full((total, 3, 3), -1, dtype=np.int32)
    at = 0
    for a in range(len(unknown)):
        for t in range((node_indptr[3 * a + 1] - node_indptr[3 * a]) // 3):
            b = node_indices[node_indptr[3 * a] + 3 * t] // 3
            for i in range(3):
                r = unknown[a, i]
                for j in range(3):
                    c = unknown[b, j]
                    if 0 <= r < count and 0 <= c < count:
                        places[at, i, j] = place_in_row(indptr, indices, min(r, c), max(r, c))
            at += 1
    return places


@njit(cache=True)
def _moved(
    block: np.ndarray, motion_a: np.ndarray, motion_b: np.ndarray, half: np.ndarray, out: np.ndarray
) -> None:
    """out = G_a^T block G_b, (7, 7)."""
    for i in range(3):
        for j in range(WIDTH):
            half[i, j] = 0.0
            for k in range(3):
                half[i, j] += block[i, k] * motion_b[k, j]
    for i in range(WIDTH):
        for j in range(WIDTH):
            out[i, j] = 0.0
            for k in range(3):
                out[i, j] += motion_a[k, i] * half[k, j]


@njit(cache=True)
def _add(
    entry: np.ndarray,
    width: int,
    same: bool,
    unknown_a: np.ndarray,
    unknown_b: np.ndarray,
    count: int,
    place: np.ndarray,
    values: np.ndarray,
    border: np.ndarray,
    corner: np.ndarray,
) -> None:
    """Add a block of two nodes' unknowns, and its transpose where they are not the ``same``
    node."""
    for i in range(width):
        r = unknown_a[i]
        if r < 0:
            continue
        for j in range(width):
            c = unknown_b[j]
            if c < 0:
                continue
            value = entry[i, j]
            if r < count and c < count:
                if not same:
                    values[place[i, j]] += 2 * value if r == c else value
                elif r <= c:
                    values[place[i, j]] += value
            elif r < count:
                border[r, c - count] += value
            elif c < count:
                if not same:
                    border[c, r - count] += value
            else:
                corner[r - count, c - count] += value
                if not same:
                    corner[c - count, r - count] += value


@njit(cache=True)
def reduce_stiffness(
    node_indptr: np.ndarray,
    node_indices: np.ndarray,
    node_values: np.ndarray,
    motion: np.ndarray,
    still: np.ndarray,
    unknown: np.ndarray,
    count: int,
    places: np.ndarray,
    values: np.ndarray,
    border: np.ndarray,
    corner: np.ndarray,
) -> None:
    """Add to ``values`` (sparse), ``border`` (count, k) and ``corner`` (k, k).

    ``motion``: (nodes, 3, 7) G of each outer node; ``still``: (nodes,) where it is the identity.
    """
    block, half, entry = np.empty((3, 3)), np.empty((3, WIDTH)), np.empty((WIDTH, WIDTH))
    at = 0
    for a in range(len(unknown)):
        for t in range((node_indptr[3 * a + 1] - node_indptr[3 * a]) // 3):
            b = node_indices[node_indptr[3 * a] + 3 * t] // 3
            _block(node_indptr, node_values, a, t, block)
            if still[a] and still[b]:
                _add(
                    block, 3, t == 0, unknown[a], unknown[b], count, places[at], values, border,
                    corner,
                )  # fmt: skip
            else:
                _moved(block, motion[a], motion[b], half, entry)
                _add(
                    entry, WIDTH, t == 0, unknown[a], unknown[b], count, places[at], values, border,
                    corner,
                )  # fmt: skip
            at += 1


@njit(cache=True)
def reduce_pairs(
    first: np.ndarray,
    second: np.ndarray,
    blocks: np.ndarray,
    motion: np.ndarray,
    unknown: np.ndarray,
    count: int,
    indptr: np.ndarray,
    indices: np.ndarray,
    values: np.ndarray,
    border: np.ndarray,
    corner: np.ndarray,
) -> None:
    """Add ``blocks`` (m, 3, 3) of pairs of different nodes that share an element."""
    place = np.full((3, 3), -1, dtype=np.int32)
    half, entry = np.empty((3, WIDTH)), np.empty((WIDTH, WIDTH))
    for n in range(len(first)):
        a, b = first[n], second[n]
        for i in range(3):
            for j in range(3):
                r, c = unknown[a, i], unknown[b, j]
                if 0 <= r < count and 0 <= c < count:
                    place[i, j] = place_in_row(indptr, indices, min(r, c), max(r, c))
        _moved(blocks[n], motion[a], motion[b], half, entry)
        _add(entry, WIDTH, False, unknown[a], unknown[b], count, place, values, border, corner)
