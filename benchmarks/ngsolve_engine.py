"""NGSolve on a mesh of ours: the same element, law and loads, by an independent code.

Its mesh is made of the boxes between our mesh lines; where these are not the body itself, it is
deformed by the quadratic map that carries our nodes, so that both programs map alike.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from actuators.materials import Material
from actuators.mechanics.continuum.contact import ContactLaw
from actuators.mechanics.continuum.contact.points import OBSTACLE_POINTS
from actuators.mechanics.obstacles import Plate
from actuators.meshing import HexMesh

_CORNERS = (0, 2, 8, 6, 18, 20, 26, 24)


def convert(mesh: HexMesh) -> Any:
    """NGSolve mesh with the regions as materials and boundaries clamp, symmetry, cavity, outer."""
    import netgen.meshing as ng
    import ngsolve

    out = ng.Mesh(dim=3)
    numbers: dict[int, Any] = {}
    at = _boxes(mesh)
    for node in np.unique(mesh.elements[:, _CORNERS]):
        numbers[int(node)] = out.Add(ng.MeshPoint(ng.Pnt(*map(float, at[node]))))
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


def _boxes(mesh: HexMesh) -> np.ndarray:
    """(n, 3) places of the nodes [m] before the map: the body's own where its elements are boxes,
    else those on the mesh lines, stretched to about the body's size."""
    size = float(np.ptp(mesh.nodes, axis=0).max())
    found = mesh.nodes[mesh.elements]
    low, high = found[:, :1], found[:, 26:]
    if np.allclose(found, low + (high - low) * _LOCAL, atol=1e-9 * size):
        return mesh.nodes
    places = np.empty_like(mesh.nodes)
    for d, lines in enumerate(mesh.lines):
        both = np.empty(2 * len(lines) - 1)
        both[::2], both[1::2] = lines, (lines[1:] + lines[:-1]) / 2
        places[:, d] = both[mesh.node_index[:, d]] * size / np.ptp(lines)
    return places


_LOCAL = np.array([[n % 3, n // 3 % 3, n // 9] for n in range(27)]) / 2


def _deform(mesh: Any, ours: HexMesh) -> Any:
    """Deformation of NGSolve's mesh of boxes that puts every node of ours in its place."""
    import ngsolve as ns

    space = ns.VectorH1(mesh, order=2)
    scalar, start = space.components[0], space.ndof // 3
    moved = ns.GridFunction(space)
    away = ours.nodes - _boxes(ours)
    values = np.zeros((3, start))
    for element, nodes in zip(mesh.Elements(ns.VOL), ours.elements, strict=True):
        shapes = scalar.GetFE(ns.ElementId(element))
        matrix = np.array([np.array(shapes.CalcShape(*point)) for point in _LOCAL.tolist()])
        dofs = list(scalar.GetDofNrs(ns.ElementId(element)))
        values[:, dofs] = np.linalg.solve(matrix, away[nodes]).T
    moved.vec.FV().NumPy()[:] = values.ravel()
    return moved


def contact_energy(gap: Any, law: ContactLaw) -> Any:
    """Energy of contact per undeformed area [J/m2] at ``gap`` [m], a number or a coefficient: that
    of equation (29) of the theory."""
    import ngsolve as ns

    stiffness, onset = law.stiffness, law.onset
    soft = stiffness * (onset - gap) ** 3 / (12 * onset)
    hard = stiffness * (gap * gap / 2 + onset**2 / 6)
    return ns.IfPos(gap - onset, 0.0, ns.IfPos(gap + onset, soft, hard))


class NgsolveProblem:
    """Q2 displacement, linear discontinuous pressure, follower pressure, gravity, and a rigid plate
    (``plate`` with its law of contact pressure) on the same points of every outer face as ours."""

    def __init__(
        self,
        mesh: HexMesh,
        materials: Sequence[Material],
        gravity: tuple[float, float, float],
        plate: tuple[Plate, ContactLaw] | None = None,
    ) -> None:
        import ngsolve as ns

        self._ns = ns
        self._plate = plate
        self._lowest = float((mesh.nodes @ np.array(plate[0].normal)).min()) if plate else 0.0
        self.mesh = convert(mesh)
        self._before = ns.GridFunction(ns.VectorH1(self.mesh, order=1))
        self._before.Set(ns.CF((ns.x, ns.y, ns.z)))
        if _boxes(mesh) is not mesh.nodes:
            self._deformation = _deform(self.mesh, mesh)
            self.mesh.SetDeformation(self._deformation)
        self._vertices = np.unique(mesh.elements[:, _CORNERS])
        self._size = float(np.ptp(mesh.nodes, axis=0).max())
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
        for d, c in enumerate(centre):
            c.Set(self._before[d])
        local = [1.0, *((self._before[d] - c) * 1e3 for d, c in enumerate(centre))]
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
        if self._plate is not None:
            rule = self._contact_rule()
            form += ns.Variation(self._pressed(u).Compile() * ns.ds("outer", intrules=rule))
        return form

    def _contact_rule(self) -> dict[Any, Any]:
        """Our points of contact, on the square from 0 to 1."""
        places = [tuple(place) for place in (OBSTACLE_POINTS.local + 1) / 2]
        weights = (OBSTACLE_POINTS.weights / 4).tolist()
        return {self._ns.ET.QUAD: self._ns.IntegrationRule(places, weights)}

    def _gap(self, u: Any) -> Any:
        """Distance from the plate [m], negative inside."""
        assert self._plate is not None
        plate, _ = self._plate
        at = self._ns.CF((self._ns.x, self._ns.y, self._ns.z)) + u
        return self._ns.InnerProduct(at, self._ns.CF(plate.normal)) - (self._lowest - plate.gap)

    def _pressed(self, u: Any) -> Any:
        """Energy of contact with the plate per undeformed area [J/m2]."""
        assert self._plate is not None
        return contact_energy(self._gap(u), self._plate[1])

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
            if max(abs(moved.FV().NumPy())) < tolerance * self._size:
                return iteration
        raise RuntimeError("NGSolve's Newton iteration did not converge")

    def displacement(self, node: int) -> np.ndarray:
        """Displacement [m] of a node of our mesh that is a corner of elements."""
        values = self.solution.components[0].vec.FV().NumPy().reshape(3, -1)
        return values[:, np.searchsorted(self._vertices, node)].copy()

    def plate_force(self) -> float | None:
        """Force of this mesh's part on the plate [N]; None without one."""
        if self._plate is None:
            return None
        ns, law = self._ns, self._plate[1]
        g = self._gap(self.solution.components[0])
        soft = law.stiffness * (law.onset - g) ** 2 / (4 * law.onset)
        hard = -law.stiffness * g
        pressure = ns.IfPos(g - law.onset, 0, ns.IfPos(g + law.onset, soft, hard))
        rule = self._contact_rule()
        return float(ns.Integrate(pressure * ns.ds("outer", intrules=rule), self.mesh))

    @property
    def unknowns(self) -> int:
        """Free unknowns, pressures and inner nodes included."""
        return sum(self.space.FreeDofs())
