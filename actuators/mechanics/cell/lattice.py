"""The half cell as a lattice of 27-node hexahedra, periodic along X1.

Turning a chamber by half a turn about the vertical axis through its middle leaves it unchanged
(also where it stands obliquely), so the half X2 >= 0 is enough: its face X2 = 0 is tied to itself,
X1 to -X1. Nodes at X1 and X1 + pitch are one node.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from actuators.geometry import CAVITY, Body


@dataclass(frozen=True, eq=False)
class HalfCell:
    """Elements of the half X2 >= 0, coordinates about the chamber's vertical middle axis.

    Straight ones (parallelepipeds) are answered in closed form from ``corner`` and ``jacobian``,
    curved ones from ``position``.

    ``nodes``: (n, 27) int, wrapped node of each element's local node i + 3 j + 9 k; ``twin``: (m,)
    the node that each node becomes by the half turn, itself off the face X2 = 0; ``corner``: (n, 3)
    position of local node 0; ``jacobian``: (n, 3, 3) columns half edges [m]; ``position``:
    (n, 27, 3) of all nodes [m], None where all elements are straight; ``fill``: (n,) region
    or CAVITY or OUTSIDE; ``sheets``: (2, n) stiffness of the embedded sheets on the lower and the
    upper side of each element, every sheet on one side only [N/m]; ``shape``: nodes along
    (x, y, z); ``turn``: element borders from the lattice's beginning to the chamber's middle,
    doubled.
    """

    nodes: np.ndarray
    twin: np.ndarray
    corner: np.ndarray
    jacobian: np.ndarray
    position: np.ndarray | None
    fill: np.ndarray
    sheets: np.ndarray
    shape: tuple[int, int, int]
    turn: int

    @property
    def solid(self) -> np.ndarray:
        """Mask of elements made of rubber, (n,)."""
        return self.fill >= 0

    @property
    def cavity(self) -> np.ndarray:
        """Mask of elements of air under pressure, (n,)."""
        return self.fill == CAVITY

    def coordinates(self) -> np.ndarray:
        """Position of every element's nodes, unwrapped, shape (n, 27, 3) [m]."""
        if self.position is not None:
            return self.position
        k, j, i = np.meshgrid(*[np.arange(3)] * 3, indexing="ij")
        local = np.stack([i.ravel(), j.ravel(), k.ravel()], axis=-1)
        return self.corner[:, None] + np.einsum("nij,aj->nai", self.jacobian, local)


def half_cell(
    body: Body, parts: Sequence[Sequence[Sequence[float]]], *, rolled: bool = True
) -> HalfCell:
    """Lattice of one chamber. ``parts``: per axis and per interval the fractions of the interval
    that its elements take, as :func:`intervals` lists the intervals; those along x read the same
    backwards."""
    x, y, z, fill = intervals(body, rolled=rolled)
    lines = [divide(line, p) for line, p in zip((x, y, z), parts, strict=True)]
    for axis in range(3):
        fill = np.repeat(fill, [len(f) for f in parts[axis]], axis=axis)
    nx, ny, nz = fill.shape
    corners = np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1)
    axis_at = np.array([(body.lines[0][0] + body.lines[0][-1]) / 2, 0.0, 0.0])
    origin_at = body.place(axis_at) * [1, 1, 0]
    position = body.place(corners) - origin_at
    origin = position[:-1, :-1, :-1]
    edges = [position[1:, :-1, :-1], position[:-1, 1:, :-1], position[:-1, :-1, 1:]]
    jacobian = np.stack([(e - origin) / 2 for e in edges], axis=-1)

    periodic = 2 * nx
    shape = (periodic, 2 * ny + 1, 2 * nz + 1)
    i, j, k = np.meshgrid(np.arange(nx), np.arange(ny), np.arange(nz), indexing="ij")
    c, b, a = np.meshgrid(*[np.arange(3)] * 3, indexing="ij")
    at = [2 * n.ravel()[:, None] + m.ravel() for n, m in ((i, a), (j, b), (k, c))]
    nodes = ((at[0] % periodic) * shape[1] + at[1]) * shape[2] + at[2]
    ids = np.arange(periodic * shape[1] * shape[2]).reshape(shape)
    twin = ids.copy()
    # all of a curved lattice mirrors about the chamber's middle, of a straight one (see
    # ``intervals``) all but the last interval
    turn = nx if body.curved or not rolled else nx - len(parts[0][-1])
    twin[:, 0] = ids[(2 * turn - np.arange(periodic)) % periodic, 0]
    return HalfCell(
        nodes,
        twin.ravel(),
        origin.reshape(-1, 3),
        jacobian.reshape(-1, 3, 3),
        curved_nodes(body, lines, origin_at) if body.curved else None,
        fill.ravel(),
        _sheets(body, lines[2], fill),
        shape,
        turn,
    )


def curved_nodes(body: Body, lines: list[np.ndarray], origin: np.ndarray) -> np.ndarray:
    """Positions (n, 27, 3) of all nodes, line middles placed on the curves."""
    both = [np.sort(np.concatenate([line, (line[:-1] + line[1:]) / 2])) for line in lines]
    grid = body.place(np.stack(np.meshgrid(*both, indexing="ij"), axis=-1)) - origin
    shape = [len(line) - 1 for line in lines]
    nodes = np.empty((*shape, 27, 3))
    for number in range(27):
        i, j, k = number % 3, number // 3 % 3, number // 9
        nodes[..., number, :] = grid[i : i + 2 * shape[0] : 2, j : j + 2 * shape[1] : 2,
                                     k : k + 2 * shape[2] : 2]  # fmt: skip
    return nodes.reshape(-1, 27, 3)


def _sheets(body: Body, heights: np.ndarray, fill: np.ndarray) -> np.ndarray:
    """See :class:`HalfCell`: on top of the rubber below the sheet, else under that above it."""
    found = np.zeros((2, *fill.shape))
    for sheet in body.membranes:
        plane = int(np.argmin(np.abs(heights - sheet.plane)))
        if plane > 0:
            found[1, :, :, plane - 1] = np.where(fill[:, :, plane - 1] >= 0, sheet.stiffness, 0.0)
        if plane < fill.shape[2]:
            bare = (found[1, :, :, plane - 1] == 0.0) if plane > 0 else True
            rubber = fill[:, :, plane] >= 0
            found[0, :, :, plane] = np.where(rubber & bare, sheet.stiffness, 0.0)
    return found.reshape(2, -1)


def intervals(
    body: Body, *, rolled: bool = True
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Lattice lines (x, y >= 0, z) and fill of the half cell. Along x it begins at the end of the
    body's first interval and closes with the first and last intervals as one, across the period:
    a wall or gap shared with the next chamber needs no border in its middle. Curved lattices keep
    it: no element bends around it; so do those not to be ``rolled``."""
    x, y, z = body.lines
    if body.period is None or not np.array_equal(body.fill[0], body.fill[-1]):
        raise ValueError("a periodic cell must begin and end with the same filling")
    upper = np.flatnonzero(y > 0)
    across = np.concatenate([[0.0], y[upper]])
    if body.curved or not rolled:
        return x, across, z, body.fill[:, upper - 1]
    around = np.concatenate([x[1:-1], [x[1] + body.period]])
    fill = np.concatenate([body.fill[1:-1], body.fill[:1]])
    return around, across, z, fill[:, upper - 1]


def divide(lines: np.ndarray, parts: Sequence[Sequence[float]]) -> np.ndarray:
    """Lines with every interval cut into these fractions of it."""
    divided = [lines[:1]]
    for left, right, fractions in zip(lines[:-1], lines[1:], parts, strict=True):
        inner = left + (right - left) * np.cumsum(fractions)
        inner[-1] = right
        divided.append(inner)
    return np.concatenate(divided)
