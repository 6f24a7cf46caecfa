"""Sparsity of the global matrix: upper triangle by rows, and where each element's entries go."""

import numpy as np
from numba import njit, prange


@njit(cache=True)
def node_neighbours(outer: np.ndarray, node_count: int) -> tuple[np.ndarray, np.ndarray]:
    """CSR lists of the nodes that share an element with each node, sorted; ``outer`` (m, 26)."""
    start = np.zeros(node_count + 1, dtype=np.int64)
    for e in range(len(outer)):
        for n in range(outer.shape[1]):
            start[outer[e, n] + 1] += 1
    for n in range(node_count):
        start[n + 1] += start[n]
    fill = start[:-1].copy()
    owner = np.empty(start[-1], dtype=np.int32)
    for e in range(len(outer)):
        for n in range(outer.shape[1]):
            owner[fill[outer[e, n]]] = e
            fill[outer[e, n]] += 1
    mark = np.full(node_count, -1, dtype=np.int64)
    first = np.zeros(node_count + 1, dtype=np.int64)
    found = np.empty(start[-1] * outer.shape[1], dtype=np.int32)
    total = 0
    for n in range(node_count):
        begin = total
        for at in range(start[n], start[n + 1]):
            for other in outer[owner[at]]:
                if mark[other] != n:
                    mark[other] = n
                    found[total] = other
                    total += 1
        found[begin:total].sort()
        first[n + 1] = total
    return first, found[:total].copy()


@njit(cache=True)
def merge_neighbours(
    first: np.ndarray, neighbours: np.ndarray, more_first: np.ndarray, more: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """CSR lists with the sorted union of two lists in every row."""
    start = np.zeros_like(first)
    merged = np.empty(len(neighbours) + len(more), dtype=np.int32)
    total = 0
    for n in range(len(first) - 1):
        a, b = first[n], more_first[n]
        while a < first[n + 1] or b < more_first[n + 1]:
            if b == more_first[n + 1] or (a < first[n + 1] and neighbours[a] <= more[b]):
                merged[total] = neighbours[a]
                if b < more_first[n + 1] and neighbours[a] == more[b]:
                    b += 1
                a += 1
            else:
                merged[total] = more[b]
                b += 1
            total += 1
        start[n + 1] = total
    return start, merged[:total].copy()


@njit(cache=True)
def upper_rows(
    first: np.ndarray, neighbours: np.ndarray, dof: np.ndarray, unknowns: int
) -> tuple[np.ndarray, np.ndarray]:
    """``indptr``, ``indices`` of the upper triangle; unknowns are numbered in node order."""
    indptr = np.zeros(unknowns + 1, dtype=np.int32)
    for n in range(len(dof)):
        for i in range(3):
            row = dof[n, i]
            if row >= 0:
                for at in range(first[n], first[n + 1]):
                    for k in range(3):
                        if dof[neighbours[at], k] >= row:
                            indptr[row + 1] += 1
    for row in range(unknowns):
        indptr[row + 1] += indptr[row]
    indices = np.empty(indptr[-1], dtype=np.int32)
    fill = indptr[:-1].copy()
    for n in range(len(dof)):
        for i in range(3):
            row = dof[n, i]
            if row >= 0:
                for at in range(first[n], first[n + 1]):
                    for k in range(3):
                        column = dof[neighbours[at], k]
                        if column >= row:
                            indices[fill[row]] = column
                            fill[row] += 1
    return indptr, indices


@njit(cache=True)
def place_in_row(indptr: np.ndarray, indices: np.ndarray, row: int, column: int) -> int:
    """Where ``column`` stands in ``row``, or would have to."""
    low, high = indptr[row], indptr[row + 1]
    while low < high:
        middle = (low + high) // 2
        if indices[middle] < column:
            low = middle + 1
        else:
            high = middle
    return low


@njit(cache=True, parallel=True)
def scatter_map(
    outer: np.ndarray, dof: np.ndarray, indptr: np.ndarray, indices: np.ndarray
) -> np.ndarray:
    """(m, 3081) place in the matrix of each entry of an element's upper triangle, or -1."""
    width = 3 * outer.shape[1]
    places = np.empty((len(outer), width * (width + 1) // 2), dtype=np.int32)
    for e in prange(len(outer)):
        t = 0
        for i in range(width):
            r = dof[outer[e, i // 3], i % 3]
            for j in range(i, width):
                c = dof[outer[e, j // 3], j % 3]
                place = -1
                if r >= 0 and c >= 0:
                    row, column = min(r, c), max(r, c)
                    place = place_in_row(indptr, indices, row, column)
                places[e, t] = place
                t += 1
    return places
