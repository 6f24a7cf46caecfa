"""FElupe on a mesh of ours: triquadratic displacement, pressure and volume ratio as fields.

FElupe is under the GPL: it is neither imported by nor shipped with the studio. Install it by hand
(``pip install felupe``) to compare.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from actuators.export.vtu import NODE_ORDER
from actuators.materials import Material
from actuators.mechanics.continuum.contact import ContactLaw, outside
from actuators.mechanics.obstacles import Plate
from actuators.meshing import HexMesh


class FelupeProblem:
    """Three fields (displacement, pressure, volume ratio), follower pressure, weight; MKL Pardiso
    solves, as it does for us. A ``plate`` stops nodes, each with the stiffness of our law times its
    mean share of the area."""

    def __init__(
        self,
        mesh: HexMesh,
        materials: Sequence[Material],
        gravity: tuple[float, float, float],
        plate: tuple[Plate, ContactLaw] | None = None,
    ) -> None:
        import felupe as fe

        self._fe, self._mesh, self._materials = fe, mesh, materials
        cells = mesh.elements[:, NODE_ORDER].astype(int)
        points = mesh.nodes
        if plate is not None:
            points = np.vstack([points, [_on_plate(mesh, plate[0])]])
        self.mesh = fe.Mesh(points, cells, "hexahedron27")
        region = fe.RegionTriQuadraticHexahedron(self.mesh)
        self.field = fe.FieldsMixed(region, n=3)
        laws = [
            fe.NearlyIncompressible(fe.NeoHooke(mu=m.shear_modulus), bulk=m.bulk_modulus)
            for m in materials
        ]
        self._solid = fe.SolidBody(_ByRegion(laws, mesh.region), self.field)
        density = np.array([m.density for m in materials])[mesh.region]
        cavity = np.zeros(len(mesh.nodes), dtype=bool)
        cavity[mesh.cavity_faces.nodes] = True
        faces = fe.RegionTriQuadraticHexahedronBoundary(self.mesh, mask=np.flatnonzero(cavity))
        self._pressure = fe.SolidBodyPressure(fe.FieldContainer([fe.Field(faces, dim=3)]))
        self._weight = self._weights(density, np.array(gravity))
        held = {
            "clamp": fe.Boundary(self.field[0], mask=_mask(mesh.clamp_nodes, self.mesh.npoints)),
            "symmetry": fe.Boundary(
                self.field[0],
                mask=_mask(mesh.symmetry_nodes, self.mesh.npoints),
                skip=(True, False, True),
            ),
        }
        self._contact = []
        if plate is not None:
            fixed = np.array([len(mesh.nodes)])
            held["plate"] = fe.Boundary(self.field[0], mask=_mask(fixed, self.mesh.npoints))
            self._contact = [self._stop(*plate)]
        self._held = fe.dof.partition(self.field, held)
        self._boundaries = held

    def _stop(self, plate: Plate, law: ContactLaw) -> Any:
        surface = outside(self._mesh)
        nodes = np.unique(surface.faces)
        return self._fe.ContactRigidPlane(
            field=self.field, points=nodes, centerpoint=len(self._mesh.nodes),
            normal=list(plate.normal),
            multiplier=law.stiffness * float(surface.areas.sum()) / len(nodes),
        )  # fmt: skip

    def _weights(self, density: np.ndarray, gravity: np.ndarray) -> Any:
        """Weight as dead nodal forces: constant, since it acts per undeformed volume."""
        fe = self._fe
        region = self.field.region
        share = np.einsum("aqc,qc,c->ac", np.broadcast_to(
            region.h, (27, *region.dV.shape)), region.dV, density)  # fmt: skip
        nodal = np.zeros(self.mesh.npoints)
        np.add.at(nodal, self.mesh.cells.T, share)
        return fe.PointLoad(self.field, np.arange(len(nodal)), values=nodal[:, None] * gravity)

    def raise_load(self, pressure: float, steps: int, tolerance: float) -> int:
        """Raise pressure and weight together; returns Newton's iterations."""
        from pypardiso import spsolve

        fe = self._fe
        free = self._held
        whole = self._weight.values.copy()
        iterations, before = 0, None
        for step in range(1, steps + 1):
            share = step / steps
            self._weight.values[:] = share * whole
            self._pressure.results.pressure = share * pressure
            here = [f.values.copy() for f in self.field.fields]
            if before is not None:
                for f, now, then in zip(self.field.fields, here, before, strict=True):
                    f.values += now - then
            before = here
            result = fe.newtonraphson(
                x0=self.field, items=[self._solid, self._pressure, self._weight, *self._contact],
                dof0=free[0], dof1=free[1], ext0=fe.dof.apply(
                    self.field, self._boundaries, free[0]), solver=spsolve, tol=tolerance,
                verbose=False, maxiter=20,
            )  # fmt: skip
            iterations += result.iterations
        return iterations

    def displacement(self, node: int) -> np.ndarray:
        """Displacement [m] of a mesh node."""
        return self.field[0].values[node].copy()

    def plate_force(self) -> float | None:
        """Force of this mesh's part on the plate [N]; None without one."""
        if not self._contact:
            return None
        count = 3 * self.mesh.npoints
        nodal = self._contact[0].results.force.toarray()[:count].reshape(-1, 3)
        return float(np.linalg.norm(nodal[len(self._mesh.nodes)]))

    @property
    def unknowns(self) -> int:
        """Free unknowns, fields inside elements included."""
        return len(self._held[1])


class _ByRegion:
    """One law per region behind one door: FElupe's laws take numbers, not arrays over cells."""

    def __init__(self, laws: Sequence[Any], region: np.ndarray) -> None:
        self._laws, self._cells = laws, [np.flatnonzero(region == k) for k in range(len(laws))]
        self._count = len(region)
        self.x = laws[0].x

    def gradient(self, x: list[Any], **_: Any) -> list[Any]:
        return self._each("gradient", x)

    def hessian(self, x: list[Any], **_: Any) -> list[Any]:
        return self._each("hessian", x)

    def _each(self, what: str, x: list[Any]) -> list[Any]:
        parts = [
            getattr(law, what)([self._of(a, cells) for a in x])
            for law, cells in zip(self._laws, self._cells, strict=True)
        ]
        return [self._joined(values) for values in zip(*parts, strict=True)]

    def _of(self, a: Any, cells: np.ndarray) -> Any:
        over_cells = isinstance(a, np.ndarray) and a.ndim > 0 and a.shape[-1] == self._count
        return np.ascontiguousarray(a[..., cells]) if over_cells else a

    def _joined(self, values: Sequence[Any]) -> Any:
        if not isinstance(values[0], np.ndarray):
            return values[0]
        out = np.empty((*values[0].shape[:-1], self._count))
        for value, cells in zip(values, self._cells, strict=True):
            out[..., cells] = value
        return out


def _on_plate(mesh: HexMesh, plate: Plate) -> np.ndarray:
    """A point of the plate [m]."""
    normal = np.array(plate.normal)
    return normal * (float((mesh.nodes @ normal).min()) - plate.gap)


def _mask(nodes: np.ndarray, count: int) -> np.ndarray:
    mask = np.zeros(count, dtype=bool)
    mask[nodes] = True
    return mask
