"""Quadratic Lagrange shape functions and Gauss points of the cube and the square."""

import numpy as np


def line_shape(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Values and derivatives (n, 3) of the three quadratic functions at x (n,)."""
    value = np.stack([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2], axis=-1)
    slope = np.stack([x - 0.5, -2 * x, x + 0.5], axis=-1)
    return value, slope


def cube_shape(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Values (n, 27) and local derivatives (n, 3, 27) at ``points`` (n, 3), node i + 3 j + 9 k."""
    (x, dx), (y, dy), (z, dz) = (line_shape(points[:, d]) for d in range(3))

    def product(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
        return np.einsum("nk,nj,ni->nkji", c, b, a).reshape(len(points), 27)

    slopes = np.stack([product(dx, y, z), product(x, dy, z), product(x, y, dz)], axis=1)
    return product(x, y, z), np.ascontiguousarray(slopes)


def square_shape(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Values (n, 9) and local derivatives (n, 2, 9) at ``points`` (n, 2), node i + 3 j."""
    (x, dx), (y, dy) = (line_shape(points[:, d]) for d in range(2))

    def product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.einsum("nj,ni->nji", b, a).reshape(len(points), 9)

    return product(x, y), np.ascontiguousarray(np.stack([product(dx, y), product(x, dy)], axis=1))


def gauss_cube(order: int) -> tuple[np.ndarray, np.ndarray]:
    """Points (order^3, 3) and weights, X fastest."""
    x, w = np.polynomial.legendre.leggauss(order)
    points = np.stack(np.meshgrid(x, x, x, indexing="ij")[::-1], axis=-1).reshape(-1, 3)
    return points, np.einsum("k,j,i->kji", w, w, w).ravel()


def gauss_square(order: int) -> tuple[np.ndarray, np.ndarray]:
    """Points (order^2, 2) and weights, first axis fastest."""
    x, w = np.polynomial.legendre.leggauss(order)
    points = np.stack(np.meshgrid(x, x, indexing="ij")[::-1], axis=-1).reshape(-1, 2)
    return points, np.outer(w, w).ravel()


CUBE_POINTS, CUBE_WEIGHTS = gauss_cube(3)
CUBE_VALUES, CUBE_SLOPES = cube_shape(CUBE_POINTS)
# pressure functions 1, xi, eta, zeta at the Gauss points, (27, 4)
PRESSURE_VALUES: np.ndarray = np.concatenate([np.ones((27, 1)), CUBE_POINTS], axis=1)
# quadratic in every factor of x . (x_xi x x_eta): degree 5 per direction, exact with 3 x 3 points
SQUARE_POINTS, SQUARE_WEIGHTS = gauss_square(3)
SQUARE_VALUES, SQUARE_SLOPES = square_shape(SQUARE_POINTS)
