"""Embedded sheets of a periodic cell: they resist stretch along X1 and nothing else.

At small strain the energy of a flat sheet is K/2 (du1/dX1)^2 per area. Local nodes i + 3 j of a
face, coordinates -1..1.
"""

import numpy as np

TOP_FACE = np.arange(18, 27)
BOTTOM_FACE = np.arange(9)


def _lagrange(at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Values and slopes (points, 3) of the quadratics that are 1 at -1, 0 or 1."""
    value = np.stack([at * (at - 1) / 2, 1 - at**2, at * (at + 1) / 2], axis=-1)
    return value, np.stack([at - 0.5, -2 * at, at + 0.5], axis=-1)


def _table() -> tuple[np.ndarray, np.ndarray]:
    """dN/dxi of the nine nodes at the Gauss points (2, 9, g), two along X1 and three across, which
    is exact on parallelograms; and the weights (g,)."""
    (x, wx), (y, wy) = (np.polynomial.legendre.leggauss(n) for n in (2, 3))
    (nx, dx), (ny, dy) = _lagrange(x), _lagrange(y)
    slopes = [np.einsum("gi,hj->jihg", *pair).reshape(9, -1) for pair in ((dx, ny), (nx, dy))]
    return np.stack(slopes), np.outer(wy, wx).ravel()


_SLOPES, _WEIGHTS = _table()


def sheet_stiffness(face: np.ndarray, stiffness: np.ndarray) -> np.ndarray:
    """Stiffness of the first displacement component at the nine nodes, (f, 9, 9) [N/m].

    ``face``: (f, 9, 3) node positions in a horizontal plane [m]; ``stiffness``: (f,) [N/m].
    """
    tangent = np.einsum("pag,fai->fgip", _SLOPES, face[..., :2])
    area = np.linalg.det(tangent)
    slope = np.einsum("fgp,pag->fga", np.linalg.inv(tangent)[..., 0], _SLOPES)
    weight = stiffness[:, None] * _WEIGHTS * np.abs(area)
    return np.einsum("fg,fga,fgb->fab", weight, slope, slope)


def add_sheets(
    elements: np.ndarray, position: np.ndarray, nodes: np.ndarray, stiffness: np.ndarray
) -> None:
    """Add the sheets on one side of some elements to their matrices.

    ``elements``: (m, 81, 81), changed in place; ``position``: (m, 27, 3) [m]; ``nodes``: that
    side's local nodes (9,); ``stiffness``: (m,) of the sheet there, 0 where there is none [N/m].
    """
    there = np.flatnonzero(stiffness)
    dofs = 3 * nodes
    matrix = sheet_stiffness(position[there][:, nodes], stiffness[there])
    elements[np.ix_(there, dofs, dofs)] += matrix
