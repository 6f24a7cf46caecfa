"""Shapes of a rod to the points of a path, as every rung reports them."""

import numpy as np

from actuators.mechanics.response import Centreline, PathPoint
from actuators.mechanics.rod.rotation import helix
from actuators.mechanics.rod.solve import RodPath, end_turn


def path_points(
    path: RodPath,
    length: np.ndarray,
    chambered: np.ndarray,
    pressures: np.ndarray,
    cavity_volume: np.ndarray | None,
) -> tuple[PathPoint, ...]:
    """Points of the path found. ``length``: (s,) pieces [m]; ``chambered``: (s,) which of them
    carry chambers; ``cavity_volume``: (k,) [m3] or None.

    Curvature and torsion are means over the whole undeformed length, as the 3D solver reports them;
    the helix is the one that the chambered pieces wind, end pieces left out, per stretched length.
    """
    tip = path.positions[:, -1]
    moved = tip - np.array([length.sum(), 0.0, 0.0])
    turn = end_turn(path.frames, path.strains[..., 2] * length)
    angle = np.arctan2(-tip[:, 2], tip[:, 0])
    mean = np.einsum("ksi,s->ki", path.strains, length) / length.sum()
    weight = length * chambered
    wound = np.einsum("ksi,s->ki", path.strains, weight) / weight.sum()
    stretched = np.maximum(1 + wound[:, 0], 1e-6)
    radius, pitch = helix(wound[:, 2] / stretched, wound[:, 1] / stretched)
    columns = (pressures, tip, moved, turn, angle, mean[:, 2], mean[:, 1], radius, pitch)
    rows = zip(*(column[: len(tip)].tolist() for column in columns), strict=True)
    volumes = [None] * len(tip) if cavity_volume is None else cavity_volume.tolist()
    return tuple(
        PathPoint(
            pressure=p,
            tip=tuple(x),
            tip_displacement=tuple(u),
            tip_rotation=t,
            bending_angle=a,
            curvature=k2,
            torsion=k1,
            helix_radius=r,
            helix_pitch=h,
            cavity_volume=v,
        )
        for (p, x, u, t, a, k2, k1, r, h), v in zip(rows, volumes, strict=False)
    )


def centreline(path: RodPath, length: np.ndarray) -> Centreline:
    """The rod's shapes with their stations, X1 of the undeformed rod."""
    stations = np.concatenate([[0.0], np.cumsum(length)])
    return Centreline(stations=stations, positions=path.positions, frames=path.frames)
