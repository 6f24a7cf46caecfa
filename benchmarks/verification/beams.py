"""Slender beams in plane strain: the elastica, and the block bent to a full circle."""

from collections.abc import Sequence

import numpy as np
import scipy.optimize
import scipy.special

from actuators.materials import NeoHooke
from actuators.mechanics.continuum.newton import Target
from actuators.mechanics.continuum.system import ContinuumSystem, State
from actuators.meshing import mesh_body
from benchmarks.verification.statics import (
    dead_load,
    ramp,
    rubber,
    simpson_weights,
    solid_block,
    solved,
    solver_of,
)


def elastica_tip(load: float) -> tuple[float, float]:
    """v/L across and u/L back along the undeformed beam at P L^2 / EI = ``load``."""
    root = np.sqrt(load)

    def modulus(slope: float) -> tuple[float, float]:
        m = (1 + np.sin(slope)) / 2
        return m, float(np.arcsin(1 / np.sqrt(2 * m)))

    def excess(slope: float) -> float:
        m, first = modulus(slope)
        return float(scipy.special.ellipk(m) - scipy.special.ellipkinc(first, m) - root)

    slope = scipy.optimize.brentq(excess, 1e-9, np.pi / 2 - 1e-9)
    m, first = modulus(slope)
    arc = scipy.special.ellipe(m) - scipy.special.ellipeinc(first, m)
    return float(1 - 2 * arc / root), float(1 - np.sqrt(2 * np.sin(slope)) / root)


def bent_cantilever(
    loads: Sequence[float], slenderness: float, parts: tuple[int, int]
) -> list[tuple[float, float]]:
    """v/L and u/L of the tip at each P L^2 / EI (increasing), EI = mu h^3 / 3 per width.

    ``slenderness`` = L/h. The clamped section is free to become thinner, the tip's load spreads as
    in shear.
    """
    height, width, mu = 1.0 / slenderness, 1.0 / slenderness, 1.0
    mesh = mesh_body(solid_block((1.0, width, height)), uniform=(parts[0], 1, parts[1]))
    middle = len(mesh.lines[2]) - 1
    free = np.ones_like(mesh.nodes, dtype=bool)
    free[:, 1] = False
    free[mesh.clamp_nodes, 0] = False
    free[mesh.clamp_nodes[mesh.node_index[mesh.clamp_nodes, 2] == middle], 2] = False
    end = mesh.tip_nodes
    across = simpson_weights(mesh.node_index[end, 1], mesh.lines[1])
    # a parabola over the height; exact for one element, and for more up to its interpolation
    z = mesh.nodes[end, 2] / height
    shear = across * simpson_weights(mesh.node_index[end, 2], mesh.lines[2]) * z * (1 - z)
    forces = np.zeros_like(mesh.nodes)
    forces[end, 2] = -shear / shear.sum() * mu * height**3 / 3 * width
    system = ContinuumSystem(mesh, [rubber(NeoHooke(mu))], free=free, outer_loads=dead_load(forces))
    steps = np.unique([*np.arange(0.5, max(loads), 0.5), *loads])
    states = dict(zip(map(float, steps), ramp(system, solver_of(system), list(steps)), strict=True))
    tip = end[(mesh.node_index[end, 2] == middle) & (mesh.node_index[end, 1] == 0)][0]
    at = [states[float(p)].displacement[tip] for p in loads]
    return [(float(-u[2]), float(-u[0])) for u in at]


class Flexure:
    """Block of length ``length`` and unit height bent to a sector, neo-Hooke (Rivlin 1949).

    Angle c X1, radius r with c (r^2 - r1^2) / 2 the height from the inner side; circumferential
    stretch l = c r. The sides being free, l1 l2 = 1.
    """

    def __init__(self, turn: float, length: float) -> None:
        self.rate = turn / length
        half = np.sqrt(self.rate**2 + 1)
        self.inner, self.outer = (np.sqrt(half + s * self.rate) for s in (-1, 1))

    @property
    def moment(self) -> float:
        """Per width and over mu."""
        side = (self.inner**2 + self.inner**-2 - 2) / 2

        def primitive(a: float) -> float:
            return 3 * a**4 / 8 - np.log(a) / 2 - (1 + side) * a**2 / 2

        return float((primitive(self.outer) - primitive(self.inner)) / self.rate**2)

    def place(self, x: np.ndarray, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Positions of points (x, z); the axis is at (0, -r1), the inner side z = 0."""
        radius = np.sqrt((self.inner / self.rate) ** 2 + 2 * z / self.rate)
        return radius * np.sin(self.rate * x), radius * np.cos(self.rate * x)


def bent_to_circle(length: float, parts: tuple[int, int]) -> tuple[float, float]:
    """Moment over mu and per width, and inner stretch at the free section, of half a ring.

    The far section is carried to its place at half a turn; the near one stays in its plane, free to
    slide and to become thinner.
    """
    mesh = mesh_body(solid_block((length / 2, 0.5, 1.0)), uniform=(parts[0], 1, parts[1]))
    free = np.ones_like(mesh.nodes, dtype=bool)
    free[:, 1] = False
    free[mesh.clamp_nodes, 0] = False
    far = mesh.tip_nodes
    free[far] = False
    system = ContinuumSystem(mesh, [rubber(NeoHooke(1.0))], free=free)
    flexure = Flexure(2 * np.pi, length)
    axis = -flexure.inner / flexure.rate
    x, z = flexure.place(mesh.nodes[:, 0], mesh.nodes[:, 2])
    # the axis stays on X1 = 0; the iteration starts from the closed form
    moved = np.stack([x, mesh.nodes[:, 1], z + axis], axis=1)
    start = State(moved - mesh.nodes, system.rest().pressure)
    state = solved(system, solver_of(system), start, Target(0.0)).state
    force = system.balance(state, 0.0).residual[far]
    at = (mesh.nodes + state.displacement)[far]
    moment = float(((at[:, 2] - axis) * force[:, 0] - at[:, 0] * force[:, 2]).sum() / 0.5)
    inner = mesh.clamp_nodes[mesh.node_index[mesh.clamp_nodes, 2] == 0][0]
    radius = mesh.nodes[inner, 2] + state.displacement[inner, 2] - axis
    return abs(moment), float(radius * flexure.rate)
