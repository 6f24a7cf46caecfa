"""Rung 3: the inflated periodic cell's law, carried by a geometrically exact rod.

The cell gives each chamber's rod strains, tangent stiffness and cavity at every pressure; the rod
puts weight, tip force, outside pressure and obstacles on them.
"""

import time
from dataclasses import dataclass, replace

import numpy as np

from actuators.design import Design
from actuators.geometry.volumes import exact_volumes
from actuators.mechanics.cell.inflated import CellPath
from actuators.mechanics.cell.row import ChamberRow, chamber_row
from actuators.mechanics.cell_rod.cells import (
    end_bending,
    row_apart,
    row_bending,
    row_paths,
    row_shear,
)  # fmt: skip
from actuators.mechanics.cell_rod.chambers import Chambers, inflated, parting, reached
from actuators.mechanics.cell_rod.grip import Grip, grip_of
from actuators.mechanics.cell_rod.held import give, hold, turned
from actuators.mechanics.cell_rod.pressed import force_estimate, held_by
from actuators.mechanics.cell_rod.report import (
    advice_of,
    bent_strains,
    cell_rod_effects,
    cell_rod_notes,
    mostly_sag,
)
from actuators.mechanics.cell_rod.root import Root, root_of
from actuators.mechanics.cell_rod.trust import BEYOND_TRUST, estimate, trusted_to
from actuators.mechanics.response import Outcome, PathPoint, Response
from actuators.mechanics.rod.answer import centreline, path_points
from actuators.mechanics.rod.follow import Laws, LoadedPath, follow_laws
from actuators.mechanics.rod.pieces import Layout, layout_of
from actuators.mechanics.rod.surroundings import (
    chain_of,
    finest_of,
    obstacles_of,
    refuse_needles,
)  # fmt: skip
from actuators.mechanics.scene import Scene

BENDING = 2
VOLUME_ERROR, VOLUME_CORRECTIONS, FUTILE = 1e-7, 8, 2
"""Of a prescribed volume; corrections that may be made to come so near, and of these how many in a
row may come no nearer: where a body jumps, no pressure gives the volumes it leaps over."""
CRUSHED = 2.0
"""Strain at the body's top by what loads bend it, beyond which a chamber is no piece of a rod."""
FEWEST = 5
"""Points up to the cell's limit that make a path; where its steps are longer, the limit is the end
of as many shorter ones."""
AT_REST = 1e-3
"""Change of the cavity by weight, as a fraction, that a prescribed volume does not take back."""


@dataclass(frozen=True, eq=False)
class Solved:
    """A path and what it was made from. ``volume``: (k,) of the cavity [m3]; ``missed``: by how
    much, as a fraction, it is not the volume prescribed."""

    pressures: np.ndarray
    path: LoadedPath
    chambers: Chambers
    volume: np.ndarray
    missed: float = 0.0


@dataclass(frozen=True, eq=False)
class Question:
    """What stays the same while pressures are tried."""

    design: Design
    scene: Scene
    row: ChamberRow
    layout: Layout
    paths: tuple[CellPath, ...]
    weights: np.ndarray
    shear: np.ndarray
    bent: np.ndarray
    end: np.ndarray
    grip: Grip | None
    root: Root | None
    apart: tuple[CellPath, ...] | None

    def solve(self, pressures: np.ndarray) -> Solved:
        """Rod at every pressure (k,), as far as it finds equilibria."""
        layout = self.layout
        chambers = inflated(self.paths, self.weights, pressures)
        laws = piece_laws(layout, chambers, self.shear, self.bent, self.end)
        if self.apart is not None and chambers.contact is not None:
            laws = self._parted(laws, chambers, pressures)
        if self.grip is not None:
            hold(laws, layout, chambers, self.grip)
        if self.root is not None:
            give(laws, layout, chambers, self.root)
        moment = np.einsum("kab,kb->ka", laws.stiffness[-1], laws.free[-1])[:, 1:4]
        obstacles = obstacles_of(
            self.design, layout, self.scene, float(np.abs(moment).max(initial=0.0))
        )
        chain = chain_of(self.design, layout, self.scene)
        path = follow_laws(laws, chain, obstacles)
        if self.grip is not None:
            path = turned(path, chambers, self.grip, layout, chain, pressures)
        found = len(path.positions)
        # weight and obstacles bend chambers, which changes their cavities a little
        bent = path.strains[..., :4] - laws.free[:found, :, :4]
        rate = chambers.volume_rate[:found][:, np.maximum(layout.chamber, 0)]
        share = np.where(layout.chambered, layout.length / self.row.pitch, 0.0)
        volume = exact_volumes(self.design).cavity + chambers.growth[:found].sum(axis=1)
        volume = volume + np.einsum("ksa,ksa,s->k", rate, bent, share)
        return Solved(pressures, path, chambers, volume)

    def _parted(self, laws: Laws, chambers: Chambers, pressures: np.ndarray) -> Laws:
        assert self.apart is not None
        assert chambers.contact is not None
        within = np.clip(np.abs(pressures), 0.0, abs(reached(self.apart, float(pressures[-1]))))
        apart = inflated(self.apart, self.weights, np.sign(pressures[-1]) * within)
        parted, release = parting(chambers, apart, chambers.contact > 0.0)
        layout = self.layout
        shape = (len(pressures), len(layout.length), 6)
        wide, share = np.zeros(shape), np.zeros(shape)
        wide[..., :4] = layout.free(parted)
        share[..., :4] = np.where(layout.chambered[:, None], release[:, layout.chamber], 0.0)
        return replace(laws, parted=wide, release=share)


def piece_laws(
    layout: Layout, chambers: Chambers, shear: np.ndarray, bent: np.ndarray, end: np.ndarray
) -> Laws:
    """Laws of the pieces at k pressures. ``shear``: (s, 2) stiffness along X2 and X3 [N];
    ``bent``: (n, 2) how the chambers' bending stiffness falls with the curvature [m, m2],
    ``end``: (2,) that of solid ends."""
    k, s = len(chambers.free), len(layout.length)
    free, stiffness = np.zeros((k, s, 6)), np.zeros((k, s, 6, 6))
    free[..., :4] = layout.free(chambers.free)
    stiffness[..., :4, :4] = layout.stiffness(chambers.stiffness)
    stiffness[..., 4, 4], stiffness[..., 5, 5] = shear[:, 0], shear[:, 1]
    # a pitch that is cut off turns more for its length
    change = np.where(layout.chambered[:, None], bent[layout.chamber], end)
    return Laws(free, stiffness, change / layout.whole[:, None] ** [1, 2])


def answer(design: Design, scene: Scene, steps: int) -> Response:
    """Path of ``design`` under ``scene`` in equal steps of pressure or volume."""
    begun = time.perf_counter()
    refuse_needles(design, scene)
    row = chamber_row(design)
    paths, weights = row_paths(design, scene)
    shears = weights @ row_shear(design)
    bent, ends = np.zeros((len(weights), 2)), np.zeros(2)
    changes = row_bending(design) if _loaded(scene) else ()
    if changes:
        bent = weights @ np.array([[change.growth, change.further] for change in changes])
        solid = end_bending(design)
        if solid is not None:
            ends, changes = np.array([solid.growth, solid.further]), (*changes, solid)
    celled = time.perf_counter()
    layout = layout_of(design, row, finest=finest_of(design, scene))
    grip = grip_of(design)
    if grip is not None:
        shears[:, 1] /= grip.shear
    question = Question(
        design, scene, row, layout, paths, weights, _shear(layout, shears),
        bent, ends, grip, root_of(design),
        row_apart(design, paths) if _loaded(scene) else None,
    )  # fmt: skip
    solved, short = _to_the_end(question, scene, steps)
    solved, crushed = believed(question, solved)
    ended = time.perf_counter()
    found = len(solved.path.positions)
    outcome, advice = advice_of(
        question.paths, scene, solved.pressures, found, loads=solved.path.loads, short=short,
        crushed=crushed,
    )  # fmt: skip
    trusted = trusted_to(design, paths, solved.pressures[:found])
    suction = found > 0 and bool(solved.pressures[found - 1] < 0.0)
    sure = trusted is None and solved.path.loads == 1.0
    expected = estimate(design, suction=suction) + held_by(question, solved)
    expected = min(expected, BEYOND_TRUST) if sure else BEYOND_TRUST
    pressed = force_estimate(question, solved)
    points = _points(question, solved)
    response = Response(
        design=design,
        scene=scene,
        rung="cell-rod",
        outcome=outcome,
        path=points,
        advice=advice,
        centreline=centreline(solved.path, layout.length),
        error_estimate=expected,
        error_estimates={} if pressed is None else {"tip": expected, "force": pressed},
        limit_pressure=(
            _limit(paths, solved.pressures[found : found + 1])
            if outcome is Outcome.LIMIT_POINT
            else None
        ),
        trusted_to=trusted,
        unknowns=sum(p.unknowns for p in paths) + 6 * len(layout.length),
        newton_iterations=solved.path.iterations + sum(a.iterations for a in (*paths, *changes)),
        effects=cell_rod_effects(question, solved),
        notes=(
            *cell_rod_notes(question, solved),
            *{c.missing for c in changes if c.missing},
            *mostly_sag(points, expected),
        ),
        timings={"cell": celled - begun, "rod": ended - celled},
    )
    return replace(response, wall_s=time.perf_counter() - begun)


def believed(question: Question, solved: Solved) -> tuple[Solved, float]:
    """The path up to where loads bend chambers further than any law of theirs is known, one state
    at least; and by how much, as a strain at their top, 0 where they do not."""
    path = solved.path
    strains = bent_strains(question, solved)
    far = np.flatnonzero(strains > CRUSHED)
    if len(far) == 0:
        return solved, 0.0
    kept = max(int(far[0]), 1)
    names = ("strains", "positions", "frames", "obstacle_force", "penetration")
    shorter = replace(path, **{name: getattr(path, name)[:kept] for name in names})
    return replace(solved, path=shorter, volume=solved.volume[:kept]), float(strains[far[0]])


def _loaded(scene: Scene) -> bool:
    """Whether anything but pressure bends the body."""
    return (
        any(scene.gravity or ()) or any(scene.tip_force or ()) or scene.outside_pressure != 0.0
        or scene.has_obstacle
    )  # fmt: skip


def _to_the_end(question: Question, scene: Scene, steps: int) -> tuple[Solved, bool]:
    """Path to the scene's pressure or volume, or to where the first cell has its limit; and whether
    it fell short."""
    if scene.pressure_to is not None:
        end = reached(question.paths, scene.pressure_to)
        short = abs(end) < abs(scene.pressure_to) * (1 - 1e-9)
        pressures = np.linspace(0.0, scene.pressure_to, steps + 1)
        if short:
            pressures = np.append(pressures[np.abs(pressures) < abs(end)], end)
            if len(pressures) < FEWEST:
                pressures = np.linspace(0.0, end, steps + 1)
        return question.solve(pressures), short
    return _to_a_volume(question, float(scene.volume_to or 0.0), steps)


def _to_a_volume(question: Question, volume_to: float, steps: int) -> tuple[Solved, bool]:
    """Pressures that give equal steps of the whole cavity's volume: read off a path over pressure,
    then off the answer at the pressures read."""
    end = float(question.paths[0].pressure[-1])
    trial = question.solve(np.linspace(0.0, reached(question.paths, end), 4 * steps + 1))
    volume = trial.volume
    if len(volume) < 2:
        return trial, True
    if volume[-1] == volume[0]:  # the volume asked for is that at rest
        still = question.solve(np.zeros(steps + 1))
        return still, not np.isclose(volume_to, volume[0], rtol=AT_REST)
    sign = np.sign(volume[-1] - volume[0])
    wanted = np.linspace(volume[0], volume_to, steps + 1)
    within = sign * wanted <= sign * volume[-1]
    pressures = trial.pressures[: len(volume)]
    at = np.interp(sign * wanted[within], sign * volume, pressures)
    slope = np.interp(sign * wanted[within], sign * volume, np.gradient(pressures, volume))
    short = not bool(within.all())
    if short:
        at = np.append(at, pressures[-1])
    solved = best = _off_by(question.solve(at), wanted[within])
    futile = 0
    for _ in range(VOLUME_CORRECTIONS):
        count = min(len(solved.volume), int(within.sum()))
        if count < 2 or solved.missed <= VOLUME_ERROR or futile == FUTILE:
            break
        change = np.zeros_like(at)
        change[1:count] = (slope[:count] * (wanted[:count] - solved.volume[:count]))[1:]
        at = np.clip(at + change, min(0.0, pressures[-1]), max(0.0, pressures[-1]))
        solved = _off_by(question.solve(at), wanted[within])
        nearer = solved.missed < best.missed and len(solved.volume) >= len(best.volume)
        best, futile = (solved, 0) if nearer else (best, futile + 1)
    return best, short


def _off_by(solved: Solved, wanted: np.ndarray) -> Solved:
    """The same, with what it misses of the volumes ``wanted`` (k,) as far as it comes."""
    count = min(len(solved.volume), len(wanted))
    apart = np.abs(solved.volume[:count] - wanted[:count]).max(initial=0.0)
    return replace(solved, missed=float(apart / np.abs(wanted).max()))


def _shear(layout: Layout, chambers: np.ndarray) -> np.ndarray:
    """Stiffness of the pieces against shear along X2 and X3 (s, 2) [N], of that of the chambers
    (n, 2). Solid ends, a fifth as compliant at most, take their neighbour's."""
    inside = np.flatnonzero(layout.chambered)
    nearest = inside[np.abs(inside[:, None] - np.arange(len(layout.length))).argmin(axis=0)]
    return chambers[layout.chamber[nearest]]


def _points(question: Question, solved: Solved) -> tuple[PathPoint, ...]:
    path, layout, chambers = solved.path, question.layout, solved.chambers
    points = path_points(path, layout.length, layout.chambered, solved.pressures, solved.volume)
    names = [n for n in ("plate", "cylinder") if getattr(question.scene, n) is not None]
    force = np.linalg.norm(path.obstacle_force, axis=-1)
    changed: list[PathPoint] = []
    for n, point in enumerate(points):
        more = {f"{name}_force": float(force[n, o]) for o, name in enumerate(names)}
        if chambers.contact is not None and chambers.contact[n] > 0:
            more["max_contact_pressure"] = float(chambers.contact[n])
        changed.append(replace(point, max_principal_stretch=float(chambers.stretch[n]), **more))
    return tuple(changed)


def _limit(paths: tuple[CellPath, ...], pressures: np.ndarray) -> float | None:
    """The least of the cells', or ``pressures``, at which the body gave way before."""
    limits = [p.limit_pressure for p in paths if p.limit_pressure is not None]
    return min([*limits, *pressures.tolist()], key=abs) if limits else None
