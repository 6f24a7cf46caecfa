"""What can be told of a finite-element question before it is solved.

Everything here takes milliseconds: sizes of meshes are counted on the body's lattice, the strain to
be expected is that of the periodic cell, linear in pressure (the energy rung's own), and which
effects will be solved for is what :func:`.effects.plan` decides.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from actuators.design import Design
from actuators.geometry import OUTSIDE, Body, build_body
from actuators.mechanics.cell.row import ChamberRow
from actuators.mechanics.effects import plan
from actuators.mechanics.effects.forecast import Forecast
from actuators.mechanics.effects.reach import obstacle_distances
from actuators.mechanics.scene import Scene
from actuators.meshing.counting import condensed_unknowns
from actuators.meshing.levels import MeshChoice, layers_of, levels_of

FEATURES = (
    "one", "coarse", "oblique", "printed", "bellows", "linear", "strain", "large strain",
    "suction", "drained", "volume", "obstacle", "walls meet", "watched", "steps", "turn", "closed",
    "pressed", "weight", "force",
)  # fmt: skip
"""What a question is described by, in the order of :attr:`Outlook.features`. ``drained``: share of
its air that suction takes from the linear cavity; ``turn``: of the free end by the linear cell;
``closed``: how many times over neighbouring walls would close their gap; ``pressed``: how far
beyond an obstacle's surface the body would move freely, over its way; ``weight``, ``force``: what
weight, and other loads, do to the tip, over its way."""

WALL_STRAIN = {"slab": 0.3, "oblique": 0.3, "printed": 0.15, "bellows": 0.06}
"""Largest strain [-] of the linear cell from which on a solve takes more steps: slabs come near
their limit pressure there, the walls of the others begin to meet (presets, measured)."""

PATH_SOLVES, ANCHOR_SOLVES, LAST_SOLVES, LINEAR_SOLVES = 20.0, 2.0, 6.0, 1.0
"""Tangents, typically: of a path on the coarsest mesh, of one state on a finer mesh, and of the
states that are solved besides on the last one; and of a mesh of a linear answer."""
ASSEMBLY_S, FACTOR_S, FACTOR_GROWTH, BESIDES_S = 0.013, 0.037, 1.7, 0.07
"""Seconds of one tangent with 5000 unknowns, in proportion to them and to their power of
FACTOR_GROWTH, and of what a job takes besides: processor of one thread, measured on jobs of all
families to 12 % (docs/ladder.md). A machine's own pace is learnt."""
ACCURACY = 0.05
"""The solver's own where none is asked for."""
SURELY_LINEAR = 0.7
"""Share of what may be left out below which one linear solution is expected to do."""
MOST_UNKNOWNS = 400_000
"""Larger meshes are not solved on (``continuum.climb``)."""


@dataclass(frozen=True)
class MeshSizes:
    """Unknowns of the coarsest mesh and of every finer one that a job may come to."""

    coarsest: int
    finer: tuple[int, ...]
    stands_apart: bool


def mesh_sizes(design: Design, *, is_half: bool, mesh: MeshChoice | None = None) -> MeshSizes:
    """Sizes of the meshes of a question, of half the body where that is what is solved."""
    body = build_body(design)
    if is_half:
        body = body.half()
    coarsest, *ladder = levels_of(body)
    if mesh is not None:
        wanted = layers_of(body, mesh)
        ladder = [wanted] if wanted != coarsest else []
    return MeshSizes(
        condensed_unknowns(body, coarsest),
        tuple(condensed_unknowns(body, layers) for layers in ladder),
        _stands_apart(body),
    )


def _stands_apart(body: Body) -> bool:
    return body.curved or bool((body.fill == OUTSIDE).any())


def cell_strain(row: ChamberRow, scene: Scene) -> tuple[float, bool]:
    """Largest strain that the linear cell has at the scene's last pressure, and whether that is
    suction. A volume counts as the pressure at which the linear cavity has it."""
    if scene.pressure_to is not None:
        pressure = scene.pressure_to
    else:
        growth = (scene.volume_to or 0.0) - float(row.cavity_volume.sum())
        pressure = growth / float(row.cavity_compliance.sum())
    return abs(pressure) * row.largest_strain, pressure < 0.0


@dataclass(frozen=True)
class LevelErrors:
    """Estimated errors that jobs have had: mean and standard deviation of their natural logarithm
    on the first, second, ... finer mesh; the last entry serves for all beyond it."""

    mean: tuple[float, ...]
    deviation: tuple[float, ...]

    def on(self, level: int) -> tuple[float, float]:
        """Mean and standard deviation on the ``level``-th finer mesh, counted from 1."""
        k = min(level, len(self.mean)) - 1
        return self.mean[k], self.deviation[k]


@dataclass(frozen=True, eq=False)
class Outlook:
    """A question, told before it is solved: ``features`` (f,) as of :data:`FEATURES`; ``sizes``:
    unknowns of its meshes, coarsest first; ``work``: natural logarithm of :func:`work_by_level`,
    the seconds of a usual job that ends on each of them. ``accuracy``: at which estimated error it
    ends; None where one mesh was asked for. ``stands_apart``: a body of chambers that do."""

    features: np.ndarray
    sizes: tuple[int, ...]
    work: tuple[float, ...]
    accuracy: float | None
    stands_apart: bool

    @property
    def first(self) -> int:
        """The first mesh on which it can end."""
        return len(self.sizes) - 1 if self.accuracy is None else min(1, len(self.sizes) - 1)

    def level_of(self, unknowns: int) -> int:
        """Which of its meshes has so many unknowns."""
        away = np.abs(np.log(np.array(self.sizes, dtype=float) / max(unknowns, 1)))
        return max(int(np.argmin(away)), self.first)


def tangent_seconds(unknowns: int) -> float:
    """What one tangent takes [s]: assembled, factorised, solved with."""
    size = unknowns / 5e3
    return ASSEMBLY_S * size + FACTOR_S * size**FACTOR_GROWTH


def work_by_level(sizes: Sequence[int], *, linear: bool = False) -> tuple[float, ...]:
    """Seconds of a usual job that ends on the first, second, ... of its meshes. ``linear``: one
    linear solution per mesh is expected to do."""
    first, each, ending = PATH_SOLVES, ANCHOR_SOLVES, LAST_SOLVES
    if linear:
        first, each, ending = LINEAR_SOLVES, LINEAR_SOLVES, 0.0
    costs = [tangent_seconds(unknowns) for unknowns in sizes]
    found = [BESIDES_S + first * costs[0]]
    for level in range(1, len(sizes)):
        before = BESIDES_S + first * costs[0] + each * sum(costs[1:level])
        found.append(before + (each + ending) * costs[level])
    return tuple(found)


def outlook(
    design: Design, scene: Scene, *, accuracy: float | None, mesh: MeshChoice | None = None
) -> Outlook:
    """What can be told of a question. ``accuracy``: the one asked for (None: the solver's own);
    where a ``mesh`` is asked for it decides about effects only.

    Raises :class:`InputError` for a design or mesh that cannot be built.
    """
    asked = ACCURACY if accuracy is None else accuracy
    decided = plan(design, scene, asked)
    finite = decided.by_name["finite_strain"]
    # an estimate near what may be left out is seldom borne out, and the path followed after all
    linear = not finite.on and (finite.change or 0.0) < SURELY_LINEAR * decided.threshold
    meshes = mesh_sizes(design, is_half=decided.on("symmetry"), mesh=mesh)
    sizes = (meshes.coarsest, *(n for n in meshes.finer if n <= MOST_UNKNOWNS))
    forecast = Forecast(design, scene)
    strain, suction = cell_strain(forecast.row, scene)
    share = strain / WALL_STRAIN[design.family]
    touching = ("self_contact", "plate_contact", "cylinder_contact")
    values = {
        "one": 1.0,
        "coarse": math.log(meshes.coarsest / 5e3),
        "oblique": float(design.family == "oblique"),
        "printed": float(design.family == "printed"),
        "bellows": float(design.family == "bellows"),
        "linear": float(linear),
        "strain": 0.0 if linear else math.log(max(share, 0.02)),
        "large strain": 0.0 if linear else math.log(max(share, 1.0)),
        "suction": float(suction),
        "drained": _log(_drained(forecast), 0.03, 1.0),
        "volume": float(scene.volume_to is not None and not linear),
        "obstacle": float(decided.on("plate_contact") or decided.on("cylinder_contact")),
        "walls meet": float(decided.on("self_contact")),
        "watched": float(any(decided.watched(name) for name in touching)),
        "steps": 0.0 if linear else math.log((scene.steps or 6) / 6),
        "turn": 0.0 if linear else _log(_turn(forecast), 0.1, 10.0),
        "closed": _log(
            0.0 if scene.choice("self_contact") == "off" else _closed(forecast), 0.3, 10.0
        ),
        "pressed": _pressed(forecast) if decided.on("plate_contact")
        or decided.on("cylinder_contact") else 0.0,
        "weight": _log(forecast.weight_share, 0.03, 1.0),
        "force": _log(
            forecast.share(forecast.force.tip) + forecast.share(forecast.outside.tip), 0.03, 1.0
        ),
    }  # fmt: skip
    return Outlook(
        np.array([values[name] for name in FEATURES]),
        sizes,
        tuple(math.log(work) for work in work_by_level(sizes, linear=linear)),
        None if mesh is not None else asked,
        meshes.stands_apart,
    )


def _log(value: float, low: float, high: float) -> float:
    return math.log(min(max(value, low), high))


def _turn(forecast: Forecast) -> float:
    """By which the pressure alone turns the free end [rad], as the linear cells have it."""
    strains = forecast.inflation[:, 1:]
    return float(np.linalg.norm((strains * forecast.rod.length[:, None]).sum(axis=0)))


def _drained(forecast: Forecast) -> float:
    """Share of its air that suction takes from the linear cavity."""
    row = forecast.row
    taken = -forecast.pressure * float(row.cavity_compliance.sum())
    return max(taken / float(row.cavity_volume.sum()), 0.0)


def _closed(forecast: Forecast) -> float:
    """How many times over neighbouring walls close their gap in the linear cell."""
    return max(forecast.row.gap_closing * forecast.pressure, 0.0)


def _pressed(forecast: Forecast) -> float:
    """How far the rod would come beyond the surface of an obstacle, over its way; at most 1."""
    deepest = 0.0
    for obstacle in (forecast.scene.plate, forecast.scene.cylinder):
        distance = None if obstacle is None else obstacle_distances(forecast, obstacle)
        if distance is not None and forecast.travel > 0.0:
            deepest = max(deepest, -float(distance.min()) / forecast.travel)
    return min(deepest, 1.0)
