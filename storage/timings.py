"""How long jobs have taken, for predictions; and every answer to one question."""

from collections.abc import Mapping
from typing import Any

from sqlalchemy import RowMapping, or_, select

from actuators.design import parse_design
from actuators.mechanics.scene import Scene
from storage import tables
from storage.database import Database
from storage.question import OPEN_OUTCOMES
from storage.rows import ResultRow, TimingRow

STOPPED = ("cancelled", "budget_spent")


class Timings(Database):
    """What past jobs tell about the next one."""

    def recent_timings(
        self, rung: str, *, host: str | None = None, limit: int = 100
    ) -> list[TimingRow]:
        """The latest jobs of a rung that a worker computed to an end, or was stopped at by somebody
        or by its budget, newest first. ``host``: only those of workers on that machine."""
        j, r = tables.job.c, tables.result.c
        query = (
            select(
                r.digest, r.document, r.accuracy, r.mesh, r.outcome, j.worker, j.finished_at,
            )
            .select_from(tables.job.join(tables.result, r.digest == j.digest))
            .where(
                j.rung == rung, ~j.from_store, j.follows.is_(None), j.finished_at.is_not(None),
                or_(
                    (j.state == "done") & r.outcome.not_in(OPEN_OUTCOMES), r.outcome.in_(STOPPED)
                ),
            )
            .order_by(j.finished_at.desc(), j.id)
            .limit(limit)
        )  # fmt: skip
        if host is not None:
            # a job that somebody stopped has lost its worker
            there = j.worker.endswith(f"@{host}", autoescape=True)
            query = query.where(or_(there, j.worker.is_(None)))
        with self._read() as connection:
            rows = connection.execute(query).mappings().all()
        # a question that was stopped and asked again has one result
        latest: dict[str, RowMapping] = {}
        for row in rows:
            latest.setdefault(row["digest"], row)
        return [
            TimingRow(
                digest=row["digest"],
                design=row["document"]["design"],
                scene=row["document"]["scene"],
                accuracy=row["accuracy"],
                mesh=row["mesh"],
                seconds=_seconds(row["document"]),
                unknowns=int(row["document"].get("unknowns") or 0),
                estimates_percent=dict(row["document"].get("error_estimates_percent") or {}),
                outcome=row["outcome"],
                stopped=row["outcome"] in STOPPED,
                worker=row["worker"],
                finished_at=row["finished_at"],
            )
            for row in latest.values()
            if row["document"].get("wall_s")
        ]

    def results_of(self, document: Mapping[str, Any], scene: Mapping[str, Any]) -> list[ResultRow]:
        """Every stored answer for a design in a scene, of every rung, newest first; some may come
        from an older ``science_version``."""
        r = tables.result
        query = (
            select(r)
            .where(
                r.c.design_digest == parse_design(document).digest,
                r.c.scene_digest == Scene.from_document(scene).digest,
            )
            .order_by(r.c.created_at.desc())
        )
        with self._read() as connection:
            return [ResultRow(**row) for row in connection.execute(query).mappings()]


def _seconds(document: Mapping[str, Any]) -> float:
    """On the clock or of the processor, whichever is less."""
    wall, cpu = float(document["wall_s"]), document.get("cpu_s")
    return min(wall, float(cpu)) if cpu else wall
