"""What the worker of a job has found so far. It is replaced as the job goes on, leaves when the job
ends with an answer, and is its result where it ends without one."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from sqlalchemy import Connection, delete, insert, select

from storage import tables
from storage.body_files import BodyFiles
from storage.results import Results
from storage.rows import JobRow, ResultRow


@dataclass(frozen=True)
class Part:
    """The part of a path that was found by now, as ``predict --json`` prints it, its arrays
    (:func:`storage.response_arrays.pack`), and how far its solver was (0 to 1)."""

    document: Mapping[str, Any]
    arrays: bytes
    fraction: float


class Parts(Results):
    """One part for each job under way that has found anything."""

    def _keep_part(self, connection: Connection, job_id: str, attempt: int, part: Part) -> None:
        """A later attempt starts from the beginning: what an earlier one found stays until it has
        come as far."""
        p = tables.part
        before = connection.execute(
            select(p.c.attempt, p.c.fraction).where(p.c.job_id == job_id)
        ).first()
        if before and before.attempt != attempt and before.fraction > part.fraction:
            return
        self._drop_part(connection, job_id)
        connection.execute(
            insert(p).values(
                job_id=job_id, attempt=attempt, fraction=part.fraction,
                document=dict(part.document), arrays=part.arrays,
            )
        )  # fmt: skip

    def _drop_part(self, connection: Connection, job_id: str) -> None:
        connection.execute(delete(tables.part).where(tables.part.c.job_id == job_id))

    def _part_as_result(
        self, connection: Connection, job: JobRow, outcome: str,
        advice: Callable[[Mapping[str, Any]], str],
    ) -> Mapping[str, Any] | None:  # fmt: skip
        """Make the part that a job has found its result; its document, None where there is none.
        ``advice`` is told of the part."""
        p = tables.part.c
        found = connection.execute(
            select(p.document, p.arrays).where(p.job_id == job.id)
        ).one_or_none()
        if found is None:
            return None
        self._drop_part(connection, job.id)
        document = {**found.document, "outcome": outcome, "advice": advice(found.document)}
        self._store_answer(connection, job, document, found.arrays, None)
        return document

    def _store_answer(
        self, connection: Connection, job: JobRow, document: Mapping[str, Any], arrays: bytes,
        body_files: BodyFiles | None,
    ) -> ResultRow:  # fmt: skip
        names = ("digest", "design_digest", "scene_digest", "rung", "accuracy", "mesh")
        question = {name: getattr(job, name) for name in (*names, "science_version")}
        return self._store_result(connection, question, document, arrays, body_files)


def kept_in_words(part: Mapping[str, Any]) -> str:
    """That a part is kept, and how far it goes."""
    unit, last, asked = _end(part)
    if came_to_its_end(part) or last is None or asked is None:
        return "The path found on a coarser mesh than asked for is kept."
    return f"The part of the path found by then, up to {last:.3g} of {asked:.3g} {unit}, is kept."


def run_again(part: Mapping[str, Any]) -> str:
    """How to have what is missing."""
    missing = "the accuracy asked for" if came_to_its_end(part) else "the rest of the path"
    return f"Run it again for {missing}; it starts from the beginning."


def came_to_its_end(part: Mapping[str, Any]) -> bool:
    """Whether only finer meshes are missing."""
    if not part["path"]:
        return False
    _, last, asked = _end(part)
    return last is not None and asked is not None and math.isclose(last, asked, rel_tol=1e-6)


def _end(part: Mapping[str, Any]) -> tuple[str, float | None, float | None]:
    """Unit of what is in control, where the part ends and where the scene's path would."""
    volume = part["scene"].get("volume_ml")
    key, unit = ("volume_ml", "ml") if volume else ("pressure_kPa", "kPa")
    last = part["path"][-1]["cavity_volume_ml" if volume else "pressure_kPa"]
    return unit, last, (part["scene"].get(key) or {}).get("to")
