"""What can be told of a finite-element question before it is solved.

Everything here takes milliseconds: sizes of meshes are counted on the body's lattice, the strain to
be expected is that of the periodic cell, linear in pressure (the energy rung's own), and which
effects will be solved for is what :func:`.effects.plan` decides.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from actuators.design import Design
from actuators.geometry import OUTSIDE, Body, build_body
from actuators.mechanics.cell.row import ChamberRow, chamber_row
from actuators.mechanics.effects import plan
from actuators.mechanics.scene import Scene
from actuators.meshing.counting import condensed_unknowns
from actuators.meshing.levels import MeshChoice, layers_of, levels_of

FEATURES = (
    "one", "work", "coarse", "oblique", "printed", "bellows", "linear", "strain", "large strain",
    "suction", "volume", "obstacle", "walls meet", "watched", "steps",
)  # fmt: skip
"""What the prediction of time is made from, in the order of :func:`features`."""

WALL_STRAIN = {"slab": 0.3, "oblique": 0.3, "printed": 0.15, "bellows": 0.06}
"""Largest strain [-] of the linear cell from which on a solve takes more steps: slabs come near
their limit pressure there, the walls of the others begin to meet (presets, measured)."""

PATH_SOLVES, ANCHOR_SOLVES, LAST_SOLVES, LINEAR_SOLVES = 25.0, 5.0, 12.0, 2.0
"""Newton iterations, typically: of a path on the coarsest mesh, of one state on a finer mesh, and
of the states that are solved besides on the last one; and what a mesh of a linear answer counts."""
ACCURACY = 0.05
"""The solver's own where none is asked for."""
GROWTH = 1.1
"""Seconds of an iteration grow with unknowns to this power (docs/performance.md)."""


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

    def chance_above(self, level: int, accuracy: float) -> float:
        """Probability that the estimate on a level is above ``accuracy``."""
        k = min(level, len(self.mean) - 1)
        away = (math.log(accuracy) - self.mean[k]) / (self.deviation[k] * math.sqrt(2))
        return 0.5 * math.erfc(away)


def expected_work(
    sizes: MeshSizes, accuracy: float | None, errors: LevelErrors, *, linear: bool = False
) -> float:
    """Newton iterations times unknowns to the power :data:`GROWTH`, summed over the meshes that a
    job is expected to visit. ``accuracy`` None: it stops on the last mesh, whatever its error.
    ``linear``: one linear solution per mesh is expected to do."""
    first, each, ending = PATH_SOLVES, ANCHOR_SOLVES, LAST_SOLVES
    if linear:
        first, each, ending = LINEAR_SOLVES, LINEAR_SOLVES, 0.0
    work = first * sizes.coarsest**GROWTH
    reached = 1.0
    for level, unknowns in enumerate(sizes.finer):
        last = level == len(sizes.finer) - 1
        further = 0.0 if last else 1.0
        if accuracy is not None and not last:
            further = errors.chance_above(level, accuracy)
        work += reached * (each + (1.0 - further) * ending) * unknowns**GROWTH
        reached *= further
    return work


def features(
    design: Design,
    scene: Scene,
    *,
    accuracy: float | None,
    mesh: MeshChoice | None = None,
    errors: Mapping[bool, LevelErrors],
) -> np.ndarray:
    """:data:`FEATURES` of a question, (f,). ``accuracy``: the one asked for (None: the solver's
    own); where a ``mesh`` is asked for it decides about effects only. ``errors``: of massive bodies
    (False) and of those whose chambers stand apart (True).

    Raises :class:`InputError` for a design or mesh that cannot be built.
    """
    asked = ACCURACY if accuracy is None else accuracy
    decided = plan(design, scene, asked)
    linear = not decided.on("finite_strain")
    sizes = mesh_sizes(design, is_half=decided.on("symmetry"), mesh=mesh)
    work = expected_work(
        sizes, None if mesh is not None else asked, errors[sizes.stands_apart], linear=linear
    )
    strain, suction = cell_strain(chamber_row(design), scene)
    share = strain / WALL_STRAIN[design.family]
    touching = ("self_contact", "plate_contact", "cylinder_contact")
    values = {
        "one": 1.0,
        "work": math.log(work / 1e6),
        "coarse": math.log(sizes.coarsest / 5e3),
        "oblique": float(design.family == "oblique"),
        "printed": float(design.family == "printed"),
        "bellows": float(design.family == "bellows"),
        "linear": float(linear),
        "strain": 0.0 if linear else math.log(max(share, 0.02)),
        "large strain": 0.0 if linear else math.log(max(share, 1.0)),
        "suction": float(suction),
        "volume": float(scene.volume_to is not None and not linear),
        "obstacle": float(decided.on("plate_contact") or decided.on("cylinder_contact")),
        "walls meet": float(decided.on("self_contact")),
        "watched": float(any(decided.watched(name) for name in touching)),
        "steps": 0.0 if linear else math.log((scene.steps or 6) / 6),
    }
    return np.array([values[name] for name in FEATURES])
