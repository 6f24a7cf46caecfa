"""How the drawn skin follows a rod.

Clamp and free end shift the line of the inside, which a rod has no room for: its laws hold the
shift within the first and the last piece (:mod:`actuators.mechanics.cell_rod.held`), some
millimetres long. Drawn like that a body near its limit pressure is folded at the clamp and ends in
a wedge. In 3D the shift comes gradually: of that of slab-triangle-low at 5 kPa, 9, 40, 74 and 88 %
are there 8, 16, 23 and 30 mm from the clamp. It is drawn as 1 - exp(-(x/h)^2/2) with the height h,
there 16 mm: 11, 38, 63 and 83 %.
"""

import numpy as np

from actuators.mechanics.response import Centreline

SHORTEST = 4
"""Of such heights a body must be long; the shift of a shorter one is drawn over less."""


def swept(points: np.ndarray, rod: Centreline, which: np.ndarray) -> np.ndarray:
    """Points (n, 3) [m] of the undeformed body carried along by the rod's sections, at the path
    points ``which`` (k,): (k, n, 3) [m]. Sections stay plane and keep their shape, as the rod's
    model has it."""
    stations = np.asarray(rod.stations, dtype=np.float64)
    x, back = np.unique(points[:, 0], return_inverse=True)
    right = np.clip(np.searchsorted(stations, x), 1, len(stations) - 1)
    left = right - 1
    # not clipped: an oblique body reaches a little beyond the last station
    t = (x - stations[left]) / (stations[right] - stations[left])
    positions = rod.positions[which].astype(np.float64)
    frames = rod.frames[which].astype(np.float64)
    positions = _eased(stations, positions, frames, float(np.ptp(points[:, 2])))
    weight = t[None, :, None]
    at = (1 - weight) * positions[:, left] + weight * positions[:, right]
    weight = np.clip(weight, 0.0, 1.0)[..., None]
    turn = _orthonormal((1 - weight) * frames[:, left] + weight * frames[:, right])
    section = points[:, 1:]
    moved = at[:, back]
    moved += turn[..., 1][:, back] * section[:, :1]
    moved += turn[..., 2][:, back] * section[:, 1:]
    return moved


def _eased(
    stations: np.ndarray, positions: np.ndarray, frames: np.ndarray, height: float
) -> np.ndarray:
    """The line (k, s, 3) with the shift of its first and last piece spread over about ``height``
    [m]. Both ends stay where they are."""
    if len(stations) < 4:
        return positions
    reach = min(height, (stations[-1] - stations[0]) / SHORTEST)
    missing = np.exp(-(((stations - stations[0]) / reach) ** 2) / 2)
    ahead = np.exp(-(((stations[-1] - stations) / reach) ** 2) / 2)
    missing[[0, -1]] = ahead[[0, -1]] = 0.0
    begin = _shift(stations, positions, frames, 0, 1)
    end = _shift(stations, positions, frames, -1, -2)
    return positions - missing[:, None] * begin[:, None] + ahead[:, None] * end[:, None]


def _shift(
    stations: np.ndarray, positions: np.ndarray, frames: np.ndarray, piece: int, beside: int
) -> np.ndarray:
    """By how much (k, 3) a piece moves across its section more than the one beside it does for
    its length."""
    length, step = np.diff(stations), np.diff(positions, axis=1)
    across = [
        np.einsum("ka,kab->kb", step[:, p], (frames[:, :-1] + frames[:, 1:])[:, p] / 2)[:, 1:]
        for p in (piece, beside)
    ]
    more = across[0] - across[1] * length[piece] / length[beside]
    return np.einsum("kab,kb->ka", frames[:, piece, :, 1:], more)


def _orthonormal(frames: np.ndarray) -> np.ndarray:
    """Columns 2 and 3 made orthonormal again after interpolation; (..., 3, 3)."""
    second = frames[..., 1] / np.linalg.norm(frames[..., 1], axis=-1, keepdims=True)
    third = frames[..., 2]
    third = third - (third * second).sum(axis=-1, keepdims=True) * second
    third = third / np.linalg.norm(third, axis=-1, keepdims=True)
    return np.stack([frames[..., 0], second, third], axis=-1)
