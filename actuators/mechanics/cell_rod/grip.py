"""What the clamp does to a wide body: one linear solve of the whole, compared with its own rod.

Across the width the clamp forbids what bending does inside, and the chambers beside it answer
less. In the linear body under an end moment M, an end force F or pressure, the line of the
underside at the walls between chambers is that of the rod, with the cell's compliance C and free
curvature, up to a shift and a turn, read off by least squares:

    end moment M     z = z_0 - theta_0 x - C M x^2/2,          theta_0 = a M
    pressure         the same with its own curvature, theta_0 and z_0

The turn a M is a length a/C by which the rod begins later (a < 0). The force's tip displacement
exceeds C L^3/3 + a L^2 + C_s L (C_s: shear of the cell) by 2 b L: what the clamp turns by a force,
and is shifted by a moment. All of it is geometry: nothing is fitted to a path or an experiment.
"""

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

from actuators.design import Design, SlabDesign
from actuators.geometry import build_body, build_cell
from actuators.materials import material
from actuators.mechanics.cell.cache import cell_response
from actuators.mechanics.cell.kept import Kept
from actuators.mechanics.cell.row import chamber_row, pitch_starts
from actuators.mechanics.cell.shear import shear_compliance
from actuators.mechanics.rod.pieces import layout_of

FEWEST = 3
"""Chambers that a body must have for its inside to be read off."""
BENDING = 2


@dataclass(frozen=True)
class Grip:
    """Per compliance C and free curvature of the cell beside the clamp. ``turn``: a/C beyond what
    the rod's own solid end and first pitch have [m]; ``shift``: b/C [m2]; ``pressed_turn``: theta_0
    beyond the rod's [m], ``pressed_shift``: z_0 [m2] and ``pressed_tip``: what the tip point lies
    above the line of the inside [m2], per free curvature."""

    turn: float
    shift: float
    pressed_turn: float
    pressed_shift: float
    pressed_tip: float


_grips: Kept[Grip] = Kept(128)


def grip_of(design: Design) -> Grip | None:
    """Of the clamped end; None where the body is so long and narrow, or has so few chambers, that
    there is nothing to gain."""
    if not isinstance(design, SlabDesign) or design.chamber_count < FEWEST:
        return None
    # a tapered body's clamp is that of a straight one as wide as it is there
    wide = 2 * float(design.half_width(0.0))
    straight = design.model_copy(update={"planform": "rectangle", "width": wide})
    return _grips.get(straight.digest, lambda: _solve(straight))


def forget_grips() -> None:
    """Empty the store (benchmarks time a new body with it)."""
    _grips.forget()


def _solve(design: SlabDesign) -> Grip:
    # the 3D solver's kernels: only where an answer needs them
    from actuators.mechanics.continuum.assembly import linear_system
    from actuators.mechanics.continuum.outer_loads import end_tractions
    from actuators.mechanics.direct_solver import open_solver
    from actuators.meshing import mesh_body

    mesh = mesh_body(build_body(design).half())
    system = linear_system(mesh)
    at = mesh.nodes[system.nodes]
    held = np.zeros((len(at), 3), dtype=bool)
    held[at[:, 0] < 1e-9] = True
    held[np.abs(at[:, 1]) < 1e-9, 1] = True
    free = np.flatnonzero(~held.ravel())
    matrix = sp.csr_matrix(sp.triu(system.stiffness[free][:, free]))
    matrix.sort_indices()
    solver = open_solver(matrix.indptr, matrix.indices)
    solver.factorize(matrix.data)
    force, moment = (t[system.nodes].ravel() / 2 for t in end_tractions(mesh))
    loads = np.stack([system.pressure_load, moment, force], axis=1)[free]
    motion = np.zeros((3 * len(mesh.nodes), 3))
    rows = (3 * system.nodes[:, None] + np.arange(3)).ravel()[free]
    motion[rows] = solver.solve(loads)
    line = mesh.underside_line
    x, z = mesh.nodes[line, 0], motion.reshape(-1, 3, 3)[line, 2]
    return _read(design, x, z)


def _read(design: SlabDesign, x: np.ndarray, z: np.ndarray) -> Grip:
    """From heights ``z`` (k, 3) of the underside's line at ``x`` (k,) under pressure 1 Pa, moment 1
    (towards the underside) and force 1 (up)."""
    body = build_cell(design, 0)
    cell, materials = cell_response(body), tuple(material(r.material) for r in body.regions)
    bent = float(np.linalg.inv(cell.stiffness)[BENDING, BENDING])
    pressed = float(cell.free[BENDING])
    # as coarse as the body's own mesh, whose shear is to be told from its clamp
    sheared = shear_compliance(body, materials, graded=False)
    walls = pitch_starts(design)[0][1:]
    inside = np.array([np.abs(x - wall).argmin() for wall in walls])
    length = design.length
    (from_pressure, from_moment) = (
        np.polyfit(x[inside], z[inside, load] + curvature * x[inside] ** 2 / 2, 1) / curvature
        for load, curvature in ((0, pressed), (1, bent))
    )
    turn = float(-from_moment[0])
    rod = bent * length**3 / 3 + turn * bent * length**2 + sheared * length
    line = np.polyval(from_pressure, length) - length**2 / 2
    layout = layout_of(design, chamber_row(design))
    before = layout.stations[np.flatnonzero(layout.chamber == 0)[0]]
    cut = (layout.whole - 1)[layout.chamber == 0] @ layout.length[layout.chamber == 0]
    solid = layout.stations[:-1] < before - 1e-12
    ends = np.linalg.inv(layout.solid[solid])[:, BENDING, BENDING] @ layout.length[solid]
    return Grip(
        turn=turn - float(ends / bent - before + cut),
        shift=float((z[-1, 2] - rod) / (2 * length) / bent),
        pressed_turn=float(-from_pressure[0] + before - cut),
        pressed_shift=float(from_pressure[1]),
        pressed_tip=float(z[-1, 0] / pressed - line),
    )
