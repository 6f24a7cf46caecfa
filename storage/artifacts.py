"""Bytes under their hash, each stored once."""

import hashlib
from typing import Any

from sqlalchemy import Connection, insert, select

from storage import tables
from storage.database import Database
from storage.errors import NotFoundError


class Artifacts(Database):
    """Keeping bytes, and handing them out."""

    def get_artifact(self, sha256: str) -> bytes:
        """Stored bytes, for instance ``ResultRow.artifact_sha256``; read them with
        :func:`storage.response_arrays.unpack`."""
        return self._column(sha256, "data")

    def artifact_size(self, sha256: str) -> int:
        """Bytes that :meth:`get_artifact` gives."""
        return self._column(sha256, "size")

    def _column(self, sha256: str, name: str) -> Any:
        a = tables.artifact.c
        with self._read() as connection:
            found = connection.execute(
                select(a[name]).where(a.sha256 == sha256)
            ).scalar_one_or_none()
        if found is None:
            raise NotFoundError("artifact", sha256)
        return found

    def _store_artifact(self, connection: Connection, data: bytes, media_type: str) -> str:
        sha256 = hashlib.sha256(data).hexdigest()
        a = tables.artifact
        if connection.execute(select(a.c.sha256).where(a.c.sha256 == sha256)).first() is None:
            connection.execute(
                insert(a).values(
                    sha256=sha256, media_type=media_type, size=len(data), data=data,
                    created_at=self._now(connection),
                )
            )  # fmt: skip
        return sha256
