"""FElupe on a mesh of ours: triquadratic displacement, pressure and volume ratio as fields.

FElupe is under the GPL: it is neither imported by nor shipped with the studio. Install it by hand
(``pip install felupe``) to compare.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from actuators.export.vtu import NODE_ORDER
from actuators.materials import Material
from actuators.meshing import HexMesh


class FelupeProblem:
    """Three fields (displacement, pressure, volume ratio), follower pressure, weight; MKL Pardiso
    solves, as it does for us."""

    def __init__(
        self, mesh: HexMesh, materials: Sequence[Material], gravity: tuple[float, float, float]
    ) -> None:
        import felupe as fe

        self._fe, self._mesh, self._materials = fe, mesh, materials
        cells = mesh.elements[:, NODE_ORDER].astype(int)
        self.mesh = fe.Mesh(mesh.nodes, cells, "hexahedron27")
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
            "clamp": fe.Boundary(self.field[0], mask=_mask(mesh.clamp_nodes, mesh)),
            "symmetry": fe.Boundary(
                self.field[0], mask=_mask(mesh.symmetry_nodes, mesh), skip=(True, False, True)
            ),
        }
        self._held = fe.dof.partition(self.field, held)
        self._boundaries = held

    def _weights(self, density: np.ndarray, gravity: np.ndarray) -> Any:
        """Weight as dead nodal forces: constant, since it acts per undeformed volume."""
        fe = self._fe
        region = self.field.region
        share = np.einsum("aqc,qc,c->ac", np.broadcast_to(
            region.h, (27, *region.dV.shape)), region.dV, density)  # fmt: skip
        nodal = np.zeros(len(self._mesh.nodes))
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
                x0=self.field, items=[self._solid, self._pressure, self._weight],
                dof0=free[0], dof1=free[1], ext0=fe.dof.apply(
                    self.field, self._boundaries, free[0]), solver=spsolve, tol=tolerance,
                verbose=False, maxiter=20,
            )  # fmt: skip
            iterations += result.iterations
        return iterations

    def displacement(self, node: int) -> np.ndarray:
        """Displacement [m] of a mesh node."""
        return self.field[0].values[node].copy()

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


def _mask(nodes: np.ndarray, mesh: HexMesh) -> np.ndarray:
    mask = np.zeros(len(mesh.nodes), dtype=bool)
    mask[nodes] = True
    return mask
