"""Answers under their question's digest, each stored once; their arrays are artifacts."""

from collections.abc import Mapping
from typing import Any

from sqlalchemy import Connection, insert, select, update

from actuators.design import parse_design
from actuators.mechanics.scene import Scene
from storage import tables
from storage.body_files import BodyFiles, BodyFilesKept
from storage.errors import NotFoundError
from storage.question import BROKEN_OFF, OPEN_OUTCOMES
from storage.rows import ResultRow

ARRAYS = "application/x-npz"


class Results(BodyFilesKept):
    """Looking up answers; storing them belongs to finishing a job."""

    def get_result(self, digest: str) -> ResultRow:
        """Answer to the question ``digest`` (``JobRow.digest`` of a job that is done)."""
        with self._read() as connection:
            found = _result(connection, digest)
        if found is None:
            raise NotFoundError("result", digest)
        return found

    def best_result(
        self, document: Mapping[str, Any], scene: Mapping[str, Any], rung: str
    ) -> ResultRow | None:
        """Stored answer of a rung for a design in a scene, whoever asked: the newest of the
        most accurate; one on a mesh that was asked for only where there is no other. It may come
        from an older ``science_version``. Never the part that a cancelled or failed job had
        found."""
        r = tables.result
        query = (
            select(r)
            .where(
                r.c.design_digest == parse_design(document).digest,
                r.c.scene_digest == Scene.from_document(scene).digest,
                r.c.rung == rung,
                r.c.outcome.not_in(("cancelled", *BROKEN_OFF)),
            )
            .order_by(r.c.mesh.is_not(None), r.c.accuracy, r.c.created_at.desc())
            .limit(1)
        )
        with self._read() as connection:
            row = connection.execute(query).mappings().one_or_none()
        return None if row is None else ResultRow(**row)

    def _store_result(
        self, connection: Connection, question: Mapping[str, Any], document: Mapping[str, Any],
        arrays: bytes, body_files: BodyFiles | None = None,
    ) -> ResultRow:  # fmt: skip
        """Keep an answer, unless a closed one is there already: the first one stands."""
        r = tables.result
        digest = question["digest"]
        there = _result(connection, digest)
        if there is not None and there.outcome not in OPEN_OUTCOMES:
            return there
        values: dict[str, Any] = {
            **question,
            "outcome": document["outcome"],
            "document": dict(document),
            "artifact_sha256": self._store_artifact(connection, arrays, ARRAYS),
            "created_at": self._now(connection),
            **self._keep_body_files(connection, digest, body_files),
        }
        if there is None:
            connection.execute(insert(r).values(**values))
        else:
            connection.execute(update(r).where(r.c.digest == digest).values(**values))
        return ResultRow(**values)


def _result(connection: Connection, digest: str) -> ResultRow | None:
    query = select(tables.result).where(tables.result.c.digest == digest)
    row = connection.execute(query).mappings().one_or_none()
    return None if row is None else ResultRow(**row)


def closed_result(connection: Connection, digest: str) -> ResultRow | None:
    """Answer that settles the question: not one that was cut short by budget or cancel."""
    found = _result(connection, digest)
    return None if found is None or found.outcome in OPEN_OUTCOMES else found
