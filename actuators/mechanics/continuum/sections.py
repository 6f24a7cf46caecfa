"""The deformed body seen as a rod: section frames, centreline, curvature, tip.

A section is a plane x' = const of the mesh. Its rotation is the best fit (Kabsch) of a rigid
rotation to the nodes of the bottom layer in that plane: the layer that stays closest to a rod's
section.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from actuators.mechanics.continuum.system import State
from actuators.mechanics.response import Centreline
from actuators.meshing import HexMesh

BOTTOM_REGION = 0


@dataclass(frozen=True, eq=False)
class RodShape:
    """k states. ``centreline``; ``tip_rotation`` (k,) about X2, unwrapped along the rod [rad];
    ``curvature`` and ``torsion`` (k,) means over the whole length [1/m]."""

    centreline: Centreline
    tip_rotation: np.ndarray
    curvature: np.ndarray
    torsion: np.ndarray


def rod_shape(mesh: HexMesh, states: Sequence[State]) -> RodShape:
    """Rod quantities of every state; for no states, arrays of length zero."""
    line = mesh.underside_line
    stations = mesh.nodes[line, 0]
    displacement = np.array([s.displacement for s in states]).reshape(-1, len(mesh.nodes), 3)
    frames = section_frames(mesh, displacement)
    normal = frames[..., 0]
    angle = np.unwrap(np.arctan2(-normal[..., 2], normal[..., 0]), axis=1)
    turn = _rotation_vectors(np.swapaxes(frames[:, :-1], -1, -2) @ frames[:, 1:]).sum(axis=1)
    length = stations[-1] - stations[0]
    return RodShape(
        Centreline(stations, mesh.nodes[line] + displacement[:, line], frames),
        tip_rotation=angle[:, -1] - angle[:, 0],
        curvature=turn[:, 1] / length,
        torsion=turn[:, 0] / length,
    )


def section_frames(mesh: HexMesh, displacement: np.ndarray) -> np.ndarray:
    """(k, s, 3, 3) rotation of each section under displacements (k, n, 3)."""
    nodes = np.unique(mesh.elements[mesh.region == BOTTOM_REGION])
    station = mesh.node_index[nodes, 0]
    count = int(station.max()) + 1
    before = mesh.nodes[nodes]
    after = before + displacement[:, nodes]
    weight = _lumped(mesh, nodes)
    if mesh.is_half:  # the other half, mirrored
        mirror = np.array([1.0, -1.0, 1.0])
        before, after = (
            np.concatenate([before, before * mirror]),
            np.concatenate([after, after * mirror], axis=1),
        )
        station, weight = np.tile(station, 2), np.tile(weight, 2)
    membership = np.zeros((count, len(station)))
    membership[station, np.arange(len(station))] = weight
    membership /= membership.sum(axis=1, keepdims=True)
    spread_before = before - (membership @ before)[station]
    spread_after = after - (membership @ after)[:, station]
    outer = spread_after[..., :, None] * spread_before[:, None, :]
    moment = np.einsum("sn,knij->ksij", membership, outer)
    u, _, vt = np.linalg.svd(moment)
    flip = np.linalg.det(u @ vt)
    u[..., :, 2] *= np.where(flip < 0, -1.0, 1.0)[..., None]
    return u @ vt


def _lumped(mesh: HexMesh, nodes: np.ndarray) -> np.ndarray:
    """Share of the section's area that each node stands for (up to a factor)."""
    share = np.ones(len(nodes))
    for d in (1, 2):
        line = mesh.lines[d]
        with_middles = np.empty(2 * len(line) - 1)
        with_middles[::2], with_middles[1::2] = line, (line[:-1] + line[1:]) / 2
        width = np.gradient(with_middles)
        share *= width[mesh.node_index[nodes, d]]
    return share


def _rotation_vectors(rotation: np.ndarray) -> np.ndarray:
    """Rotation vectors (..., 3) of matrices (..., 3, 3), for angles below pi."""
    axial = np.stack(
        [
            rotation[..., 2, 1] - rotation[..., 1, 2],
            rotation[..., 0, 2] - rotation[..., 2, 0],
            rotation[..., 1, 0] - rotation[..., 0, 1],
        ],
        axis=-1,
    )
    sine = np.linalg.norm(axial, axis=-1) / 2
    cosine = (np.trace(rotation, axis1=-2, axis2=-1) - 1) / 2
    angle = np.arctan2(sine, cosine)
    return axial / 2 * np.where(sine > 1e-12, angle / np.maximum(sine, 1e-12), 1.0)[..., None]
