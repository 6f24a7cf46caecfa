"""How near a rod comes to the obstacles of its scene, and to itself."""

import math

import numpy as np

from actuators.mechanics.effects.forecast import Forecast
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.rod.equilibrium import shape

CURLED = 2.5
"""Distance along the body [its thickness] beyond which two places count as apart."""


def obstacle_distances(forecast: Forecast, obstacle: Plate | Cylinder) -> np.ndarray | None:
    """(k + 1,) least distance [m] of the body's outline from the obstacle: at rest, then along the
    path; None where the rod finds no equilibrium."""
    if forecast.path is None:
        return None
    rest = np.zeros_like(forecast.path[:1])
    outlines = [_outline(forecast, strain) for strain in (*rest, *forecast.path)]
    if isinstance(obstacle, Cylinder):
        return np.array([_from_cylinder(x, obstacle) for x in outlines])
    normal = np.array(obstacle.normal)
    surface = (outlines[0] @ normal).min() - obstacle.gap
    return np.array([(x @ normal).min() - surface for x in outlines])


def _outline(forecast: Forecast, strain: np.ndarray) -> np.ndarray:
    """(m, 3) points around the sections of the rod with these strains (s, 4)."""
    x, frames = shape(np.ascontiguousarray(strain), forecast.rod.length)
    y = forecast.width / 2 * np.array([-1.0, 0.0, 1.0])
    z = forecast.height * np.array([0.0, 0.5, 1.0])
    at = np.stack(np.meshgrid([0.0], y, z, indexing="ij"), axis=-1).reshape(-1, 3)
    return (x[:, None] + np.einsum("sij,aj->sai", frames, at)).reshape(-1, 3)


def _from_cylinder(x: np.ndarray, cylinder: Cylinder) -> float:
    axis = np.array(cylinder.axis)
    away = x - np.array(cylinder.centre)
    away = away - np.outer(away @ axis, axis)
    return float(np.linalg.norm(away, axis=1).min()) - cylinder.radius


def self_clearance(line: np.ndarray, thickness: float) -> float:
    """Least distance of a line (s, 3) from itself over ``thickness`` [m], places less than
    :data:`CURLED` thicknesses apart along it left out; infinite for a short one."""
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    apart = np.abs(along[:, None] - along) > CURLED * thickness
    if not apart.any():
        return math.inf
    distance = np.linalg.norm(line[:, None] - line, axis=-1)
    return float(distance[apart].min()) / thickness


def rod_clearance(forecast: Forecast) -> float | None:
    """Least :func:`self_clearance` of the rod along its path; None where it finds no
    equilibrium."""
    if forecast.path is None:
        return None
    thickness = max(forecast.height, forecast.width)
    lines = [
        shape(np.ascontiguousarray(strain), forecast.rod.length)[0] for strain in forecast.path
    ]
    return min(self_clearance(line, thickness) for line in lines)
