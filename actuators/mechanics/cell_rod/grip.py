"""What the clamp does to a wide body: one linear solve of the whole, compared with its own rod.

Across the width the clamp forbids what bending does inside, and the chambers beside it answer
less; a body that widens behind a narrow clamp is not borne by all of its width at once. In the
linear body under a load spread over its underside, an end force or pressure, the line of the
underside at the walls between chambers is that of the rod with the cells' compliance C and free
curvature, up to a shift and a turn. Read off by least squares are,

    spread load      theta_0 = a M at the clamp
    pressure         theta_0 and z_0

The turn a M is a length a/C by which the rod begins later (a < 0). The end force's tip displacement
exceeds that of the rod with this turn by 2 b L: what the clamp turns by a force, and is shifted by
a moment. All of it is geometry: nothing is fitted to a path or an experiment.
"""

from dataclasses import dataclass

import numpy as np

from actuators.design import Design, SlabDesign
from actuators.geometry import build_body, build_cell
from actuators.materials import material
from actuators.mechanics.cell.kept import Kept
from actuators.mechanics.cell.row import ChamberRow, chamber_row, pitch_starts
from actuators.mechanics.cell.shear import shear_compliance
from actuators.mechanics.rod.pieces import layout_of

FEWEST = 3
"""Chambers that a body must have for its inside to be read off."""
NEAR = 1e-7
"""Of the length: as good as there."""
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
    return _grips.get(design.digest, lambda: _solve(design))


def forget_grips() -> None:
    """Empty the store (benchmarks time a new body with it)."""
    _grips.forget()


def _solve(design: SlabDesign) -> Grip:
    # the 3D solver's kernels: only where an answer needs them
    from actuators.mechanics.continuum.assembly import linear_system
    from actuators.mechanics.continuum.kernel.cavity import face_traction
    from actuators.mechanics.continuum.outer_loads import end_tractions, underside_faces
    from actuators.meshing import mesh_body

    mesh = mesh_body(build_body(design).half())
    system = linear_system(mesh)
    at = mesh.nodes[system.nodes]
    held = np.zeros((len(at), 3), dtype=bool)
    near = NEAR * design.length
    held[at[:, 0] < near] = True
    held[np.abs(at[:, 1]) < near, 1] = True
    force = end_tractions(mesh)[0] / 2
    spread = np.zeros_like(force)
    face_traction(mesh.nodes, underside_faces(mesh), spread)
    outer = [load[system.nodes].ravel() for load in (spread, force)]
    motion = np.zeros((len(mesh.nodes), 3, 3))
    motion[system.nodes] = system.motions(held, np.stack([system.pressure_load, *outer], axis=1))
    line = mesh.underside_line
    x, z = mesh.nodes[line, 0], motion[line, 2]
    return _read(design, x, z)


def _read(design: SlabDesign, x: np.ndarray, z: np.ndarray) -> Grip:
    """From heights ``z`` (k, 3) of the underside's line at ``x`` (k,) under pressure 1 Pa, a load
    of 1 Pa spread over the underside (down) and force 1 at the end (up)."""
    row = chamber_row(design)
    bent = float(np.linalg.inv(row.stiffness[0])[BENDING, BENDING])
    pressed = float(row.free[0, BENDING])
    walls = pitch_starts(design)[0][1:]
    inside = np.array([np.abs(x - wall).argmin() for wall in walls])
    length = design.length
    own = _own_heights(design, row, np.append(x[inside], length))
    beyond = z[np.append(inside, -1)] - own
    stations = layout_of(design, row).stations
    moment = _spread(design, stations)[1][0]
    from_pressure = np.polyfit(x[inside], beyond[:-1, 0], 1) / pressed
    turn = -np.polyfit(x[inside], beyond[:-1, 1], 1)[0] / (bent * moment)
    return Grip(
        turn=float(turn),
        shift=float((beyond[-1, 2] / bent - turn * length**2) / (2 * length)),
        pressed_turn=float(-from_pressure[0]),
        pressed_shift=float(from_pressure[1]),
        pressed_tip=float(beyond[-1, 0] / pressed - np.polyval(from_pressure, length)),
    )


def _own_heights(design: SlabDesign, row: ChamberRow, at: np.ndarray) -> np.ndarray:
    """Heights (k, 3) of the rod with the cells' linear law at ``at`` (k,), under the same loads."""
    layout = layout_of(design, row)
    bent = np.linalg.inv(layout.stiffness(row.stiffness))[:, BENDING, BENDING]
    begin, half = layout.stations[:-1], layout.length / 2
    free = layout.free(row.free)[:, BENDING]
    # a force up turns against the bending's sign
    force, moment = (value for value in _spread(design, begin + half))
    curvature = np.stack([free, bent * moment, -bent * (design.length - begin - half)], axis=-1)
    turn = np.cumsum(curvature * layout.length[:, None], axis=0)
    before = turn - curvature * layout.length[:, None]
    fall = np.cumsum((before + curvature * half[:, None]) * layout.length[:, None], axis=0)
    # as coarse as the body's own mesh, whose shear is to be told from its clamp
    body = build_cell(design, 0)
    materials = tuple(material(region.material) for region in body.regions)
    middles = np.append(design.chamber_starts()[0] + design.chamber_length / 2, begin + half)
    first, *width = np.asarray(design.half_width(middles)).tolist()
    sheared = shear_compliance(body, materials, graded=False) * first / np.array(width)
    fall[:, 1] += np.cumsum(sheared * force * layout.length)
    fall[:, 2] -= np.cumsum(sheared * layout.length)
    return -np.stack(
        [np.interp(at, layout.stations, np.append(0.0, column)) for column in fall.T], axis=-1
    )


def _spread(design: SlabDesign, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Force [N] and moment [N m] at X1 = ``at`` (s,) of 1 Pa on the underside beyond."""
    x = np.linspace(0.0, design.length, 2001)
    width = 2 * np.asarray(design.half_width(x))
    step = np.diff(x) * (width[1:] + width[:-1]) / 2
    beyond = np.append(np.cumsum(step[::-1])[::-1], 0.0)
    arm = np.append(np.cumsum(((beyond[1:] + beyond[:-1]) / 2 * np.diff(x))[::-1])[::-1], 0.0)
    return np.interp(at, x, beyond), np.interp(at, x, arm)
