"""Shapes of a rod over a list of pressures."""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.rod.equilibrium import Law, follow, shape
from actuators.mechanics.rod.pieces import Rod


@dataclass(frozen=True, eq=False)
class RodPath:
    """Shapes at the first k of the pressures asked for, all of them unless equilibrium was lost.

    ``strains``: (k, s, 4); ``positions``: (k, s + 1, 3) [m]; ``frames``: (k, s + 1, 3, 3), columns
    are the section's directions; ``iterations``: Newton iterations together.
    """

    strains: np.ndarray
    positions: np.ndarray
    frames: np.ndarray
    iterations: int


def follow_pressures(
    rod: Rod, pressures: np.ndarray, gravity: tuple[float, float, float] | None
) -> RodPath:
    """Shapes at ``pressures`` (k,) [Pa], under ``gravity`` [m/s2] or weightless."""
    pull = np.zeros(3) if gravity is None else np.array(gravity, dtype=float)
    size = float(np.linalg.norm(pull))
    direction = pull / size if size > 0 else np.array([0.0, 0.0, -1.0])
    compliance = rod.compliance
    lean = np.einsum("sab,sb->sa", rod.bending, compliance[:, 1:, 0])
    law = Law(
        rod.length, compliance, rod.bending, lean, rod.mass * size, rod.mass_height, direction
    )
    strains, positions, frames, found, iterations = follow(
        np.ascontiguousarray(pressures, dtype=float), rod.free, law
    )
    return RodPath(strains[:found], positions[:found], frames[:found], iterations)


def end_turn(frames: np.ndarray, bend: np.ndarray | None = None) -> np.ndarray:
    """Turn of the free end about X2 (k,) [rad], positive towards -X3, from frames (k, s + 1, 3, 3):
    the angle of the section's X1 in the X1-X3 plane, followed along the rod so that full turns
    count. ``bend``: (k, s) what each piece bends about X2 [rad], where that may be half a turn and
    more: two frames alone do not tell how often the rod has gone round between them."""
    along = np.arctan2(-frames[..., 2, 0], frames[..., 0, 0])
    if bend is None or np.abs(bend).max(initial=0.0) < np.pi:
        return np.unwrap(along, axis=-1)[..., -1]
    piece = np.diff(along, axis=-1)
    piece += 2 * np.pi * np.round((bend - piece) / (2 * np.pi))
    return along[..., 0] + piece.sum(axis=-1)


def weightless(strains: np.ndarray, length: np.ndarray) -> RodPath:
    """Shapes with given strains (k, s, 4) on pieces of ``length`` (s,) [m]."""
    shapes = [shape(e, length) for e in strains]
    positions = np.array([x[::2] for x, _ in shapes])
    return RodPath(strains, positions, np.array([r[::2] for _, r in shapes]), 0)
