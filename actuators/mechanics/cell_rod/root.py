"""What the solid end at the clamp gives way: chambers in blocks stand on a floor that ends in it.

A floor that bends does so also a little way into the solid end, and where chambers stand obliquely
their first wall meets that end askew. One linear 3D solve of a few chambers with that end says how
much: under end moments and pressure the middles of the chambers turn by more than those of the rod
with the cell's own law, by a rotation that is the same for all chambers,

    turn = A M + a p,      A symmetric (3, 3) [rad/(N m)], a (3,) [rad/Pa].

Half a turn about a chamber's vertical axis leaves it as it is, so that its mean rotations about X1
and X2 under pressure and moments about them, and about X3 under a moment about that, hold nothing
of how it warps. Rotations about X3 under the former are read off the slope of the sideways
displacements, the others follow by Betti's theorem.
"""

from dataclasses import dataclass

import numpy as np

from actuators.design import BLOCK_FAMILIES, Design, ObliqueDesign, PrintedDesign
from actuators.geometry import build_body
from actuators.mechanics.cell.kept import Kept
from actuators.mechanics.cell.row import chamber_row, pitch_starts
from actuators.mechanics.rod.pieces import layout_of
from actuators.meshing import HexMesh

CHAMBERS = 4
"""Of the body that is solved; the last is not read, for it feels its own end."""
TORSION, BENDING, SIDEWAYS = 0, 1, 2
NEAR = 1e-7
"""Of the length: as good as there."""
_LOADS = 4  # pressure, moments about X1, X2, X3
Blocks = ObliqueDesign | PrintedDesign


@dataclass(frozen=True, eq=False)
class Root:
    """Turn beyond the rod's own where the first pitch begins. ``compliance``: A (3, 3)
    [rad/(N m)]; ``pressed``: a (3,) [rad/Pa]; ``bent``: bending compliance and ``free`` (3,)
    torsion and curvatures per pressure of the linear cell: both turns grow as the inflated one's
    do."""

    compliance: np.ndarray
    pressed: np.ndarray
    bent: float
    free: np.ndarray


_roots: Kept[Root] = Kept(128)


def root_of(design: Design) -> Root | None:
    """Of the clamped end; None where chambers do not stand in blocks, or are too few to tell."""
    if not isinstance(design, BLOCK_FAMILIES) or design.chamber_count < CHAMBERS:
        return None
    bar = design.bar
    # an end longer than it is high, beyond what slants into it, is no other
    reach = abs(bar.width / 2 * bar.cot_theta)
    end = min(bar.end_length, reach + bar.height / 2)
    short = design.model_copy(
        update={"chamber_count": CHAMBERS, "length": CHAMBERS * bar.pitch + 2 * end}
    )
    return _roots.get(short.digest, lambda: _solve(short))


def forget_roots() -> None:
    """Empty the store (benchmarks time a new body with it)."""
    _roots.forget()


def _solve(design: Blocks) -> Root:
    from actuators.meshing import mesh_body

    body = build_body(design)
    whole = not body.symmetric
    mesh = mesh_body(body if whole else body.half())
    motion = _motions(mesh, design.length, whole=whole)
    turned, moved = _middles(design, mesh, motion)
    row = chamber_row(design)
    start, pitch = pitch_starts(design)
    middles = start + pitch / 2
    own, pressed = np.linalg.inv(row.stiffness[0])[1:, 1:], row.free[0, 1:]
    per_length = np.concatenate([pressed[:, None], own], axis=1)
    layout = layout_of(design, row)
    solid = layout.stations[1:] <= start[0] + NEAR * design.length
    ends = np.linalg.inv(layout.solid[solid])[:, 1:, 1:]
    before = np.zeros((3, _LOADS))
    before[:, 1:] = np.einsum("sij,s->ij", ends, layout.length[solid])
    # (chambers, 3, loads): what chambers turn beyond the rod, on their middles
    beyond = turned - before - per_length * (middles - start[0])[:, None, None]
    read = slice(0, CHAMBERS - 1)
    at_start = _line(middles[read] - start[0], beyond[read])[1]
    askew = _line(middles[read] - start[0], moved[read, 1])[0]
    found = at_start.copy()
    found[SIDEWAYS, : SIDEWAYS + 1] = askew[: SIDEWAYS + 1]
    matrix = found[:, 1:]
    matrix[:SIDEWAYS, SIDEWAYS] = matrix[SIDEWAYS, :SIDEWAYS]
    if not whole:
        matrix[[TORSION, SIDEWAYS]] = 0.0
        matrix[:, [TORSION, SIDEWAYS]] = 0.0
        found[[TORSION, SIDEWAYS], 0] = 0.0
    return Root(
        compliance=(matrix + matrix.T) / 2,
        pressed=found[:, 0],
        bent=float(own[BENDING, BENDING]),
        free=pressed,
    )


def _line(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Slope and value at 0 of the straight lines through ``y`` (k, ...) at ``x`` (k,)."""
    found = np.polyfit(x, y.reshape(len(y), -1), 1)
    return found[0].reshape(y.shape[1:]), found[1].reshape(y.shape[1:])


def _motions(mesh: HexMesh, length: float, *, whole: bool) -> np.ndarray:
    """(n, 3, loads) displacements under pressure 1 Pa and unit moments on the free end; of a half
    body only pressure and bending, 0 else."""
    # the 3D solver's kernels: only where an answer needs them
    from actuators.mechanics.continuum.assembly import linear_system
    from actuators.mechanics.continuum.outer_loads import end_tractions

    system = linear_system(mesh)
    at = mesh.nodes[system.nodes]
    held = np.zeros((len(at), 3), dtype=bool)
    held[np.abs(at[:, 0]) < NEAR * length] = True
    if not whole:
        held[np.abs(at[:, 1]) < NEAR * length, 1] = True
    force, moment = end_tractions(mesh)
    forces = np.zeros((*mesh.nodes.shape, _LOADS))
    forces[..., 1 + BENDING] = moment if whole else moment / 2
    if whole:
        forces[..., 1] = _moment_about(mesh, force[:, 2], 0)
        forces[..., 3] = _moment_about(mesh, force[:, 2], 2)
    loads = forces[system.nodes].reshape(-1, _LOADS)
    loads[:, 0] = system.pressure_load
    motion = np.zeros((len(mesh.nodes), 3, _LOADS))
    motion[system.nodes] = system.motions(held, loads)
    return motion


def _moment_about(mesh: HexMesh, share: np.ndarray, axis: int) -> np.ndarray:
    """(n, 3) forces of a unit moment about an axis, as a rigid turn spreads them over the free end,
    whose nodes weigh ``share`` (n,)."""
    arm = mesh.nodes - share @ mesh.nodes
    force = share[:, None] * np.cross(np.eye(3)[axis], arm)
    return force / np.cross(arm, force).sum(axis=0)[axis]


def _middles(design: Blocks, mesh: HexMesh, motion: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Mean rotations and displacements (chambers, 3, loads) of the undersides of the pitches."""
    start, pitch = pitch_starts(design)
    x, y, z = mesh.nodes.T
    under = np.zeros(len(x), dtype=bool)
    under[np.unique(mesh.outer_faces.nodes)] = True
    near = NEAR * design.length
    under &= z < near
    whole = bool(y.min() < -near)
    along = x - y * design.bar.cot_theta
    turned, moved = [], []
    for middle in start + pitch / 2:
        mine = under & (np.abs(along - middle) < pitch / 2 + near)
        arm, shift = mesh.nodes[mine] - [middle, 0.0, 0.0], motion[mine]
        columns = np.zeros((len(arm), 3, 6))
        columns[:, [0, 1, 2], [3, 4, 5]] = 1.0
        for axis in range(3):
            columns[:, :, axis] = np.cross(np.eye(3)[axis], arm)
        kept = [0, 1, 2, 3, 4, 5] if whole else [1, 3, 5]
        found = np.zeros((6, motion.shape[-1]))
        found[kept] = np.linalg.lstsq(
            columns[..., kept].reshape(-1, len(kept)), shift.reshape(-1, motion.shape[-1]),
            rcond=None,
        )[0]  # fmt: skip
        turned.append(found[:3])
        moved.append(found[3:])
    return np.array(turned), np.array(moved)
