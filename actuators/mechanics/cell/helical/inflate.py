"""From a periodic cell to its path: what :func:`..inflated.inflate_cell` does."""

import time

import numpy as np

from actuators.geometry import Body
from actuators.materials import Material
from actuators.mechanics.cell.helical.contact import wall_contact
from actuators.mechanics.cell.helical.domain import half_pitch
from actuators.mechanics.cell.helical.follow import Course, Follower, Point
from actuators.mechanics.cell.helical.newton import Solver
from actuators.mechanics.cell.helical.overlap import WallGap
from actuators.mechanics.cell.helical.system import CellSystem
from actuators.mechanics.cell.inflated import CellPath
from actuators.mechanics.cell.periodic import CellMesh, coarse_mesh
from actuators.mechanics.continuum.cavity_gap import least_openness
from actuators.mechanics.continuum.sheets import wrinkle_note
from actuators.mechanics.continuum.surface_fields import StrainRecovery
from actuators.mechanics.crossing import first_below


def inflate(
    body: Body, materials: tuple[Material, ...], pressure_to: float, mesh: CellMesh | None,
    *, contact: bool = True,
) -> CellPath:  # fmt: skip
    """See :func:`..inflated.inflate_cell`."""
    begun = time.perf_counter()
    if body.period is None:
        raise ValueError("a cell needs a period")
    domain = half_pitch(body, mesh or coarse_mesh(body))
    walls = wall_contact(domain, materials, pressure_to) if contact else None
    solver = Solver(CellSystem(domain, materials, walls))
    course = Follower(solver, pressure_to).run()
    return _path(course, solver, body.period, begun)


def _path(course: Course, solver: Solver, period: float, begun: float) -> CellPath:
    points = course.points
    recovery = StrainRecovery(solver.system.free)
    region = solver.system.domain.mesh.region
    regions = [np.flatnonzero(region == r) for r in range(region.max() + 1)]
    found = (recovery.at_points(p.state.nodes)[0] for p in points)
    stretch = np.array([[s[at].max(initial=1.0) for at in regions] for s in found])
    stretch = stretch.reshape(-1, len(regions))
    contact = _contact_pressure(points, solver.system)
    notes = [f"The path of the periodic chamber ended: {course.reason}."] if course.reason else []
    wrinkled = next((p.pressure for p in points if p.wrinkles), None)
    if wrinkled is not None:
        notes.append(wrinkle_note(wrinkled))
    notes += _emptied(points, solver.system)
    begins = None if contact is None else _touching_from(points, contact, solver.system)
    if contact is not None and begins is not None:
        notes.append(
            f"Walls of neighbouring chambers touch from about {begins / 1e3:.2g} kPa on and press "
            f"on each other with up to {contact.max() / 1e3:.3g} kPa, without friction."
        )
    return CellPath(
        period=period,
        pressure=np.array([p.pressure for p in points]),
        strain=np.array([p.state.strain for p in points]).reshape(-1, 4),
        strain_rate=np.array([p.rate.strain for p in points]).reshape(-1, 4),
        stiffness=_stiffness(points),
        volume=np.array([2 * p.volume for p in points]),
        volume_rate=np.array([p.law.volume_rate for p in points]).reshape(-1, 4),
        compliance=np.array([2 * p.growth for p in points]),
        max_stretch=stretch.max(axis=1),
        region_stretch=stretch,
        contact_pressure=contact,
        touching_from=begins,
        wrinkles_from=wrinkled,
        outcome=course.outcome,
        limit_pressure=course.limit,
        unknowns=solver.numbering.count,
        iterations=solver.tangents,
        wall_s=time.perf_counter() - begun,
        notes=tuple(notes),
    )


def _emptied(points: list[Point], system: CellSystem) -> list[str]:
    """A note on cavity walls that suction has drawn through each other."""
    if not points or points[-1].pressure >= 0.0:
        return []
    open_by = least_openness(system.domain.mesh, [p.state.nodes for p in points])
    begins = first_below(np.array([p.pressure for p in points]), open_by)
    if begins is None:
        return []
    return [
        f"Walls of the chamber run through each other from about {begins / 1e3:.2g} "
        "kPa on: there is no contact inside the cavity here, and from there on the result is not "
        "physical."
    ]


def _stiffness(points: list[Point]) -> np.ndarray:
    """(k, 4, 4); bending about X3, not found at every point, runs straight between those."""
    stiffness = np.array([p.law.stiffness for p in points]).reshape(-1, 4, 4)
    known = [(abs(p.pressure), p.across) for p in points if p.across is not None]
    if known:
        at, across = np.array(known).T
        stiffness[:, 3, 3] = np.interp([abs(p.pressure) for p in points], at, across)
    return stiffness


def _contact_pressure(points: list[Point], system: CellSystem) -> np.ndarray | None:
    """(k,) largest between walls [Pa]; None where no walls face each other."""
    walls = system.walls
    if walls is None:
        return None
    return np.array([walls.largest_pressure(system.wall_positions(p.state)) for p in points])


def _touching_from(points: list[Point], contact: np.ndarray, system: CellSystem) -> float | None:
    """Pressure [Pa] from which on neighbouring walls touch; None where they do not."""
    pressed = np.flatnonzero(contact > 0.0)
    if len(pressed) == 0:
        return None
    first = int(pressed[0])
    before, after = points[max(first - 1, 0)], points[first]
    begins = after.pressure
    if first > 1:  # the gap closes about as fast as it did last
        gap = WallGap(system)
        open_, earlier = gap.least(before.state), gap.least(points[first - 2].state)
        closing = (earlier - open_) / (before.pressure - points[first - 2].pressure)
        if closing > 0.0:
            begins = min(before.pressure + open_ / closing, after.pressure, key=abs)
    return begins
