"""Asking a rung within a budget, on a body or a mesh that no design would give."""

from dataclasses import replace

import numpy as np

from actuators.geometry import build_body
from actuators.hard_cases.case import Budget
from actuators.hard_cases.question import SEED, Question
from actuators.mechanics.response import Response
from actuators.meshing import HexMesh, mesh_body
from actuators.meshing.hex_mesh import Faces
from actuators.meshing.levels import layers_of

EVERY_EFFECT = 1e-4
"""Accuracy asked for where the mesh is chosen: no effect is left out for being small."""
BUSY = 8.0
"""How much longer than its processor time a run may take where others use the machine."""


def ask(asked: Question, budget: Budget) -> Response:
    """Answer of the question's rung; a run of the 3D solver ends with the budget."""
    if asked.rung != "fe":
        from actuators.mechanics.predict import predict

        return predict(asked.design, asked.scene, rung=asked.rung)
    if asked.shuffled:
        return _on_shuffled_mesh(asked)
    from actuators.mechanics.continuum.progress import Budget as Allowance
    from actuators.mechanics.continuum.progress import Monitor
    from actuators.mechanics.continuum.solve import solve_with_states

    monitor = Monitor(
        budget=Allowance(BUSY * budget.seconds, budget.iterations, budget.memory_mib * 2**20)
    )
    if asked.accuracy is not None:
        found = solve_with_states(asked.design, asked.scene, monitor, accuracy=asked.accuracy)
    else:
        found = solve_with_states(
            asked.design, asked.scene, monitor, accuracy=EVERY_EFFECT, mesh=asked.mesh or "coarse"
        )
    return found.response


def _on_shuffled_mesh(asked: Question) -> Response:
    from actuators.mechanics.continuum.goal import Goal
    from actuators.mechanics.continuum.level import open_level
    from actuators.mechanics.continuum.path import PathFollower
    from actuators.mechanics.continuum.recovery import Answer, recover
    from actuators.mechanics.effects import plan

    chosen = plan(asked.design, asked.scene, EVERY_EFFECT)
    body = build_body(asked.design)
    body = body.half() if chosen.on("symmetry") else body
    mesh = shuffled(mesh_body(body, layers=layers_of(body, asked.mesh or "coarse")))
    level = open_level(mesh, chosen.applied)
    path = PathFollower(level.system, level.solver).reach(
        Goal.of(asked.scene, is_half=mesh.is_half)
    )
    answer = Answer(level.system, path, {}, path.iterations, None, len(path.points), chosen=True)
    return recover(asked.design, asked.scene, answer, EVERY_EFFECT, plan=chosen)


def shuffled(mesh: HexMesh) -> HexMesh:
    """The same mesh with its nodes and elements in another order (the arrays laid out in memory as
    the mesh's own are: the kernels are compiled for that)."""
    rng = np.random.default_rng(SEED)
    node, element = (rng.permutation(len(x)) for x in (mesh.nodes, mesh.elements))
    new_node, new_element = np.argsort(node), np.argsort(element)

    def faces(old: Faces) -> Faces:
        return Faces(
            element=new_element[old.element].astype(old.element.dtype), local=old.local,
            nodes=new_node[old.nodes].astype(old.nodes.dtype),
        )  # fmt: skip

    return replace(
        mesh,
        nodes=mesh.nodes[node],
        node_index=mesh.node_index[node],
        elements=np.asfortranarray(new_node[mesh.elements[element]], dtype=mesh.elements.dtype),
        region=mesh.region[element],
        box=np.asfortranarray(mesh.box[element]),
        cavity_faces=faces(mesh.cavity_faces),
        outer_faces=faces(mesh.outer_faces),
        symmetry_faces=faces(mesh.symmetry_faces),
        membrane_faces=faces(mesh.membrane_faces),
    )
