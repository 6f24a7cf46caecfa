"""Designs and their history: versions form a tree, are never changed and never repeated."""

from collections.abc import Mapping
from typing import Any

from sqlalchemy import Connection, RowMapping, Select, func, insert, or_, select, update

from actuators.design import parse_design
from actuators.mechanics.scene import Scene
from storage import tables
from storage.database import new_id
from storage.errors import HistoryError, NotFoundError
from storage.events import Events
from storage.rows import DesignRow, VersionRow

_NAME_LENGTH = 200


class Designs(Events):
    """Keeping designs: create, change, name, fork, archive, look up."""

    def create_design(
        self,
        name: str,
        author: str,
        document: Mapping[str, Any],
        scene: Mapping[str, Any],
        note: str = "",
    ) -> tuple[DesignRow, VersionRow]:
        """New design with its first version. Raises InputError, and stores nothing, for a
        document or a scene that cannot be used."""
        content = _content(document, scene)
        name = _checked_name(name, "name")
        with self._write() as connection:
            design_id = self._insert_design(connection, name, author, forked_from=None)
            version_id = self._insert_version(connection, design_id, None, author, note, content)
            return _design(connection, design_id), _version(connection, version_id)

    def add_version(
        self,
        design_id: str,
        parent_id: str | None,
        author: str,
        document: Mapping[str, Any],
        scene: Mapping[str, Any],
        note: str = "",
    ) -> VersionRow:
        """New version after ``parent_id`` (the newest one if None).

        Content equal to the parent's, or to a version that already follows this parent, makes no
        new version: the one there is comes back, so that saving twice is harmless.
        """
        content = _content(document, scene)
        with self._write() as connection:
            design = _design(connection, design_id)
            parent = _version(connection, parent_id or design.latest_version_id)
            if parent.design_id != design_id:
                raise HistoryError(
                    f"parent_version_id is {parent.id!r}, a version of another design.",
                    field="parent_version_id", value=parent.id,
                    mend="Name a version of this design, or fork the other one.",
                )  # fmt: skip
            same = _same_content(connection, parent, content)
            if same is not None:
                return same
            version_id = self._insert_version(
                connection, design_id, parent.id, author, note, content
            )
            return _version(connection, version_id)

    def fork(self, version_id: str, name: str, author: str) -> tuple[DesignRow, VersionRow]:
        """New design that starts from a version of another one and remembers which."""
        name = _checked_name(name, "name")
        with self._write() as connection:
            origin = _version(connection, version_id)
            content = {
                key: getattr(origin, key)
                for key in ("document", "scene", "design_digest", "scene_digest")
            }
            design_id = self._insert_design(connection, name, author, forked_from=version_id)
            first = self._insert_version(
                connection, design_id, None, author, f"Forked from version {origin.number}", content
            )
            return _design(connection, design_id), _version(connection, first)

    def rename(self, design_id: str, name: str) -> DesignRow:
        """Give a design another name; its history stays."""
        name = _checked_name(name, "name")
        return self._change_design(design_id, "renamed", name=name)

    def archive(self, design_id: str, *, archived: bool = True) -> DesignRow:
        """Take a design out of the list, or put it back. Nothing is deleted."""
        with self._read() as connection:
            if _design(connection, design_id).archived == archived:
                return _design(connection, design_id)
            now = self._now(connection)
        what = "archived" if archived else "restored"
        return self._change_design(design_id, what, archived_at=now if archived else None)

    def name_version(self, version_id: str, label: str | None) -> VersionRow:
        """Label a version ("moulded in March"); None or blank takes the label away."""
        label = _checked_name(label, "label") if label and label.strip() else None
        with self._write() as connection:
            row = _version(connection, version_id)
            connection.execute(
                update(tables.version).where(tables.version.c.id == version_id).values(label=label)
            )
            self._history(connection, row.design_id, "labelled", version_id)
            return _version(connection, version_id)

    def list_designs(self, search: str = "", *, archived: bool = False) -> list[DesignRow]:
        """Designs whose name or author holds ``search``, last changed first; ``archived`` lists
        the archived ones instead."""
        d = tables.design.c
        condition = d.archived_at.is_not(None) if archived else d.archived_at.is_(None)
        query = _designs().where(condition)
        for word in search.split():
            query = query.where(
                or_(d.name.icontains(word, autoescape=True),
                    d.author.icontains(word, autoescape=True))
            )  # fmt: skip
        query = query.order_by(tables.version.c.created_at.desc(), d.id)
        with self._read() as connection:
            return [_design_row(row) for row in connection.execute(query).mappings()]

    def get_design(self, design_id: str) -> DesignRow:
        """Raises NotFoundError for an unknown id, as every ``get_...`` does."""
        with self._read() as connection:
            return _design(connection, design_id)

    def list_versions(self, design_id: str) -> list[VersionRow]:
        """History of a design, oldest first."""
        v = tables.version
        with self._read() as connection:
            _design(connection, design_id)
            query = select(v).where(v.c.design_id == design_id).order_by(v.c.number)
            return [VersionRow(**row) for row in connection.execute(query).mappings()]

    def get_version(self, version_id: str) -> VersionRow:
        with self._read() as connection:
            return _version(connection, version_id)

    def _insert_design(
        self, connection: Connection, name: str, author: str, *, forked_from: str | None
    ) -> str:
        design_id = new_id()
        connection.execute(
            insert(tables.design).values(
                id=design_id, name=name, author=author, forked_from=forked_from,
                created_at=self._now(connection),
            )
        )  # fmt: skip
        return design_id

    def _insert_version(
        self,
        connection: Connection,
        design_id: str,
        parent_id: str | None,
        author: str,
        note: str,
        content: Mapping[str, Any],
    ) -> str:
        v = tables.version
        version_id = new_id()
        last = select(func.max(v.c.number)).where(v.c.design_id == design_id)
        number = (connection.execute(last).scalar_one() or 0) + 1
        connection.execute(
            insert(v).values(
                id=version_id, design_id=design_id, number=number, parent_id=parent_id,
                author=author, created_at=self._now(connection), note=note.strip(), **content,
            )
        )  # fmt: skip
        self._history(connection, design_id, "version", version_id)
        return version_id

    def _change_design(self, design_id: str, what: str, **values: Any) -> DesignRow:
        with self._write() as connection:
            _design(connection, design_id)
            connection.execute(
                update(tables.design).where(tables.design.c.id == design_id).values(**values)
            )
            self._history(connection, design_id, what, None)
            return _design(connection, design_id)

    def _history(
        self, connection: Connection, design_id: str, what: str, version_id: str | None
    ) -> None:
        data = {"what": what, "version_id": version_id}
        self._record(connection, "history", design_id, data)


def _content(document: Mapping[str, Any], scene: Mapping[str, Any]) -> dict[str, Any]:
    design, surroundings = parse_design(document), Scene.from_document(scene)
    return {
        "document": design.to_document(), "design_digest": design.digest,
        "scene": surroundings.to_document(), "scene_digest": surroundings.digest,
    }  # fmt: skip


def _same_content(
    connection: Connection, parent: VersionRow, content: Mapping[str, Any]
) -> VersionRow | None:
    v = tables.version
    query = select(v).where(
        or_(v.c.id == parent.id, v.c.parent_id == parent.id),
        v.c.design_digest == content["design_digest"],
        v.c.scene_digest == content["scene_digest"],
    )
    row = connection.execute(query.order_by(v.c.number)).mappings().first()
    return None if row is None else VersionRow(**row)


def _checked_name(name: str, field: str) -> str:
    name = " ".join(name.split())
    if not name or len(name) > _NAME_LENGTH:
        raise HistoryError(
            f"{field} has {len(name)} characters; it must have 1 to {_NAME_LENGTH}.",
            field=field, value=name[:40], mend=f"Give a {field} of 1 to {_NAME_LENGTH} characters.",
        )  # fmt: skip
    return name


def _designs() -> Select[Any]:
    """Every design with its newest version."""
    d, v = tables.design, tables.version
    newest = (
        select(v.c.design_id, func.max(v.c.number).label("version_count"))
        .group_by(v.c.design_id)
        .subquery()
    )
    return (
        select(
            d,
            v.c.id.label("latest_version_id"),
            v.c.created_at.label("updated_at"),
            v.c.document,
            newest.c.version_count,
        )
        .join(newest, newest.c.design_id == d.c.id)
        .join(v, (v.c.design_id == d.c.id) & (v.c.number == newest.c.version_count))
    )


def _design_row(row: RowMapping) -> DesignRow:
    values = dict(row)
    return DesignRow(family=values.pop("document")["family"], **values)


def _design(connection: Connection, design_id: str) -> DesignRow:
    query = _designs().where(tables.design.c.id == design_id)
    row = connection.execute(query).mappings().one_or_none()
    if row is None:
        raise NotFoundError("design", design_id)
    return _design_row(row)


def _version(connection: Connection, version_id: str) -> VersionRow:
    query = select(tables.version).where(tables.version.c.id == version_id)
    row = connection.execute(query).mappings().one_or_none()
    if row is None:
        raise NotFoundError("version", version_id)
    return VersionRow(**row)
