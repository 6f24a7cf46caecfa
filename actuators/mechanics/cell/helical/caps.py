"""Volume behind what closes the air channel at the two ends of a pitch.

The flux of x/3 through the cavity's walls is the cavity's volume only if these close it. The
openings come in pairs: one where the next pitch goes on, and its image one pitch back. Through such
a pair passes T . a / 3, with T the shift of the screw motion and a the vector area of the forward
opening, which its rim alone decides:

    V = flux through walls + T . a / 3,      a = 1/2 integral of (x - c) x dx along the rim.

Of a half cell the rim is open: it begins and ends on the axis midway between two chambers, and c is
that axis' foot, so that closing it along the axis adds nothing.
"""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.cell.helical.domain import Domain
from actuators.mechanics.cell.helical.screw import Motion


@dataclass(frozen=True, eq=False)
class Rim:
    """``nodes``: (r,) mesh nodes; ``first``, ``second``: (m,) places among them of pairs a < b, and
    ``weight`` (m,): a = sum of weight x_a x x_b - c x sum of ``ends`` (r,) x."""

    nodes: np.ndarray
    first: np.ndarray
    second: np.ndarray
    weight: np.ndarray
    ends: np.ndarray


@dataclass(frozen=True, eq=False)
class CapVolume:
    """Volume [m3] and its derivatives: ``gradient`` (r, 3) with the rim's nodes; ``bend``
    (m, 3, 3) second derivative with the nodes of each pair; ``rate`` (4,) and ``second`` (4, 4)
    with the strains the nodes held; ``mixed`` (r, 3, 4)."""

    volume: float
    gradient: np.ndarray
    bend: np.ndarray
    rate: np.ndarray
    second: np.ndarray
    mixed: np.ndarray


def rim_of(domain: Domain) -> Rim:
    """Rim of the forward opening of a half cell."""
    mesh, air = domain.mesh, domain.air
    nx = air.shape[0]
    last = 2 * nx
    edges: dict[tuple[tuple[int, int, int], tuple[int, int, int]], float] = {}

    def add(corners: list[tuple[int, int, int]], begin: float) -> None:
        for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
            if (b, a) in edges:
                del edges[b, a]
            else:
                edges[a, b] = begin

    for j, k in np.argwhere(air[0] | air[-1]):
        add([(last, 2 * (j + b), 2 * (k + c)) for b, c in ((0, 0), (1, 0), (1, 1), (0, 1))], 0.0)
    for i in range(nx):
        if 2 * i + 2 <= domain.middle:
            continue
        begin = 0.5 if 2 * i < domain.middle else 0.0
        for k in map(int, np.flatnonzero(air[i, 0])):
            add([(2 * (i + a), 0, 2 * (k + c)) for a, c in ((0, 0), (1, 0), (1, 1), (0, 1))], begin)
    number = {tuple(at): n for n, at in enumerate(mesh.node_index.tolist())}
    total: dict[tuple[int, int], float] = {}
    ends: dict[int, float] = {}
    for (a, b), begin in edges.items():
        if a[1] == b[1] == 0 and a[0] == b[0] and a[0] <= domain.middle:
            continue  # on the axis, or before it
        middle = tuple((p + q) // 2 for p, q in zip(a, b, strict=True))
        nodes = [number[a], number[middle], number[b]]
        span = (-1.0, 1.0)
        if begin and a[0] != b[0]:  # half an edge: the axis crosses it
            span = (0.0, 1.0) if a[0] < b[0] else (-1.0, 0.0)
        table, change = _edge(*span)
        for p in range(3):
            ends[nodes[p]] = ends.get(nodes[p], 0.0) + change[p]
            for q in range(p + 1, 3):
                pair, sign = (nodes[p], nodes[q]), 1.0
                if pair[0] > pair[1]:
                    pair, sign = (pair[1], pair[0]), -1.0
                value = sign * (table[p, q] - table[q, p]) / 2
                total[pair] = total.get(pair, 0.0) + value
    used = np.array(sorted(ends), dtype=np.int64)
    place = {int(n): r for r, n in enumerate(used)}
    pairs = [p for p, w in total.items() if w != 0.0]
    return Rim(
        nodes=used,
        first=np.array([place[a] for a, _ in pairs], dtype=np.int64),
        second=np.array([place[b] for _, b in pairs], dtype=np.int64),
        weight=np.array([total[p] for p in pairs]),
        ends=np.array([ends[int(n)] / 2 for n in used]),
    )


def _edge(begin: float, end: float) -> tuple[np.ndarray, np.ndarray]:
    """int N_a N_b' over part of a quadratic edge (3, 3), and the change of N_a over it (3,)."""
    at, weight = np.polynomial.legendre.leggauss(3)
    xi = (begin + end) / 2 + (end - begin) / 2 * at
    value = np.stack([xi * (xi - 1) / 2, 1 - xi**2, xi * (xi + 1) / 2])
    slope = np.stack([xi - 0.5, -2 * xi, xi + 0.5])
    table = np.einsum("ag,bg,g->ab", value, slope, weight * (end - begin) / 2)

    def shape(x: float) -> np.ndarray:
        return np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2])

    return table, shape(end) - shape(begin)


def cap_volume(rim: Rim, positions: np.ndarray, pitch: Motion, half: Motion) -> CapVolume:
    """At node ``positions`` (n, 3), with the screw motions of a whole and of half a pitch."""
    x = positions[rim.nodes]
    a, b = x[rim.first], x[rim.second]
    area = np.einsum("m,mi->i", rim.weight, _cross(a, b))
    open_end = rim.ends @ x
    t, t_1, t_2 = pitch.shift / 3, pitch.shift_rate / 3, pitch.shift_second / 3
    c, c_1, c_2 = half.shift, half.shift_rate, half.shift_second
    # T . (c x v) = (T x c) . v
    lever = _cross(t, c)
    lever_1 = _cross(t_1, c) + _cross(t, c_1)
    both = _cross(t_1[:, None], c_1[None, :])
    lever_2 = _cross(t_2, c) + _cross(t, c_2) + both + np.swapaxes(both, 0, 1)
    gradient = np.zeros_like(x)
    np.add.at(gradient, rim.first, rim.weight[:, None] * _cross(b, t))
    np.add.at(gradient, rim.second, rim.weight[:, None] * _cross(t, a))
    gradient -= rim.ends[:, None] * lever
    mixed = np.zeros((*x.shape, 4))
    for k in range(4):
        np.add.at(mixed[..., k], rim.first, rim.weight[:, None] * _cross(b, t_1[k]))
        np.add.at(mixed[..., k], rim.second, rim.weight[:, None] * _cross(t_1[k], a))
        mixed[..., k] -= rim.ends[:, None] * lever_1[k]
    # t . (a x b): d2/da_i db_j = eps_kij t_k
    skew = np.array([[0.0, t[2], -t[1]], [-t[2], 0.0, t[0]], [t[1], -t[0], 0.0]])
    return CapVolume(
        volume=float(t @ area - lever @ open_end),
        gradient=gradient,
        bend=rim.weight[:, None, None] * skew,
        rate=t_1 @ area - lever_1 @ open_end,
        second=t_2 @ area - lever_2 @ open_end,
        mixed=mixed,
    )


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """As np.cross of (..., 3), which takes longer to look at its arguments than to work."""
    out = np.empty(np.broadcast_shapes(a.shape, b.shape))
    out[..., 0] = a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1]
    out[..., 1] = a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2]
    out[..., 2] = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return out
