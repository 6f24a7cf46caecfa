"""Small-strain Q2/P1 stiffness of curved 27-node hexahedra, by 3 x 3 x 3 Gauss points.

The same element as :mod:`.element`, whose closed form needs a constant Jacobian: pressure
element-wise linear in the local coordinates, condensed.
"""

import numpy as np

from actuators.mechanics.cell.element import NODES

POINTS = 27


def _tables() -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Values (27 points, 27 nodes), slopes (27 points, 3, 27 nodes), pressure modes (27 points, 4),
    weights (27 points,)."""
    line, weight = np.polynomial.legendre.leggauss(3)
    value = np.stack([line * (line - 1) / 2, 1 - line**2, line * (line + 1) / 2], axis=-1)
    slope = np.stack([line - 0.5, -2 * line, line + 0.5], axis=-1)
    slopes = [
        np.einsum(
            "zk,yj,xi->zyxkji",
            *[slope if axis == d else value for axis in (2, 1, 0)],
        ).reshape(POINTS, NODES)
        for d in range(3)
    ]
    z, y, x = np.meshgrid(line, line, line, indexing="ij")
    modes = np.stack([np.ones(POINTS), x.ravel(), y.ravel(), z.ravel()], axis=-1)
    values = np.einsum("zk,yj,xi->zyxkji", value, value, value).reshape(POINTS, NODES)
    return values, np.stack(slopes, axis=1), modes, np.einsum("k,j,i->kji", *[weight] * 3).ravel()


VALUES, SLOPES, MODES, WEIGHTS = _tables()


def gradients(position: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """dN_a/dx_i at the Gauss points (n, 27, 3, 27) [1/m] and their volumes (n, 27) [m3] of
    elements with nodes at ``position`` (n, 27, 3) [m]."""
    jacobian = _jacobian(position)
    return np.linalg.inv(jacobian) @ SLOPES, np.linalg.det(jacobian) * WEIGHTS


def volumes(position: np.ndarray) -> np.ndarray:
    """Volumes (n, 27) of the Gauss points [m3]."""
    return np.linalg.det(_jacobian(position)) * WEIGHTS


def _jacobian(position: np.ndarray) -> np.ndarray:
    """dx_i/dxi_p at the Gauss points (n, 27, p, i)."""
    return (SLOPES.reshape(-1, NODES) @ position).reshape(-1, POINTS, 3, 3)


def divergence(position: np.ndarray) -> np.ndarray:
    """int q_l div(N_a e_i) of each element, shape (n, 4, 81); see :func:`.element.divergence`."""
    slopes, volume = gradients(position)
    rows = np.einsum("gl,ngia,ng->nlai", MODES, slopes, volume, optimize=True)
    return rows.reshape(len(position), 4, 3 * NODES)


def stiffness(position: np.ndarray, shear: np.ndarray, bulk: np.ndarray) -> np.ndarray:
    """Stiffness of each element with the pressure condensed, shape (n, 81, 81) [N/m].

    ``position``: (n, 27, 3) [m]; ``shear``, ``bulk``: (n,) moduli mu, kappa [Pa].
    """
    count = len(position)
    slopes, volume = gradients(position)
    flat = slopes.reshape(count, POINTS, 3 * NODES)  # (i a)
    weighted = flat * (shear[:, None] * volume)[..., None]
    pairs = (np.swapaxes(flat, 1, 2) @ weighted).reshape(count, 3, NODES, 3, NODES)
    pairs = pairs.transpose(0, 1, 3, 2, 4)  # int mu dN_a/dx_i dN_b/dx_j as (n, i, j, a, b)
    trace = pairs[:, 0, 0] + pairs[:, 1, 1] + pairs[:, 2, 2]
    matrix = np.swapaxes(pairs, 1, 2) - (2 / 3) * pairs
    for i in range(3):
        matrix[:, i, i] += trace
    matrix = matrix.transpose(0, 3, 1, 4, 2).reshape(count, 3 * NODES, 3 * NODES)
    rows = np.einsum("gl,ngia,ng->nlai", MODES, slopes, volume, optimize=True)
    rows = rows.reshape(count, 4, 3 * NODES)
    mass = np.einsum("gl,gm,ng->nlm", MODES, MODES, volume, optimize=True)
    return matrix + np.swapaxes(rows, 1, 2) @ (bulk[:, None, None] * np.linalg.solve(mass, rows))


def largest_strain(position: np.ndarray, local: np.ndarray) -> float:
    """Largest principal strain, mean over an element, of displacements (n, 81)."""
    slopes, volume = gradients(position)
    share = volume / volume.sum(axis=1, keepdims=True)
    mean = np.einsum("ngja,ng->nja", slopes, share, optimize=True)
    gradient = np.einsum("nja,nai->nij", mean, local.reshape(-1, NODES, 3))
    strain = (gradient + np.swapaxes(gradient, 1, 2)) / 2
    return float(np.linalg.eigvalsh(strain)[:, -1].max())
