"""Cook's membrane by NGSolve: triangles of high order, small at the corners.

python -m benchmarks.verification.ngsolve_cook
"""

from typing import Any

import ngsolve as ns
from netgen.geom2d import SplineGeometry

from benchmarks.verification.cook import BULK, SHEAR, TRACTION


def triangles(largest: float, corner: float) -> Any:
    geometry = SplineGeometry()
    points = [geometry.AppendPoint(x, y, corner) for x, y in ((0, 0), (48, 44), (48, 60), (0, 44))]
    for number, name in enumerate(("bottom", "right", "top", "left")):
        geometry.Append(["line", points[number], points[(number + 1) % 4]], bc=name)
    return ns.Mesh(geometry.GenerateMesh(maxh=largest))


def linear_corner(mesh: Any, order: int, youngs: float = 70.0, poisson: float = 1 / 3) -> float:
    space = ns.VectorH1(mesh, order=order, dirichlet="left")
    u, v = space.TnT()
    mu = youngs / 2 / (1 + poisson)
    lame = youngs * poisson / (1 + poisson) / (1 - 2 * poisson)

    def strain(w: Any) -> Any:
        return 0.5 * (ns.Grad(w) + ns.Grad(w).trans)

    form = ns.BilinearForm(space, symmetric=True)
    form += (2 * mu * ns.InnerProduct(strain(u), strain(v)) + lame * ns.div(u) * ns.div(v)) * ns.dx
    load = ns.LinearForm(space)
    load += TRACTION * v[1] * ns.ds("right")
    form.Assemble()
    load.Assemble()
    found = ns.GridFunction(space)
    found.vec.data = form.mat.Inverse(space.FreeDofs(), inverse="sparsecholesky") * load.vec
    return float(found(mesh(48, 60))[1])


def neo_hooke_corner(mesh: Any, order: int, steps: int = 8) -> float:
    """Displacement and continuous pressure (Taylor-Hood), plane strain."""
    displacement = ns.VectorH1(mesh, order=order, dirichlet="left")
    space = displacement * ns.H1(mesh, order=order - 1)
    (u, q), _ = space.TnT()
    share = ns.Parameter(0.0)
    f = ns.Id(2) + ns.Grad(u)
    j = ns.Det(f)
    energy = SHEAR / 2 * (j ** (-2 / 3) * (ns.InnerProduct(f, f) + 1) - 3)
    energy += q * (j - 1) - q * q / (2 * BULK)
    form = ns.BilinearForm(space, symmetric=True)
    form += ns.Variation(energy * ns.dx)
    form += ns.Variation(-share * TRACTION * u[1] * ns.ds("right"))
    found = ns.GridFunction(space)
    residual, step = found.vec.CreateVector(), found.vec.CreateVector()
    for number in range(1, steps + 1):
        share.Set(number / steps)
        for _ in range(20):
            form.Apply(found.vec, residual)
            form.AssembleLinearization(found.vec)
            step.data = form.mat.Inverse(space.FreeDofs(), inverse="umfpack") * residual
            found.vec.data -= step
            if max(abs(step[: displacement.ndof].FV().NumPy())) < 1e-9:
                break
    return float(found.components[0](mesh(48, 60))[1])


def main() -> None:
    for largest, corner, order in ((8, 1, 3), (6, 0.2, 4), (5, 0.02, 4)):
        mesh = triangles(largest, corner)
        print(f"{mesh.ne} triangles of order {order}: linear {linear_corner(mesh, order):.4f} mm, "
              f"neo-Hooke {neo_hooke_corner(mesh, order):.4f} mm", flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
