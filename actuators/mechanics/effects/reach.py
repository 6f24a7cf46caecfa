"""How near a rod comes to the obstacles of its scene and to itself, and what way they leave it."""

import math

import numpy as np

from actuators.mechanics.effects.forecast import STATIONS, Forecast
from actuators.mechanics.obstacles import Cylinder, Plate
from actuators.mechanics.rod.carried import follow_scene
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


def narrowing(forecast: Forecast) -> float:
    """The tip's free way over what the obstacles of the scene leave of it, 1 where they leave all.
    What a load moves is a share of the way that is left: a tip held after 0.2 mm of 20 feels a
    sideways push of 0.2 mm, though freely it would be 1 %."""
    scene, free = forecast.scene, forecast.travel
    found = [o for o in (scene.plate, scene.cylinder) if o is not None]
    distances = [obstacle_distances(forecast, obstacle) for obstacle in found]
    if not any(d is not None and d.min() < 0.0 for d in distances):
        return 1.0
    left = _pressed_way(forecast)
    if left is None:
        left = min(way_up_to(forecast, d) for d in distances if d is not None)
    return max(free / left, 1.0) if left > 0.0 else math.inf


def _pressed_way(forecast: Forecast) -> float | None:
    """Farthest that the tip comes [m] along the path of a rod that presses against the obstacles;
    None where it finds no equilibrium."""
    pressures = np.linspace(0.0, forecast.pressure, STATIONS + 1)
    row = forecast.row
    path = follow_scene(forecast.design, row, row.free, pressures, forecast.scene)
    if len(path.positions) < len(pressures):
        return None
    rest = [forecast.design.length, 0.0, 0.0]
    return float(np.linalg.norm(path.positions[:, -1] - rest, axis=1).max())


def way_up_to(forecast: Forecast, distances: np.ndarray) -> float:
    """Farthest that the tip of the free rod comes [m] before it enters an obstacle, whose distances
    (k + 1,) are those of :func:`obstacle_distances`."""
    if forecast.path is None or distances.min() >= 0.0:
        return forecast.travel
    first = int(np.argmax(distances < 0.0))
    if first == 0:
        return 0.0
    rest = np.zeros_like(forecast.path[:1])
    tips = np.array([
        shape(np.ascontiguousarray(strain), forecast.rod.length)[0][-1]
        for strain in (*rest, *forecast.path[:first])
    ])  # fmt: skip
    ways = np.linalg.norm(tips - tips[0], axis=1)
    before, after = distances[first - 1], distances[first]
    entered = ways[first - 1] + before / (before - after) * (ways[first] - ways[first - 1])
    return float(max(entered, ways[:first].max()))


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
