"""Forces of embedded sheets as unknowns of their own.

A stiff sheet that turns is stretched by the straight step of Newton's method, and a force that
followed at once from that stretch would stop it. So the force N at every Gauss point of a sheet is
an unknown, found from area (lambda - 1 - N/K) = 0 in the same linear system as the displacements
and eliminated before the solver sees it, like the pressures of an element.
"""

from dataclasses import dataclass

import numpy as np

from actuators.mechanics.continuum.kernel.membrane import SHEET_POINTS
from actuators.meshing import Faces, HexMesh, prolong_pressure
from actuators.quantities import kilopascals


@dataclass(frozen=True, eq=False)
class Sheets:
    """Sheets of a mesh, sorted by element. ``start``: (m + 1,) where each element's begin;
    ``element``, ``local``: (f,), ``nodes``: (f, 9); ``stiffness``: (f,) [N/m].

    Of the tangent last filled: ``area`` (f, 6) [m2], ``gradient`` (f, 6, 9, 3) = dlambda/du [1/m].
    """

    start: np.ndarray
    element: np.ndarray
    local: np.ndarray
    nodes: np.ndarray
    stiffness: np.ndarray
    area: np.ndarray
    gradient: np.ndarray

    def __len__(self) -> int:
        return len(self.element)

    @property
    def no_force(self) -> np.ndarray:
        """N = 0, (f, 6) [N/m]."""
        return np.zeros((len(self), SHEET_POINTS))

    def condensed(self, gap: np.ndarray) -> np.ndarray:
        """Nodal forces (f, 9, 3) [N] that stand for ``gap`` (f, 6) = lambda - 1 - N/K."""
        force = self.stiffness[:, None] * self.area * gap
        return np.einsum("fg,fgni->fni", force, self.gradient)

    def correction(self, displacement: np.ndarray, gap: np.ndarray) -> np.ndarray:
        """Change of N (f, 6) [N/m] with a change of ``displacement`` (n, 3)."""
        stretched = np.einsum("fgni,fni->fg", self.gradient, displacement[self.nodes])
        return self.stiffness[:, None] * (gap + stretched)


def sheets_of(mesh: HexMesh) -> Sheets:
    """The sheets of a mesh, before any tangent."""
    faces = mesh.membrane_faces
    start, order = by_element(faces, len(mesh.elements))
    count = len(order)
    return Sheets(
        start, faces.element[order].astype(np.int64), faces.local[order].astype(np.int64),
        faces.nodes[order].reshape(count, 9).astype(np.int64),
        np.ascontiguousarray(mesh.membrane_stiffness[order], dtype=float),
        np.zeros((count, SHEET_POINTS)), np.zeros((count, SHEET_POINTS, 9, 3)),
    )  # fmt: skip


def wrinkle_note(pressure: float) -> str:
    """What a reader must know of states from ``pressure`` [Pa] on that only flat sheets hold."""
    return (
        f"From {kilopascals(pressure, 3)} kPa on the embedded layer is pressed together so hard in "
        "places that without any stiffness against bending it would wrinkle in waves as short as "
        "the mesh allows. It is taken to stay flat, as a layer of some thickness does."
    )


def by_element(faces: Faces, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Where the faces of each of ``count`` elements begin, once sorted, and the sorting order."""
    order = np.argsort(faces.element, kind="stable")
    per_element = np.bincount(faces.element, minlength=count)
    return np.concatenate([[0], np.cumsum(per_element)]).astype(np.int64), order


def prolong_sheet_force(coarse: HexMesh, fine: HexMesh, force: np.ndarray) -> np.ndarray:
    """N (f, 6) of a coarse mesh's sheets on a finer mesh: the mean over each coarse face."""
    old, new = sheets_of(coarse), sheets_of(fine)
    spread = new.no_force
    if len(force) == 0:
        return spread
    for side in np.unique(old.local):
        mean = np.zeros((len(coarse.elements), 4))
        mine = old.local == side
        mean[old.element[mine], 0] = force[mine].mean(axis=1)
        theirs = new.local == side
        spread[theirs] = prolong_pressure(coarse, fine, mean)[new.element[theirs], :1]
    return spread
