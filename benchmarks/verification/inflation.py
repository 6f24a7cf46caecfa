"""Spheres and cylinders under inner pressure; incompressible, Mooney-Rivlin (neo-Hooke: c2 = 0).

With the stretch l(r) of the circumference, l_b^n - 1 = (l_a^n - 1) (A/B)^n (n = 3 for the sphere, 2
for the cylinder in plane strain) between inner radius A and outer radius B, and What(l) the energy
of the deformation (l, l, l^-2) or (l, 1/l, 1), p is the integral from l_b to l_a of
What'(l) / (l^n - 1). For the thin balloon p R / h tends to What'(l) / l^2.
"""

from collections.abc import Sequence

import numpy as np
import scipy.integrate
import scipy.optimize

from actuators.geometry import CAVITY, Body, Region
from actuators.materials import MooneyRivlin, NeoHooke
from actuators.mechanics.continuum.newton import Target
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.meshing import HexMesh, mesh_body
from benchmarks.verification.statics import rubber, solved, solver_of

Parts = tuple[int, int, int]


def sphere_pressure(stretch: float, ratio: float, c1: float, c2: float = 0.0) -> float:
    """p at this inner stretch; ``ratio`` = A/B."""

    def slope(a: float) -> float:
        return 4 * (c1 * (a - a**-5) + c2 * (a**3 - a**-3)) / (a**3 - 1)

    outer = (1 + (stretch**3 - 1) * ratio**3) ** (1 / 3)
    return float(scipy.integrate.quad(slope, outer, stretch, epsabs=0, epsrel=1e-12)[0])


def sphere_limit(
    ratio: float, c1: float, c2: float = 0.0, *, between: tuple[float, float] = (1.05, 2.5),
    minimum: bool = False,
) -> tuple[float, float]:  # fmt: skip
    """Inner stretch and pressure at the maximum (or minimum) of the closed form."""
    sign = 1.0 if minimum else -1.0
    found = scipy.optimize.minimize_scalar(
        lambda a: sign * sphere_pressure(a, ratio, c1, c2), bounds=between, method="bounded",
        options={"xatol": 1e-9},
    )  # fmt: skip
    return float(found.x), sphere_pressure(float(found.x), ratio, c1, c2)


def cylinder_pressure(stretch: float, ratio: float, mu: float) -> float:
    """p = mu (ln(la/lb) + (lb^-2 - la^-2)/2)."""
    outer = np.sqrt(1 + (stretch**2 - 1) * ratio**2)
    return float(mu * (np.log(stretch / outer) + (outer**-2 - stretch**-2) / 2))


def octant(ratio: float) -> Body:
    """Eighth of a hollow sphere of outer radius 1: its planes pass through the origin, so that the
    cavity's volume needs no caps."""

    def place(lattice: np.ndarray) -> np.ndarray:
        polar, around, r = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
        return np.stack(
            [r * np.sin(polar) * np.cos(around), r * np.sin(polar) * np.sin(around),
             r * np.cos(polar)], axis=-1,
        )  # fmt: skip

    quarter = np.array([0.0, np.pi / 2])
    return Body(
        (quarter, quarter, np.array([0.0, ratio, 1.0])), np.array([[[CAVITY, 0]]], dtype=np.int8),
        (Region("rubber", "test"),), place, False,
    )  # fmt: skip


def symmetric(mesh: HexMesh) -> np.ndarray:
    """``free`` (n, 3): nothing moves across the coordinate planes."""
    return np.abs(mesh.nodes) > 1e-12


def inflated_sphere(
    ratio: float,
    c1: float,
    c2: float,
    stretches: Sequence[float],
    parts: Parts,
    *,
    step: float = 0.1,
) -> list[float]:
    """Pressure at each inner stretch (increasing), the cavity's volume being prescribed."""
    mesh = mesh_body(octant(ratio), uniform=(parts[0], parts[1], (1, parts[2])))
    law = MooneyRivlin(c1, c2) if c2 else NeoHooke(2 * c1)
    system = ContinuumSystem(mesh, [rubber(law)], free=symmetric(mesh))
    solver = solver_of(system)
    volume, _ = system.volume(system.rest())
    radius = np.linalg.norm(mesh.nodes, axis=1)
    state, pressure, found_at = system.rest(), 0.0, dict[float, float]()
    for stretch in np.unique([*np.arange(1.0 + step, max(stretches), step), *stretches]):
        # from the incompressible field at this stretch, so that no element is crushed
        grown = np.cbrt(radius**3 + ratio**3 * (stretch**3 - 1)) / radius
        start = State(mesh.nodes * (grown[:, None] - 1), state.pressure)
        target = Target(pressure, volume=volume * stretch**3)
        found = solved(system, solver, start, target)
        state, pressure = found.state, found.pressure
        found_at[float(stretch)] = pressure
    return [found_at[float(stretch)] for stretch in stretches]


def found_extreme(
    ratio: float, c1: float, c2: float, near: float, parts: Parts, *, step: float = 0.1
) -> tuple[float, float]:
    """Inner stretch and pressure where the computed curve is level, from five points around
    ``near``."""
    around = near + 0.03 * np.arange(-2, 3)
    pressures = inflated_sphere(ratio, c1, c2, list(around), parts, step=step)
    curve = np.polynomial.Polynomial.fit(around, pressures, 4)
    level = [r.real for r in curve.deriv().roots() if abs(r.imag) < 1e-9]
    at = min(level, key=lambda r: abs(r - near))
    return float(at), float(curve(at))


def inflated_cylinder(
    ratio: float, mu: float, stretches: Sequence[float], parts: tuple[int, int]
) -> list[float]:
    """Pressure at each inner stretch in plane strain: the inner surface is moved outwards, the
    pressure is the work of what holds it over the volume swept. ``parts``: around, through
    the wall."""

    def place(lattice: np.ndarray) -> np.ndarray:
        r, z, around = np.moveaxis(np.asarray(lattice, dtype=float), -1, 0)
        return np.stack([r * np.cos(around), -z, r * np.sin(around)], axis=-1)

    body = Body(
        (np.array([ratio, 1.0]), np.array([0.0, 0.2]), np.array([0.0, np.pi / 2])),
        np.zeros((1, 1, 1), dtype=np.int8), (Region("rubber", "test"),), place, False,
    )  # fmt: skip
    mesh = mesh_body(body, uniform=(parts[1], 1, parts[0]))
    free = symmetric(mesh)
    free[:, 1] = False
    inner = mesh.on_first_plane(0)
    free[inner] = False
    system = ContinuumSystem(mesh, [rubber(NeoHooke(mu))], free=free)
    solver = solver_of(system)
    radius = np.linalg.norm(mesh.nodes[:, [0, 2]], axis=1)
    state, pressures = system.rest(), []
    for stretch in stretches:
        grown = np.sqrt(radius**2 + ratio**2 * (stretch**2 - 1)) / radius
        moved = mesh.nodes * np.stack([grown, np.ones_like(grown), grown], axis=1)
        state = State(moved - mesh.nodes, state.pressure)
        state = solved(system, solver, state, Target(0.0)).state
        force = system.balance(state, 0.0).residual[inner]
        work = (force * mesh.nodes[inner])[
            :, [0, 2]
        ].sum() / ratio  # per radial displacement, towards the axis
        pressures.append(float(-work / (0.2 * np.pi / 2 * ratio * stretch)))
    return pressures
