"""Small-strain Q2/P1 stiffness of affine 27-node hexahedra, in closed form.

Every box of a periodic cell is a parallelepiped, so its Jacobian J is constant and the integrals
over the reference cube separate from it: no quadrature, no compiled loop, one matrix product for
all elements. Same element as the three-dimensional solver's at zero strain: triquadratic
displacement, element-wise linear pressure, condensed. Local node i + 3 j + 9 k, coordinates -1..1.
"""

from functools import lru_cache

import numpy as np

NODES = 27
_MASS = np.array([[4, 2, -1], [2, 16, 2], [-1, 2, 4]]) / 15.0  # int N_a N_b
_SLOPE = np.array([[-3, -4, 1], [4, 0, -4], [-1, 4, 3]]) / 6.0  # int N'_a N_b
_STIFF = np.array([[7, -8, 1], [-8, 16, -8], [1, -8, 7]]) / 6.0  # int N'_a N'_b
_LOAD = np.array([1, 4, 1]) / 3.0  # int N_a
_LOAD_XI = np.array([-1, 0, 1]) / 3.0  # int xi N_a
_JUMP = np.array([-1, 0, 1], dtype=float)  # int N'_a
_JUMP_XI = np.array([2, -4, 2]) / 3.0  # int xi N'_a


def _product(factors: list[np.ndarray]) -> np.ndarray:
    """Tensor product over (x, y, z) in the local numbering: x runs fastest."""
    x, y, z = factors
    return np.kron(z, np.kron(y, x))


@lru_cache(maxsize=1)
def reference_gradients() -> np.ndarray:
    """int dN_a/dxi_p dN_b/dxi_q over the reference cube, shape (9, 729): (p q, a b)."""
    table = np.empty((3, 3, NODES, NODES))
    for p in range(3):
        for q in range(3):
            factors = [_MASS, _MASS, _MASS]
            if p == q:
                factors[p] = _STIFF
            else:
                factors[p], factors[q] = _SLOPE, _SLOPE.T
            table[p, q] = _product(factors)
    return table.reshape(9, NODES * NODES)


@lru_cache(maxsize=1)
def reference_divergence() -> np.ndarray:
    """int q_l dN_a/dxi_p with q = (1, xi, eta, zeta), shape (3, 108): (p, l a)."""
    table = np.empty((3, 4, NODES))
    for p in range(3):
        for moment in range(4):
            factors = [_LOAD, _LOAD, _LOAD]
            factors[p] = _JUMP
            if moment:
                axis = moment - 1
                factors[axis] = _JUMP_XI if axis == p else _LOAD_XI
            table[p, moment] = _product(factors)
    return table.reshape(3, 4 * NODES)


def divergence(jacobian: np.ndarray) -> np.ndarray:
    """int q_l div(N_a e_i) of each element, shape (n, 4, 81): pressure mode l, local dof 3 a + i.

    ``jacobian``: (n, 3, 3), columns are the half edges dx/dxi [m]. Row 0 is the change of the
    element's volume with its nodes [m2].
    """
    inverse = np.linalg.inv(jacobian)
    volume = np.linalg.det(jacobian)
    table = np.swapaxes(inverse, -1, -2) @ reference_divergence()  # (n, i, l a)
    table = table.reshape(-1, 3, 4, NODES) * volume[:, None, None, None]
    return np.moveaxis(table, 1, 3).reshape(-1, 4, 3 * NODES)


def stiffness(jacobian: np.ndarray, shear: np.ndarray, bulk: np.ndarray) -> np.ndarray:
    """Stiffness of each element with the pressure condensed, shape (n, 81, 81) [N/m].

    ``jacobian``: (n, 3, 3) [m]; ``shear``, ``bulk``: (n,) moduli mu, kappa [Pa].
    """
    count = len(jacobian)
    inverse = np.linalg.inv(jacobian)
    volume = np.linalg.det(jacobian)
    pairs = np.einsum("npi,nqj->nijpq", inverse, inverse).reshape(count, 9, 9)
    pairs *= (shear * volume)[:, None, None]
    gradients = (pairs @ reference_gradients()).reshape(count, 3, 3, NODES, NODES)
    trace = gradients[:, 0, 0] + gradients[:, 1, 1] + gradients[:, 2, 2]
    matrix = np.swapaxes(gradients, 1, 2) - (2 / 3) * gradients
    for i in range(3):
        matrix[:, i, i] += trace
    matrix = matrix.transpose(0, 3, 1, 4, 2).reshape(count, 81, 81)
    rows = divergence(jacobian)
    # q_l are orthogonal on an affine element: int q_l q_m = det J diag(8, 8/3, 8/3, 8/3)
    weight = (bulk / volume)[:, None, None] * np.array([1, 3, 3, 3])[:, None] / 8
    return matrix + np.swapaxes(rows, 1, 2) @ (weight * rows)
