"""What the clamp does to a wide body: one linear solve of the whole, compared with its own rod.

Across the width the clamp forbids what bending does inside, and the chambers beside it answer
less; a body that widens behind a narrow clamp is not borne by all of its width at once; and a row
as short as it is wide does not give way to shear as an endless one does. In the linear body under
an end moment, an end force, a load spread over its underside or pressure, the line of the underside
at the walls between chambers is that of the rod with the cells' compliance C and free curvature, up
to a turn and a shift. With M and V the moment and the force at the clamp, both bending down,

    turn = C (a M + b V),    shift down = C (b M + c V),    shear = s times the cell's

are read off by least squares over the three loads together, so that a turn is not taken for shear;
turn and shift under pressure besides. a is a length by which the rod begins later (a < 0). The free
end's own turn and place, which the line of the inside does not know, are read too. All of it is
geometry: nothing is fitted to a path or an experiment.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from actuators.design import Design, SlabDesign
from actuators.geometry import build_body, build_cell
from actuators.materials import material
from actuators.mechanics.cell.kept import Kept
from actuators.mechanics.cell.row import ChamberRow, chamber_row, pitch_starts
from actuators.mechanics.cell.shear import shear_compliance
from actuators.mechanics.rod.pieces import layout_of
from actuators.meshing import HexMesh

FEWEST = 3
"""Chambers that a body must have for its inside to be read off."""
NEAR = 1e-7
"""Of the length: as good as there."""
SMALL = 1e-6
"""Displacements of the linear body, in its lengths, at which turns are read off."""
BENDING = 2


@dataclass(frozen=True, eq=False)
class Grip:
    """Per compliance C of the cell beside the clamp: ``turn``: a beyond what the rod's own solid
    end and first pitch have [m]; ``mixed``: b [m2]; ``shift``: c [m3]. ``shear``: s, share of the
    cells' shear compliance. ``tip``: how much further than the rod the free end turns under 1 Pa on
    the underside (down) and a force of 1 on the end (down) [m3, m2]. Per free curvature:
    ``pressed_turn`` theta_0 beyond the rod's [m], ``pressed_shift`` z_0 [m2] and ``pressed_lift``,
    by which the tip point lies above the line of the inside [m2].
    ``pressed_tip``: how much further the free end turns per pressure [rad/Pa]: its floor's doing,
    which does not grow as roofs swell."""

    turn: float
    mixed: float
    shift: float
    shear: float
    tip: tuple[float, float]
    pressed_turn: float
    pressed_shift: float
    pressed_lift: float
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
    from actuators.meshing import mesh_body

    mesh = mesh_body(build_body(design).half())
    system = linear_system(mesh)
    at = mesh.nodes[system.nodes]
    held = np.zeros((len(at), 3), dtype=bool)
    near = NEAR * design.length
    held[at[:, 0] < near] = True
    held[np.abs(at[:, 1]) < near, 1] = True
    spread, force, moment = _loads(mesh)
    loads = [load[system.nodes].ravel() for load in (spread, force, moment)]
    motion = np.zeros((len(mesh.nodes), 3, 4))
    motion[system.nodes] = system.motions(held, np.stack([system.pressure_load, *loads], axis=1))
    line = mesh.underside_line
    return _read(design, mesh.nodes[line, 0], motion[line, 2], _end_turn(mesh, motion))


def _loads(mesh: HexMesh) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Nodal forces (n, 3) on half a body, all bending it down: 1 Pa on the underside, a force and a
    moment of 1 on the free end of the whole."""
    from actuators.mechanics.continuum.kernel.cavity import face_traction
    from actuators.mechanics.continuum.outer_loads import end_tractions, underside_faces

    spread = np.zeros_like(mesh.nodes)
    face_traction(mesh.nodes, underside_faces(mesh), spread)
    force, moment = end_tractions(mesh)
    return spread, -force / 2, moment / 2


def _end_turn(mesh: HexMesh, motion: np.ndarray) -> np.ndarray:
    """Turn (loads,) of the free end about X2, as 3D answers state it: of the bottom layer."""
    from actuators.mechanics.continuum.sections import section_frames

    small = SMALL * np.ptp(mesh.nodes[:, 0]) / np.abs(motion).max(axis=(0, 1))
    normal = section_frames(mesh, np.moveaxis(small * motion, -1, 0))[..., 0][:, [0, -1]]
    angle = np.arctan2(-normal[..., 2], normal[..., 0])
    return (angle[:, 1] - angle[:, 0]) / small


def _read(design: SlabDesign, x: np.ndarray, z: np.ndarray, turned: np.ndarray) -> Grip:
    """From heights ``z`` (k, 4) of the underside's line at ``x`` (k,), and the free end's turn
    (4,), under pressure 1 Pa and the loads of :func:`_loads`."""
    row = chamber_row(design)
    bent = float(np.linalg.inv(row.stiffness[0])[BENDING, BENDING])
    pressed = float(row.free[0, BENDING])
    walls = pitch_starts(design)[0][1:]
    inside = np.array([np.abs(x - wall).argmin() for wall in walls])
    length = design.length
    own = _own_line(design, row, np.append(x[inside], length))
    at, fall = x[inside], -z[np.append(inside, -1)]
    stations = layout_of(design, row).stations
    spread_force, spread_moment = (value[0] for value in _spread(design, stations))
    forces, moments = np.array([spread_force, 1.0, 0.0]), np.array([spread_moment, length, 1.0])
    beyond = fall - own.bent
    # rows: the three loads at every wall, each in shares of how far its own tip falls
    columns = np.stack(
        [bent * np.outer(at, moments), bent * (np.outer(at, forces) + moments),
         bent * np.broadcast_to(forces, (len(at), 3)), own.sheared[:-1, 1:]], axis=-1,
    ) / fall[-1, 1:, None]  # fmt: skip
    wanted = beyond[:-1, 1:] / fall[-1, 1:]
    scale = np.abs(columns).max(axis=(0, 1))
    found = np.linalg.lstsq((columns / scale).reshape(-1, 4), wanted.ravel(), rcond=None)[0] / scale
    turn, mixed, shift, shear = found.tolist()
    # what the rod then says of the free end
    turns = bent * (turn * moments + mixed * forces)
    tip = (turned[1:] - own.turn[1:] - turns) / bent
    slope, begin = np.polyfit(at, beyond[:-1, 0], 1) / pressed
    return Grip(
        turn=turn, mixed=mixed, shift=shift, shear=shear,
        tip=(float(tip[0]), float(tip[1])),
        pressed_turn=float(slope), pressed_shift=-float(begin),
        pressed_lift=-float(beyond[-1, 0] / pressed - (slope * length + begin)),
        pressed_tip=float(turned[0] - own.turn[0] - slope * pressed),
    )  # fmt: skip


class _OwnLine(NamedTuple):
    """Of the rod with the cells' linear law under the four loads: how far it falls by bending and
    by shear (k, 4), and the free end's turn (4,)."""

    bent: np.ndarray
    sheared: np.ndarray
    turn: np.ndarray


def _own_line(design: SlabDesign, row: ChamberRow, at: np.ndarray) -> _OwnLine:
    """At X1 = ``at`` (k,)."""
    layout = layout_of(design, row)
    bent = np.linalg.inv(layout.stiffness(row.stiffness))[:, BENDING, BENDING]
    begin, half = layout.stations[:-1], layout.length / 2
    free = layout.free(row.free)[:, BENDING]
    force, moment = _spread(design, begin + half)
    one = np.ones(len(half))
    curvature = np.stack(
        [free, bent * moment, bent * (design.length - begin - half), bent * one], axis=-1
    )
    step = layout.length[:, None]
    turn = np.cumsum(curvature * step, axis=0)
    before = turn - curvature * step
    fall = np.cumsum((before + curvature * half[:, None]) * step, axis=0)
    # as coarse as the body's own mesh, whose shear is to be told from its clamp
    body = build_cell(design, 0)
    materials = tuple(material(region.material) for region in body.regions)
    middles = np.append(design.chamber_starts()[0] + design.chamber_length / 2, begin + half)
    first, *width = np.asarray(design.half_width(middles)).tolist()
    compliance = shear_compliance(body, materials, graded=False) * first / np.array(width)
    across = np.stack([0 * one, force, one, 0 * one], axis=-1)
    sheared = np.cumsum(compliance[:, None] * across * step, axis=0)

    def read(falls: np.ndarray) -> np.ndarray:
        columns = [np.interp(at, layout.stations, np.append(0.0, column)) for column in falls.T]
        return np.stack(columns, axis=-1)

    return _OwnLine(read(fall), read(sheared), turn[-1])


def _spread(design: SlabDesign, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Force [N] and moment [N m] at X1 = ``at`` (s,) of 1 Pa on the underside beyond."""
    x = np.linspace(0.0, design.length, 2001)
    width = 2 * np.asarray(design.half_width(x))
    step = np.diff(x) * (width[1:] + width[:-1]) / 2
    beyond = np.append(np.cumsum(step[::-1])[::-1], 0.0)
    arm = np.append(np.cumsum(((beyond[1:] + beyond[:-1]) / 2 * np.diff(x))[::-1])[::-1], 0.0)
    return np.interp(at, x, beyond), np.interp(at, x, arm)
