"""Rotations and constant-strain segments of a rod, with series where the angle vanishes."""

import math

import numpy as np

_SMALL = 0.1  # angle below which the series' first neglected term is under 1e-16


def sinc_family(angle: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """sin(a)/a, (1 - cos a)/a^2 and (a - sin a)/a^3, smooth through a = 0; shape of ``angle``."""
    angle = np.asarray(angle, dtype=float)
    small = np.abs(angle) < _SMALL
    a = np.where(small, 1.0, angle)
    square = angle**2
    sine = np.sin(a)
    series = [
        sum(square**n * ((-1) ** n / math.factorial(2 * n + first)) for n in range(5))
        for first in (1, 2, 3)
    ]
    return (
        np.where(small, series[0], sine / a),
        np.where(small, series[1], 2 * np.sin(a / 2) ** 2 / a**2),
        np.where(small, series[2], (a - sine) / a**3),
    )


def segment(strain: np.ndarray, length: np.ndarray | float) -> tuple[np.ndarray, np.ndarray]:
    """Turn (..., 3, 3) and advance (..., 3) [m] along a segment of constant rod strain (..., 4)
    (stretch, torsion, bending about X2, bending about X3), in the frame at its beginning: an exact
    piece of helix."""
    length = np.asarray(length, dtype=float)
    turn = strain[..., 1:] * length[..., None]
    s, c, v = sinc_family(np.linalg.norm(turn, axis=-1))
    cross = skew(turn)
    square = cross @ cross
    identity = np.eye(3)
    rotation = identity + s[..., None, None] * cross + c[..., None, None] * square
    mean = identity + c[..., None, None] * cross + v[..., None, None] * square
    stretched = (1 + strain[..., 0]) * length
    return rotation, mean[..., :, 0] * stretched[..., None]


def skew(vector: np.ndarray) -> np.ndarray:
    """Matrix (..., 3, 3) of the cross product with ``vector`` (..., 3)."""
    matrix = np.zeros((*vector.shape, 3))
    x, y, z = np.moveaxis(vector, -1, 0)
    matrix[..., 0, 1], matrix[..., 0, 2] = -z, y
    matrix[..., 1, 0], matrix[..., 1, 2] = z, -x
    matrix[..., 2, 0], matrix[..., 2, 1] = -y, x
    return matrix


def helix(bending: np.ndarray, torsion: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Radius and pitch [m] of the helix with curvature ``bending`` and ``torsion`` [1/m] (G, 24 and
    25 in the form of docs/theory.md): R = |beta|/alpha^2, P = 2 pi |tau|/alpha^2 with alpha^2 =
    beta^2 + tau^2. A straight rod has infinite radius; 1/R = alpha^2/|beta| diverges at beta = 0
    (the rod twists about itself), where R = 0."""
    bending, torsion = np.abs(bending), np.abs(torsion)
    square = bending**2 + torsion**2
    straight = square == 0
    safe = np.where(straight, 1.0, square)
    radius = np.where(straight, np.inf, bending / safe)
    return radius, np.where(straight, np.inf, 2 * np.pi * torsion / safe)
