"""Files that need a scene: the finite-element model as a deck, and its answer as fields."""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from actuators.design.base import Design
from actuators.mechanics.scene import Scene

if TYPE_CHECKING:
    from actuators.mechanics.continuum import Progress


@dataclass(frozen=True)
class ModelQuestion:
    """What a model file is made for. ``mesh``: a name or layers, see
    :mod:`actuators.mechanics.continuum.levels`; None takes "medium" for a deck and refines to
    ``accuracy`` for an answer. ``element``: type in an ``inp`` deck."""

    scene: Scene
    mesh: str | tuple[int, int, int] | None = None
    element: str = "C3D20R"
    accuracy: float = 0.05
    progress: "Callable[[Progress], None] | None" = None
    cancelled: Callable[[], bool] | None = None


def write_model(design: Design, what: str, question: ModelQuestion) -> dict[str, bytes]:
    """Files of one kind of :data:`MODEL_KINDS` by name."""
    return _WRITERS[what](design, question)


def _deck(design: Design, question: ModelQuestion) -> dict[str, bytes]:
    # meshing and solving load compiled kernels: only when asked for
    from actuators.export.inp import abaqus_deck
    from actuators.geometry import build_body
    from actuators.materials import material
    from actuators.mechanics.continuum.levels import layers_of
    from actuators.meshing import mesh_body

    body = build_body(design)
    if body.symmetric and question.scene.symmetric:
        body = body.half()
    mesh = mesh_body(body, layers=layers_of(body, question.mesh or "medium"))
    materials = [material(region.material) for region in mesh.regions]
    return abaqus_deck(design, mesh, materials, question.scene, question.element)


def _fields(design: Design, question: ModelQuestion) -> dict[str, bytes]:
    """``answer.pvd``, ``answer-000.vtu`` onwards, and ``answer.json``: how the path ended."""
    from actuators.export.vtu import series
    from actuators.mechanics.continuum.progress import Monitor
    from actuators.mechanics.continuum.solve import solve_with_states
    from actuators.mechanics.continuum.volume_fields import VolumeFields

    monitor = Monitor(question.progress, question.cancelled, None)
    solution = solve_with_states(
        design, question.scene, monitor, accuracy=question.accuracy, mesh=question.mesh
    )
    system, path = solution.answer.system, solution.answer.path
    fields = VolumeFields(system)
    regions = [region.name for region in system.mesh.regions]
    title = f"{design.title}, design {design.digest[:12]}, scene {question.scene.digest[:12]}"
    document = json.dumps(solution.response.to_document(), indent=2).encode() + b"\n"
    files = series(fields.mesh, regions, fields.states(path.points), title)
    return {**files, "answer.json": document}


_WRITERS: Mapping[str, Callable[[Design, ModelQuestion], dict[str, bytes]]] = {
    "inp": _deck,
    "vtu": _fields,
}
MODEL_KINDS: tuple[str, ...] = tuple(_WRITERS)
