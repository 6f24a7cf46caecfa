"""Fields in the whole body, beside answers of 3D finite elements: large, so that only the newest
are kept. An answer is complete without them."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sqlalchemy import Connection, delete, func, select, update

from storage import tables
from storage.artifacts import Artifacts

BODY_FILES_AT_MOST = 32_000_000
"""Bytes for one answer: a path of 12 points on some 50,000 unknowns, or one on half a million."""
BODY_FILES_IN_ALL = 1_000_000_000
"""Bytes for all answers; beyond them the oldest leave."""
ZIP = "application/zip"


@dataclass(frozen=True)
class BodyFiles:
    """Fields in the whole body as one zip, of so many of the path's points."""

    zipped: bytes
    points: int


class BodyFilesKept(Artifacts):
    """Keeping the newest."""

    body_files_in_all = BODY_FILES_IN_ALL

    def _keep_body_files(
        self, connection: Connection, digest: str, files: BodyFiles | None
    ) -> Mapping[str, Any]:
        """Columns of the result ``digest``, whose earlier files leave. The older of other results
        leave as well, where all would take too much."""
        r, a = tables.result.c, tables.artifact.c
        self._drop(connection, r.digest == digest)
        if files is None:
            return {"body_files_sha256": None, "body_files_points": None}
        sha256 = self._store_artifact(connection, files.zipped, ZIP)
        room = self.body_files_in_all - len(files.zipped)
        # by the results' dates: an artifact's own lies behind its bytes, all of which SQLite reads
        kept = (
            select(r.digest, a.size)
            .join_from(tables.result, tables.artifact, a.sha256 == r.body_files_sha256)
            .order_by(r.created_at.desc())
        )
        for each in connection.execute(kept).all():
            room -= each.size
            if room < 0:
                self._drop(connection, r.digest == each.digest, but=sha256)
        return {"body_files_sha256": sha256, "body_files_points": files.points}

    def _drop(self, connection: Connection, which: Any, but: str | None = None) -> None:
        r, a = tables.result, tables.artifact
        found = connection.execute(select(r.c.body_files_sha256).where(which)).scalars().all()
        connection.execute(
            update(r).where(which).values(body_files_sha256=None, body_files_points=None)
        )
        for sha256 in {each for each in found if each is not None} - {but}:
            users = select(func.count()).where(r.c.body_files_sha256 == sha256)
            if not connection.execute(users).scalar_one():
                connection.execute(delete(a).where(a.c.sha256 == sha256))
