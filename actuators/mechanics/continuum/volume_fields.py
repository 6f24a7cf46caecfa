"""Fields in the whole rubber, node by node; a half model is completed by its mirror image."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from actuators.mechanics.continuum.newton import Equilibrium
from actuators.mechanics.continuum.surface_fields import StrainRecovery
from actuators.mechanics.continuum.system import ContinuumSystem

_MIRROR = np.array([1.0, -1.0, 1.0])
_MIRROR_STRESS = np.array([1.0, 1.0, 1.0, -1.0, -1.0, 1.0])
_MIRRORED = np.array(
    [i + 3 * (2 - j) + 9 * k for k in range(3) for j in range(3) for i in range(3)]
)
"""Local nodes of an element in its mirror image, which must stay right-handed."""


@dataclass(frozen=True, eq=False)
class VolumeMesh:
    """``nodes`` (n, 3) [m]; ``elements`` (m, 27), local node i + 3 j + 9 k; ``region`` (m,)."""

    nodes: np.ndarray
    elements: np.ndarray
    region: np.ndarray


@dataclass(frozen=True, eq=False)
class VolumeState:
    """One path point: cavity ``pressure`` [Pa]; ``displacement`` (n, 3) [m]; ``stretches`` (n, 3)
    principal, largest first; ``stress`` (n, 6) Cauchy [Pa] as 11, 22, 33, 12, 23, 13;
    ``contact_pressure`` (n,) [Pa], None where nothing can touch.

    Strains and stresses are averages of the elements that meet at a node, of both materials where
    two meet.
    """

    pressure: float
    displacement: np.ndarray
    stretches: np.ndarray
    stress: np.ndarray
    contact_pressure: np.ndarray | None


class VolumeFields:
    """Fields of a system's equilibria."""

    def __init__(self, system: ContinuumSystem) -> None:
        self._system, self._recovery = system, StrainRecovery(system)
        mesh = system.mesh
        self._off_plane = np.empty(0, dtype=np.int64)
        nodes, elements, region = mesh.nodes, mesh.elements, mesh.region
        if mesh.is_half:
            self._off_plane = np.flatnonzero(mesh.node_index[:, 1] > 0)
            twin = np.arange(len(nodes))
            twin[self._off_plane] = len(nodes) + np.arange(len(self._off_plane))
            elements = np.concatenate([elements, twin[elements][:, _MIRRORED]])
            region = np.tile(region, 2)
        self.mesh = VolumeMesh(self._whole(nodes, _MIRROR), elements, region)

    def states(self, found: Sequence[Equilibrium]) -> Iterator[VolumeState]:
        """Fields of each state, made one by one."""
        for one in found:
            stretches, stress = self._recovery.tensors(one.state)
            yield VolumeState(
                one.pressure,
                self._whole(one.state.displacement, _MIRROR),
                # extrapolation and averages may cross where two are nearly equal
                self._whole(np.sort(self._recovery.at_nodes(stretches), axis=1)[:, ::-1]),
                self._whole(self._recovery.at_nodes(stress), _MIRROR_STRESS),
                self._contact(one),
            )

    def _contact(self, one: Equilibrium) -> np.ndarray | None:
        interactions = self._system.interactions
        if not interactions:
            return None
        positions = self._system.mesh.nodes + one.state.displacement
        each = [i.contact_pressure(positions) for i in interactions]
        return self._whole(np.sum(each, axis=0))

    def _whole(self, values: np.ndarray, mirror: np.ndarray | float = 1.0) -> np.ndarray:
        return np.concatenate([values, values[self._off_plane] * mirror])
