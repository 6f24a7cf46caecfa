"""Displacement, largest principal stretch and Cauchy stress on the surface, for viewers.

Strains are taken at the 2 x 2 x 2 Gauss points, where a quadratic element is most accurate,
extrapolated to the nodes and averaged over the elements that meet there.
"""

from collections.abc import Sequence

import numpy as np

from actuators.mechanics.continuum.kernel.shape import cube_shape, gauss_cube
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.mechanics.response import SurfaceFields
from actuators.meshing import HexMesh

_POINTS, _ = gauss_cube(2)
_, _SLOPES = cube_shape(_POINTS)
_PRESSURE = np.concatenate([np.ones((8, 1)), _POINTS], axis=1)
# trilinear extrapolation (27, 8) from the Gauss points to the nodes
_NODE_POINTS = np.stack(
    np.meshgrid([-1.0, 0.0, 1.0], [-1.0, 0.0, 1.0], [-1.0, 0.0, 1.0], indexing="ij")[::-1], axis=-1
).reshape(27, 3)
_EXTRAPOLATE = np.prod(1 + 3 * _NODE_POINTS[:, None, :] * _POINTS[None, :, :], axis=-1) / 8


class StrainRecovery:
    """Principal stretch and stress of one system's states."""

    def __init__(self, system: ContinuumSystem) -> None:
        self._system = system
        mesh = system.mesh
        at = mesh.nodes[mesh.elements]
        jacobian = np.einsum("mni,gdn->mgid", at, _SLOPES)
        self._gradients = np.einsum("mgdi,gdn->mgin", np.linalg.inv(jacobian), _SLOPES)
        self._share = np.bincount(mesh.elements.ravel(), minlength=len(mesh.nodes))

    def at_points(self, state: State) -> tuple[np.ndarray, np.ndarray]:
        """Largest principal stretch and Cauchy stress [Pa] at the Gauss points, (m, 8) each."""
        f = self._deformation(state)
        stretch, stress = self._principal(state, np.linalg.eigvalsh(f @ np.swapaxes(f, -1, -2)))
        return stretch.max(axis=-1), stress.max(axis=-1)

    def tensors(self, state: State) -> tuple[np.ndarray, np.ndarray]:
        """Principal stretches, largest first, (m, 8, 3), and the Cauchy stress [Pa] (m, 8, 6) as
        11, 22, 33, 12, 23, 13, at the Gauss points."""
        f = self._deformation(state)
        square, axes = np.linalg.eigh(f @ np.swapaxes(f, -1, -2))
        stretch, principal = self._principal(state, square)
        stress = np.einsum("...ia,...a,...ja->...ij", axes, principal, axes)
        return stretch[..., ::-1], stress[..., [0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]]

    def _deformation(self, state: State) -> np.ndarray:
        at = state.displacement[self._system.mesh.elements]
        return np.einsum("mni,mgjn->mgij", at, self._gradients) + np.eye(3)

    def _principal(self, state: State, square: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Principal stretches and Cauchy stresses [Pa] from their squares (m, 8, 3)."""
        log = 0.5 * np.log(np.maximum(square, 1e-30))
        volume = log.sum(axis=-1, keepdims=True)
        stress = np.repeat((state.pressure @ _PRESSURE.T)[..., None], 3, axis=-1)
        for number, material in enumerate(self._system.materials):
            own = self._system.mesh.region == number
            slope = material.law.logarithmic_slope(log[own] - volume[own] / 3)
            slope -= slope.mean(axis=-1, keepdims=True)
            stress[own] += slope / np.exp(volume[own])
        return np.exp(log), stress

    def at_nodes(self, values: np.ndarray) -> np.ndarray:
        """(m, 8) or (m, 8, c) values at Gauss points to (n,) or (n, c) at nodes."""
        mesh = self._system.mesh
        if values.ndim == 3:
            return np.stack([self.at_nodes(v) for v in np.moveaxis(values, -1, 0)], axis=-1)
        spread = values @ _EXTRAPOLATE.T
        total = np.bincount(mesh.elements.ravel(), spread.ravel(), minlength=len(mesh.nodes))
        return total / self._share


def surface_fields(
    system: ContinuumSystem,
    states: Sequence[State],
    recovery: StrainRecovery,
    at_points: Sequence[tuple[np.ndarray, np.ndarray]],
) -> SurfaceFields:
    """Fields of all states on the outside and in the cavity; a half model is completed.
    ``at_points``: stretch and stress of each state, as ``recovery`` gives them."""
    mesh = system.mesh
    nodes, triangles = _surface(mesh)
    displacement = np.array([s.displacement[nodes] for s in states]).reshape(-1, len(nodes), 3)
    stretch, stress = np.empty((2, len(states), len(nodes)))
    for row, (point_stretch, point_stress) in enumerate(at_points):
        stretch[row] = np.maximum(recovery.at_nodes(point_stretch)[nodes], 1.0)
        stress[row] = recovery.at_nodes(point_stress)[nodes]
    contact = _contact_pressure(system, states, nodes)
    vertices = mesh.nodes[nodes]
    if mesh.is_half:
        off_plane = np.flatnonzero(mesh.node_index[nodes, 1] > 0)
        twin = np.arange(len(nodes))
        twin[off_plane] = len(nodes) + np.arange(len(off_plane))
        mirror = np.array([1.0, -1.0, 1.0])
        vertices = np.concatenate([vertices, vertices[off_plane] * mirror])
        displacement = np.concatenate([displacement, displacement[:, off_plane] * mirror], axis=1)
        stretch = np.concatenate([stretch, stretch[:, off_plane]], axis=1)
        stress = np.concatenate([stress, stress[:, off_plane]], axis=1)
        if contact is not None:
            contact = np.concatenate([contact, contact[:, off_plane]], axis=1)
        triangles = np.concatenate([triangles, twin[triangles][:, ::-1]])
    return SurfaceFields(
        vertices=vertices.astype(np.float32),
        triangles=triangles.astype(np.int32),
        displacement=displacement.astype(np.float32),
        stretch=stretch.astype(np.float32),
        stress=stress.astype(np.float32),
        contact_pressure=None if contact is None else contact.astype(np.float32),
    )


def _contact_pressure(
    system: ContinuumSystem, states: Sequence[State], nodes: np.ndarray
) -> np.ndarray | None:
    """(k, n) at ``nodes`` [Pa]; None where nothing can touch."""
    if not system.interactions or not states:
        return None
    at = [system.mesh.nodes + state.displacement for state in states]
    pressed = [sum(i.contact_pressure(x)[nodes] for i in system.interactions) for x in at]
    return np.array(pressed)


def _surface(mesh: HexMesh) -> tuple[np.ndarray, np.ndarray]:
    """Surface nodes, and triangles (outward from the rubber) among them: eight a face."""
    faces = np.concatenate([mesh.outer_faces.nodes, mesh.cavity_faces.nodes])
    corner = [a + 3 * b for b in range(2) for a in range(2)]
    pattern = np.array([[c, c + 1, c + 4] for c in corner] + [[c, c + 4, c + 3] for c in corner])
    nodes, triangles = np.unique(faces[:, pattern].reshape(-1, 3), return_inverse=True)
    return nodes, triangles.reshape(-1, 3)
