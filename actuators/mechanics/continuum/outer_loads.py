"""Loads on the outside of a body: pressure on its underside, a dead force on its free end.

The pressure follows the deformed surface and acts on an open one: its residual is exact, its
tangent lacks the skew part that such a load has along the surface's rim, so that one symmetric
factorisation serves. At the pressures of weather and water that costs an iteration, no accuracy.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from actuators.mechanics.continuum.kernel.cavity import face_traction
from actuators.mechanics.continuum.kernel.shape import (
    SQUARE_SLOPES,
    SQUARE_VALUES,
    SQUARE_WEIGHTS,
)
from actuators.mechanics.scene import Scene
from actuators.meshing import HexMesh

_LEVI_CIVITA = np.zeros((3, 3, 3))
for _i, _j, _k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
    _LEVI_CIVITA[_i, _j, _k], _LEVI_CIVITA[_j, _i, _k] = 1.0, -1.0


@dataclass(frozen=True, eq=False)
class OuterLoads:
    """``force``: (n, 3) dead forces [N]; ``pressure`` [Pa] pushes against the outward normal of
    ``faces`` (f, 9)."""

    force: np.ndarray
    faces: np.ndarray
    pressure: float

    def add_residual(self, positions: np.ndarray, share: float, residual: np.ndarray) -> None:
        """Add what this share of the loads lacks in balance to ``residual`` (n, 3)."""
        residual -= share * self.force
        if self.pressure != 0.0:
            traction = np.zeros_like(residual)
            face_traction(positions, self.faces, traction)
            residual += share * self.pressure * traction

    def tangent(self, positions: np.ndarray, share: float) -> np.ndarray:
        """(f, 9, 3, 9, 3) symmetric part of the residual's derivative on every face."""
        patch = positions[self.faces]
        along, across = np.einsum("gdn,fni->dfgi", SQUARE_SLOPES, patch)
        # d(along x across)_i / dx_bj = levi_civita_ijm turned_bm
        turned = np.einsum("gb,fgm->fgbm", SQUARE_SLOPES[:, 0], across)
        turned -= np.einsum("gb,fgm->fgbm", SQUARE_SLOPES[:, 1], along)
        moment = np.einsum("g,ga,fgbm->fabm", SQUARE_WEIGHTS, SQUARE_VALUES, turned)
        skew = share * self.pressure / 2 * (moment - np.swapaxes(moment, 1, 2))
        return np.einsum("ijm,fabm->faibj", _LEVI_CIVITA, skew)

    @cached_property
    def works(self) -> bool:
        """Whether there is any load at all."""
        return self.pressure != 0.0 or bool(self.force.any())


def outer_loads(mesh: HexMesh, scene: Scene) -> OuterLoads | None:
    """Loads of a scene on a mesh; half a model bears half of the tip's force."""
    if scene.tip_force is None and scene.outside_pressure == 0.0:
        return None
    force = np.zeros_like(mesh.nodes)
    if scene.tip_force is not None:
        share = _area_shares(mesh, end_faces(mesh)) * (0.5 if mesh.is_half else 1.0)
        force = np.outer(share, scene.tip_force)
    return OuterLoads(force, underside_faces(mesh), scene.outside_pressure)


def end_tractions(mesh: HexMesh) -> tuple[np.ndarray, np.ndarray]:
    """Nodal forces (n, 3) of a unit force along X3 spread over the free end, and of a unit moment
    about X2 (towards the underside) as a traction linear in the height; of a half model, of which
    these are the whole body's."""
    faces = end_faces(mesh)
    patch = mesh.nodes[faces]
    along, across = np.einsum("gdn,fni->dfgi", SQUARE_SLOPES, patch)
    area = np.linalg.norm(np.cross(along, across), axis=-1) * SQUARE_WEIGHTS
    height = np.einsum("gn,fn->fg", SQUARE_VALUES, patch[..., 2])
    height = height - (area * height).sum() / area.sum()
    force, moment = np.zeros_like(mesh.nodes), np.zeros_like(mesh.nodes)
    np.add.at(force[:, 2], faces, np.einsum("fg,gn->fn", area / area.sum(), SQUARE_VALUES))
    lever = area * height / (area * height**2).sum()
    np.add.at(moment[:, 0], faces, np.einsum("fg,gn->fn", lever, SQUARE_VALUES))
    return force, moment


def end_faces(mesh: HexMesh) -> np.ndarray:
    """(f, 9) nodes of the free end's faces."""
    faces, last = mesh.outer_faces, len(mesh.lines[0]) - 2
    return faces.nodes[(faces.local == 1) & (mesh.box[faces.element, 0] == last)]


def underside_faces(mesh: HexMesh) -> np.ndarray:
    """(f, 9) nodes of the faces on the bottom plane."""
    faces = mesh.outer_faces
    return faces.nodes[(faces.local == 4) & (mesh.box[faces.element, 2] == 0)]


def _area_shares(mesh: HexMesh, faces: np.ndarray) -> np.ndarray:
    """(n,) share of each node in the faces' undeformed area: the consistent weights of a dead
    force spread evenly over it."""
    along, across = np.einsum("gdn,fni->dfgi", SQUARE_SLOPES, mesh.nodes[faces])
    area = np.linalg.norm(np.cross(along, across), axis=-1) * SQUARE_WEIGHTS
    shares = np.zeros(len(mesh.nodes))
    np.add.at(shares, faces, np.einsum("fg,gn->fn", area, SQUARE_VALUES))
    return shares / area.sum()


@dataclass(frozen=True, eq=False)
class FacePlaces:
    """Where the entries of faces' matrices go in the values of an upper triangle."""

    entry: np.ndarray
    place: np.ndarray

    def add(self, matrices: np.ndarray, values: np.ndarray) -> None:
        """Add (f, 9, 3, 9, 3) matrices."""
        np.add.at(values, self.place, matrices.ravel()[self.entry])


def face_places(
    faces: np.ndarray, dof: np.ndarray, indptr: np.ndarray, indices: np.ndarray
) -> FacePlaces:
    """Places of faces (f, 9) in a pattern with sorted columns that holds them all."""
    unknowns = dof[faces].reshape(len(faces), 27)
    row = np.repeat(unknowns[:, :, None], 27, axis=2).ravel()
    column = np.repeat(unknowns[:, None, :], 27, axis=1).ravel()
    entry = np.flatnonzero((row >= 0) & (column >= row))
    size = len(indptr) - 1
    key = np.repeat(np.arange(size, dtype=np.int64), np.diff(indptr)) * size + indices
    place = np.searchsorted(key, row[entry].astype(np.int64) * size + column[entry])
    return FacePlaces(entry, place)
