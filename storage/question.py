"""The question a result answers: (design, scene, rung, accuracy, version of the science, mesh)."""

import hashlib
import json
import math
import re
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Literal

from actuators.errors import QuestionError

# rungs that workers compute; `worker.rungs` has one solver for each
JOB_RUNGS = ("fe", "cell-rod", "energy", "closed-form")
DEFAULT_BUDGET_S = 2 * 3600.0
# ends of a job that nobody asked for; its result is the part of the path found by then
BROKEN_OFF = ("failed", "worker_lost")
# what leaves the answer open: such a result is shown, but the same question is computed again
OPEN_OUTCOMES = ("cancelled", "budget_spent", *BROKEN_OFF)
# how a job ends without an answer, or with what its worker had found by then: the question cannot
# be solved, the solver broke down, its workers vanished, or one step did not fit into the time
Failure = Literal["refused", "failed", "worker_lost", "budget_spent"]

_SCIENCE = ("design", "materials", "geometry", "meshing", "mechanics")
# predicts what answers cost, and decides none
_NO_ANSWER = ("mechanics/ladder",)


def question_digest(
    design_digest: str,
    scene_digest: str,
    rung: str,
    accuracy: float,
    science_version: str,
    mesh: str | None = None,
) -> str:
    """sha256 that names a question; equal questions have equal answers."""
    parts: list[object] = [design_digest, scene_digest, rung, float(accuracy), science_version]
    if mesh is not None:
        parts.append(mesh)
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()


def check_question(rung: str, accuracy: object) -> None:
    """Raise :class:`QuestionError` for a rung or an accuracy that no worker can serve."""
    if rung not in JOB_RUNGS:
        raise QuestionError(
            f"rung is {rung!r}; jobs compute one of {', '.join(JOB_RUNGS)}.",
            field="rung", value=repr(rung), mend=f"Use one of {', '.join(JOB_RUNGS)}.",
        )  # fmt: skip
    if (
        isinstance(accuracy, bool)
        or not isinstance(accuracy, (int, float))
        or not math.isfinite(accuracy)
        or not 0.001 <= accuracy <= 0.5
    ):
        raise QuestionError(
            f"accuracy is {accuracy!r}; it must lie between 0.001 (0.1 %) and 0.5 (50 %).",
            field="accuracy", value=repr(accuracy), mend="For example 0.05, five per cent.",
        )  # fmt: skip


MESHES = ("coarse", "medium", "fine", "finest")
_LAYERS = re.compile(r"[0-3],[0-3],[0-3]")


def check_mesh(mesh: object, rung: str) -> None:
    """Raise :class:`QuestionError` for a mesh that no worker can make; None is the worker's choice.

    A name, or thin layers along X1, X2 and X3 as in ``1,0,1``.
    """
    if mesh is None:
        return
    mend = f"Use {', '.join(MESHES)}, or layers along X1, X2, X3 such as 1,0,1."
    if rung != "fe":
        raise QuestionError(
            f"mesh is {mesh!r}, but the rung {rung} has none.",
            field="mesh", value=repr(mesh), mend="Leave the mesh out.",
        )  # fmt: skip
    if not isinstance(mesh, str) or not (mesh in MESHES or _LAYERS.fullmatch(mesh)):
        raise QuestionError(
            f"mesh is {mesh!r}; it is a name or three numbers of layers from 0 to 3. {mend}",
            field="mesh", value=repr(mesh), mend=mend,
        )  # fmt: skip


@cache
def science_version() -> str:
    """sha256 of the sources that decide an answer: a changed formula never finds old answers."""
    content = hashlib.sha256()
    root = files("actuators")
    for room in _SCIENCE:
        for name, source in _sources(root / room, room):
            content.update(f"{name}\0{len(source)}\0".encode())
            content.update(source)
    return content.hexdigest()


def _sources(folder: Traversable, name: str) -> list[tuple[str, bytes]]:
    found: list[tuple[str, bytes]] = []
    for entry in sorted(folder.iterdir(), key=lambda e: e.name):
        path = f"{name}/{entry.name}"
        if entry.is_dir() and entry.name != "__pycache__" and path not in _NO_ANSWER:
            found.extend(_sources(entry, path))
        elif entry.name.endswith(".py"):
            found.append((path, entry.read_bytes()))
    return found
