"""Files that need a scene: the finite-element model as a deck, and its answer as fields."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from actuators.design.base import Design
from actuators.mechanics.scene import Scene

if TYPE_CHECKING:
    from actuators.export.inp_inflation import Inflation
    from actuators.mechanics.continuum import Progress


@dataclass(frozen=True)
class ModelQuestion:
    """What a model file is made for. ``mesh``: a name or layers, see
    :mod:`actuators.mechanics.continuum.levels`; None takes "medium" for a deck and refines to
    ``accuracy`` for an answer. ``element``: type in an ``inp`` deck. ``solving``: whether a deck
    may take a solve, which it needs where a scene prescribes a volume; ``solved``: that solve's
    answer, as ``Response.to_document`` gives it, where there is one."""

    scene: Scene
    mesh: str | tuple[int, int, int] | None = None
    element: str = "C3D20R"
    accuracy: float = 0.05
    progress: "Callable[[Progress], None] | None" = None
    cancelled: Callable[[], bool] | None = None
    solving: bool = False
    solved: Mapping[str, Any] | None = None


def write_model(design: Design, what: str, question: ModelQuestion) -> dict[str, bytes]:
    """Files of one kind of :data:`MODEL_KINDS` by name."""
    return _WRITERS[what](design, question)


def _deck(design: Design, question: ModelQuestion) -> dict[str, bytes]:
    # meshing and solving load compiled kernels: only when asked for
    from actuators.export.inp import abaqus_deck
    from actuators.geometry import build_body
    from actuators.materials import material
    from actuators.mechanics.continuum.levels import layers_of
    from actuators.mechanics.effects import without_layer
    from actuators.mechanics.effects.obeyed import without_loads_off
    from actuators.meshing import mesh_body

    scene = without_loads_off(question.scene)
    kept = None
    if scene.choice("inextensible_layer") == "off":
        kept = without_layer(design)
    body = build_body(kept or design)
    if body.symmetric and scene.symmetric and scene.choice("symmetry") != "off":
        body = body.half()
    mesh = mesh_body(body, layers=layers_of(body, question.mesh or "medium"))
    materials = [material(region.material) for region in mesh.regions]
    inflation = None
    if scene.volume_to is not None:
        inflation = _inflation(design, question)
    return abaqus_deck(design, mesh, materials, scene, question.element, inflation)


def _inflation(design: Design, question: ModelQuestion) -> "Inflation":
    """The pressures that lead to a prescribed volume: of the answer there is, else solved for on
    the deck's mesh."""
    from actuators.export.inp_inflation import SolvedPath, inflation_found, needs_a_solve

    if question.solved is not None:
        return inflation_found(SolvedPath.of_document(question.solved))
    if not question.solving:
        raise needs_a_solve()
    from actuators.mechanics.continuum.solve import solve

    return inflation_found(
        SolvedPath.of(
            solve(
                design, question.scene, mesh=question.mesh or "medium",
                progress=question.progress, cancelled=question.cancelled,
            )
        )
    )  # fmt: skip


def _fields(design: Design, question: ModelQuestion) -> dict[str, bytes]:
    from actuators.export.whole_body import WholeBody
    from actuators.mechanics.continuum.progress import Monitor
    from actuators.mechanics.continuum.solve import solve_with_states

    monitor = Monitor(question.progress, question.cancelled, None)
    solution = solve_with_states(
        design, question.scene, monitor, accuracy=question.accuracy, mesh=question.mesh
    )
    return WholeBody(solution).files()


_WRITERS: Mapping[str, Callable[[Design, ModelQuestion], dict[str, bytes]]] = {
    "inp": _deck,
    "vtu": _fields,
}
MODEL_KINDS: tuple[str, ...] = tuple(_WRITERS)
