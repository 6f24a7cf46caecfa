"""Forces of rigid obstacles on the borders of a rod, with their derivatives (compiled).

The gap g pushes with a force that is linear beyond g = -2 softness and joins zero by a parabola at
g = 0: what only touches does not press.
"""

import math

import numba as nb
import numpy as np

from actuators.mechanics.rod.chain import Obstacles
from actuators.mechanics.rod.small import add_cross


@nb.njit(cache=True)
def gap(kind: int, place: np.ndarray, direction: np.ndarray, radius: float, at: np.ndarray,
        normal: np.ndarray) -> float:  # fmt: skip
    """Signed distance of a point, negative inside; its gradient goes into ``normal`` (3,)."""
    if kind == 0:
        total = 0.0
        for a in range(3):
            normal[a] = direction[a]
            total += direction[a] * (at[a] - place[a])
        return total
    along = 0.0
    for a in range(3):
        along += direction[a] * (at[a] - place[a])
    square = 0.0
    for a in range(3):
        normal[a] = at[a] - place[a] - along * direction[a]
        square += normal[a] * normal[a]
    distance = math.sqrt(square)
    if distance > 0.0:  # on the axis no direction leads out
        for a in range(3):
            normal[a] /= distance
    return distance - radius


@nb.njit(cache=True)
def push(depth: float, softness: float) -> tuple[float, float]:
    """Force per stiffness at the gap ``-depth`` [m], and its growth with the depth."""
    if depth <= 0.0:
        return 0.0, 0.0
    if depth >= 2 * softness:
        return depth - softness, 1.0
    return depth**2 / (4 * softness), depth / (2 * softness)


@nb.njit(cache=True)
def add_touch(
    border: int, x: np.ndarray, r: np.ndarray, obstacles: Obstacles, n: np.ndarray, m: np.ndarray
) -> None:
    """Add force and moment about the border's place ``x`` (3,) with frame ``r`` (3, 3)."""
    at, arm, normal, force = np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3)
    for j in range(obstacles.across.shape[1]):
        _place(border, j, x, r, obstacles, arm, at)
        for o in range(len(obstacles.kind)):
            g = gap(obstacles.kind[o], obstacles.place[o], obstacles.direction[o],
                    obstacles.radius[o], at, normal)  # fmt: skip
            size, _ = push(-g, obstacles.softness)
            if size > 0.0:
                size *= obstacles.stiffness * obstacles.share[border, j]
                for a in range(3):
                    force[a] = size * normal[a]
                    n[a] += force[a]
                add_cross(arm, force, 1.0, m)


@nb.njit(cache=True)
def add_touch_slope(
    border: int, x: np.ndarray, r: np.ndarray, obstacles: Obstacles, slope: np.ndarray
) -> None:
    """Add the derivative of :func:`add_touch`'s (force, moment) to (place, turn), (6, 6)."""
    at, arm, normal, force = np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3)
    to, out = np.zeros((3, 6)), np.zeros((3, 6))
    for j in range(obstacles.across.shape[1]):
        _place(border, j, x, r, obstacles, arm, at)
        for o in range(len(obstacles.kind)):
            direction = obstacles.direction[o]
            g = gap(obstacles.kind[o], obstacles.place[o], direction, obstacles.radius[o], at,
                    normal)  # fmt: skip
            size, growth = push(-g, obstacles.softness)
            if size <= 0.0:
                continue
            strong = obstacles.stiffness * obstacles.share[border, j]
            size, growth = size * strong, growth * strong
            distance = g + obstacles.radius[o]
            bent = size / distance if obstacles.kind[o] == 1 and distance > 0.0 else 0.0
            # the point moves with place and turn: dx - arm x dtheta
            to[:, :] = 0.0
            for a in range(3):
                to[a, a] = 1.0
            to[0, 4], to[0, 5], to[1, 5] = arm[2], -arm[1], arm[0]
            to[1, 3], to[2, 3], to[2, 4] = -arm[2], arm[1], -arm[0]
            for b in range(6):
                through, along = 0.0, 0.0
                for a in range(3):
                    through += normal[a] * to[a, b]
                    along += direction[a] * to[a, b]
                for a in range(3):
                    curved = to[a, b] - normal[a] * through - direction[a] * along
                    out[a, b] = -growth * normal[a] * through + bent * curved
            for a in range(3):
                force[a] = size * normal[a]
                for b in range(6):
                    slope[a, b] += out[a, b]
            for b in range(6):
                slope[3, b] += arm[1] * out[2, b] - arm[2] * out[1, b]
                slope[4, b] += arm[2] * out[0, b] - arm[0] * out[2, b]
                slope[5, b] += arm[0] * out[1, b] - arm[1] * out[0, b]
            # the arm itself turns: (theta x arm) x force = arm (theta . force) - theta (arm . f)
            dot = arm[0] * force[0] + arm[1] * force[1] + arm[2] * force[2]
            for a in range(3):
                for b in range(3):
                    slope[3 + a, 3 + b] += arm[a] * force[b]
                slope[3 + a, 3 + a] -= dot


@nb.njit(cache=True)
def _place(
    border: int, j: int, x: np.ndarray, r: np.ndarray, obstacles: Obstacles, arm: np.ndarray,
    at: np.ndarray,
) -> None:  # fmt: skip
    across, above = obstacles.across[border, j], obstacles.above[border, j]
    for a in range(3):
        arm[a] = r[a, 1] * across + r[a, 2] * above
        at[a] = x[a] + arm[a]


@nb.njit(cache=True)
def obstacle_forces(
    x: np.ndarray, r: np.ndarray, obstacles: Obstacles
) -> tuple[np.ndarray, np.ndarray]:
    """Forces (o, 3) of the rod on every obstacle [N], and the deepest penetration (o,) [m].
    ``x``: (s + 1, 3) borders; ``r``: (s + 1, 3, 3)."""
    count = len(obstacles.kind)
    forces, depth = np.zeros((count, 3)), np.zeros(count)
    at, arm, normal = np.zeros(3), np.zeros(3), np.zeros(3)
    for border in range(len(x)):
        for j in range(obstacles.across.shape[1]):
            _place(border, j, x[border], r[border], obstacles, arm, at)
            for o in range(count):
                g = gap(obstacles.kind[o], obstacles.place[o], obstacles.direction[o],
                        obstacles.radius[o], at, normal)  # fmt: skip
                size, _ = push(-g, obstacles.softness)
                size *= obstacles.stiffness * obstacles.share[border, j]
                for a in range(3):
                    forces[o, a] -= size * normal[a]
                if border > 0:
                    depth[o] = max(depth[o], -g)
    return forces, depth
