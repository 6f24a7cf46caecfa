"""Files that need a scene: the finite-element model as a deck."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from actuators.design.base import Design
from actuators.mechanics.scene import Scene


@dataclass(frozen=True)
class ModelQuestion:
    """What a model file is made for. ``mesh``: a name or layers, see
    :mod:`actuators.mechanics.continuum.levels`; ``element``: type in an ``inp`` deck."""

    scene: Scene
    mesh: str | tuple[int, int, int] | None = None
    element: str = "C3D20R"


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


_WRITERS: Mapping[str, Callable[[Design, ModelQuestion], dict[str, bytes]]] = {"inp": _deck}
MODEL_KINDS: tuple[str, ...] = tuple(_WRITERS)
