"""NGSolve on a mesh of ours: the same element, law and loads, by an independent code.

For meshes of boxes parallel to the axes, where its mapping and ours agree.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from actuators.materials import Material
from actuators.meshing import HexMesh

_CORNERS = (0, 2, 8, 6, 18, 20, 26, 24)


def convert(mesh: HexMesh) -> Any:
    """NGSolve mesh with the regions as materials and boundaries clamp, symmetry, cavity, outer."""
    import netgen.meshing as ng
    import ngsolve

    out = ng.Mesh(dim=3)
    numbers: dict[int, Any] = {}
    for node in np.unique(mesh.elements[:, _CORNERS]):
        numbers[int(node)] = out.Add(ng.MeshPoint(ng.Pnt(*map(float, mesh.nodes[node]))))
    for element, region in zip(mesh.elements, mesh.region, strict=True):
        corners = [numbers[int(n)] for n in element[list(_CORNERS)]]
        out.Add(ng.Element3D(int(region) + 1, corners))
    for index, name in enumerate(_NAMES, 1):
        out.Add(ng.FaceDescriptor(surfnr=index, domin=1, domout=0, bc=index))
        out.SetBCName(index - 1, name)
    clamped = set(map(int, mesh.clamp_nodes))
    for name, faces in (
        ("cavity", mesh.cavity_faces), ("outer", mesh.outer_faces),
        ("symmetry", mesh.symmetry_faces),
    ):  # fmt: skip
        for nodes in faces.nodes:
            corners = [int(nodes[k]) for k in (0, 2, 8, 6)]
            label = "clamp" if name == "outer" and set(corners) <= clamped else name
            index = _NAMES.index(label) + 1
            out.Add(ng.Element2D(index, [numbers[c] for c in corners]))
    for region in mesh.regions:
        out.SetMaterial(mesh.regions.index(region) + 1, region.name)
    return ngsolve.Mesh(out)


_NAMES = ("clamp", "symmetry", "cavity", "outer")


class NgsolveProblem:
    """Q2 displacement, linear discontinuous pressure, follower pressure, gravity."""

    def __init__(
        self, mesh: HexMesh, materials: Sequence[Material], gravity: tuple[float, float, float]
    ) -> None:
        import ngsolve as ns

        self._ns = ns
        self.mesh = convert(mesh)
        self._names = [region.name for region in mesh.regions]
        displacement = ns.VectorH1(self.mesh, order=2, dirichlet="clamp", dirichlety="symmetry")
        constant = ns.L2(self.mesh, order=0)
        self.space = displacement * constant * constant * constant * constant
        self.load, self.pressure = ns.Parameter(0.0), ns.Parameter(0.0)
        self.form = self._form(materials, gravity, constant)
        self.solution = ns.GridFunction(self.space)

    def _form(
        self, materials: Sequence[Material], gravity: tuple[float, float, float], constant: Any
    ) -> Any:
        ns = self._ns
        u, *parts = self.space.TrialFunction()
        # pressure 1, x, y, z about each element's centre: the span of our local coordinates
        centre = [ns.GridFunction(constant) for _ in range(3)]
        for c, coordinate in zip(centre, (ns.x, ns.y, ns.z), strict=True):
            c.Set(coordinate)
        local = [
            1.0, *((x - c) * 1e3 for x, c in zip((ns.x, ns.y, ns.z), centre, strict=True))
        ]  # fmt: skip
        q = sum(n * part for n, part in zip(local, parts, strict=True))
        mu, kappa, density = (
            self.mesh.MaterialCF(
                {name: getattr(m, of) for name, m in zip(self._names, materials, strict=True)}
            )
            for of in ("shear_modulus", "bulk_modulus", "density")
        )
        f = ns.Id(3) + ns.Grad(u)
        j = ns.Det(f)
        energy = (
            mu / 2 * (j ** (-2 / 3) * ns.InnerProduct(f, f) - 3)
            + q * (j - 1)
            - q * q / (2 * kappa)
            - self.load * density * ns.InnerProduct(ns.CF(gravity), u)
        )
        surface = ns.Id(3) + ns.Grad(u).Trace()
        normal = ns.specialcf.normal(3)
        at = ns.CF((ns.x, ns.y, ns.z)) + u
        volume = -1 / 3 * ns.InnerProduct(at, ns.Cof(surface) * normal)
        form = ns.BilinearForm(self.space, symmetric=True)
        form += ns.Variation(energy.Compile() * ns.dx)
        form += ns.Variation((-self.pressure * volume).Compile() * ns.ds("cavity"))
        return form

    def raise_load(self, pressure: float, steps: int, tolerance: float = 1e-8) -> int:
        """Raise pressure and gravity together; returns the Newton iterations."""
        ns = self._ns
        iterations = 0
        before: Any = None
        for step in range(1, steps + 1):
            self.load.Set(step / steps)
            self.pressure.Set(pressure * step / steps)
            here = self.solution.vec.CreateVector(copy=True)
            if before is not None:
                self.solution.vec.data += here - before
            before = here
            iterations += self._newton(tolerance, ns)
        return iterations

    def _newton(self, tolerance: float, ns: Any) -> int:
        residual = self.solution.vec.CreateVector()
        step = self.solution.vec.CreateVector()
        for iteration in range(1, 31):
            self.form.Apply(self.solution.vec, residual)
            self.form.AssembleLinearization(self.solution.vec)
            inverse = self.form.mat.Inverse(self.space.FreeDofs(), inverse="sparsecholesky")
            step.data = inverse * residual
            self.solution.vec.data -= step
            moved = self.solution.components[0].vec.CreateVector()
            moved.data = step[: len(moved)]
            if not np.isfinite(moved.FV().NumPy()).all():
                break
            if max(abs(moved.FV().NumPy())) < tolerance * 0.08:
                return iteration
        raise RuntimeError("NGSolve's Newton iteration did not converge")

    def displacement(self, point: tuple[float, float, float]) -> np.ndarray:
        """Displacement [m] at an undeformed point."""
        return np.array(self.solution.components[0](self.mesh(*point)))

    @property
    def unknowns(self) -> int:
        """Free unknowns, pressures and inner nodes included."""
        return sum(self.space.FreeDofs())
