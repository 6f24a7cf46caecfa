"""Every table of the one database. Migrations in ``storage/migrations`` lead up to exactly this."""

from datetime import UTC, datetime
from typing import Any

from sqlalchemy import (
    JSON,
    BigInteger,
    Boolean,
    CheckConstraint,
    Column,
    Dialect,
    Double,
    ForeignKey,
    Index,
    Integer,
    LargeBinary,
    MetaData,
    String,
    Table,
    Text,
    TypeDecorator,
    UniqueConstraint,
    false,
)  # fmt: skip

JOB_STATES = ("queued", "running", "done", "failed", "cancelled")

metadata = MetaData(
    naming_convention={
        "ix": "ix_%(column_0_label)s",
        "uq": "uq_%(table_name)s_%(column_0_name)s",
        "ck": "ck_%(table_name)s_%(constraint_name)s",
        "fk": "fk_%(table_name)s_%(column_0_name)s",
        "pk": "pk_%(table_name)s",
    }
)


class Instant(TypeDecorator[datetime]):
    """A moment, as seconds since 1970 UTC: compares and sorts alike on SQLite and PostgreSQL."""

    impl = Double
    cache_ok = True

    def process_bind_param(self, value: datetime | None, dialect: Dialect) -> float | None:
        return None if value is None else value.timestamp()

    def process_result_value(self, value: Any | None, dialect: Dialect) -> datetime | None:
        return None if value is None else datetime.fromtimestamp(value, UTC)


ID = String(16)
DIGEST = String(64)

design = Table(
    "design", metadata,
    Column("id", ID, primary_key=True),
    Column("name", String(200), nullable=False),
    Column("author", String(200), nullable=False),
    Column("created_at", Instant, nullable=False),
    Column("archived_at", Instant),
    Column("forked_from", ID),
)  # fmt: skip

version = Table(
    "version", metadata,
    Column("id", ID, primary_key=True),
    Column("design_id", ID, ForeignKey("design.id"), nullable=False),
    Column("number", Integer, nullable=False),
    Column("parent_id", ID, ForeignKey("version.id"), index=True),
    Column("author", String(200), nullable=False),
    Column("created_at", Instant, nullable=False),
    Column("note", Text, nullable=False),
    Column("label", String(200)),
    Column("document", JSON, nullable=False),
    Column("scene", JSON, nullable=False),
    Column("design_digest", DIGEST, nullable=False),
    Column("scene_digest", DIGEST, nullable=False),
    UniqueConstraint("design_id", "number"),
)  # fmt: skip

job = Table(
    "job", metadata,
    Column("id", ID, primary_key=True),
    Column("version_id", ID, ForeignKey("version.id"), nullable=False, index=True),
    Column("author", String(200), nullable=False),
    # the question
    Column("scene", JSON, nullable=False),
    Column("rung", String(20), nullable=False),
    Column("accuracy", Double, nullable=False),
    Column("science_version", DIGEST, nullable=False),
    Column("design_digest", DIGEST, nullable=False),
    Column("scene_digest", DIGEST, nullable=False),
    Column("digest", DIGEST, nullable=False, index=True),
    Column("budget_s", Double, nullable=False),
    Column("mesh", String(20)),
    # where it stands
    Column("state", String(12), nullable=False),
    Column("created_at", Instant, nullable=False),
    Column("started_at", Instant),
    Column("finished_at", Instant),
    Column("fraction", Double, nullable=False),
    Column("message", Text, nullable=False),
    Column("pressure", Double),
    Column("outcome", String(20)),
    Column("advice", Text),
    Column("error", Text),
    Column("from_store", Boolean, nullable=False),
    # who computes it: `follows` names the job whose answer this one waits for
    Column("follows", ID, ForeignKey("job.id"), index=True),
    Column("attempt", Integer, nullable=False),
    Column("lost", Integer, nullable=False),
    Column("lease_until", Instant),
    Column("worker", String(200)),
    Column("cancel_requested", Boolean, nullable=False),
    Column("published_at", Instant),
    # of a job that failed: whether the part of the path found by then is its result
    Column("kept_part", Boolean, nullable=False, server_default=false()),
    CheckConstraint(f"state IN {JOB_STATES}", name="state"),
    Index("ix_job_state_created_at", "state", "created_at"),
)  # fmt: skip

# of jobs under way: what is left where their workers vanish
part = Table(
    "part", metadata,
    Column("job_id", ID, ForeignKey("job.id"), primary_key=True),
    Column("attempt", Integer, nullable=False),
    Column("fraction", Double, nullable=False),
    Column("document", JSON, nullable=False),
    Column("arrays", LargeBinary, nullable=False),
)  # fmt: skip

artifact = Table(
    "artifact", metadata,
    Column("sha256", DIGEST, primary_key=True),
    Column("media_type", String(100), nullable=False),
    Column("size", Integer, nullable=False),
    Column("data", LargeBinary, nullable=False),
    Column("created_at", Instant, nullable=False),
)  # fmt: skip

result = Table(
    "result", metadata,
    Column("digest", DIGEST, primary_key=True),
    Column("design_digest", DIGEST, nullable=False),
    Column("scene_digest", DIGEST, nullable=False),
    Column("rung", String(20), nullable=False),
    Column("accuracy", Double, nullable=False),
    Column("science_version", DIGEST, nullable=False),
    Column("outcome", String(20), nullable=False),
    Column("document", JSON, nullable=False),
    Column("artifact_sha256", DIGEST, ForeignKey("artifact.sha256")),
    Column("created_at", Instant, nullable=False),
    Column("mesh", String(20)),
    Column("body_files_sha256", DIGEST, ForeignKey("artifact.sha256")),
    Column("body_files_points", Integer),
    Index("ix_result_design_digest", "design_digest", "scene_digest", "rung"),
)  # fmt: skip

event = Table(
    "event", metadata,
    Column("seq", BigInteger().with_variant(Integer, "sqlite"), primary_key=True),
    Column("at", Instant, nullable=False, index=True),
    Column("kind", String(20), nullable=False),
    Column("subject", ID, nullable=False),
    Column("data", JSON, nullable=False),
    sqlite_autoincrement=True,  # a number is never given twice, also after pruning
)  # fmt: skip

worker = Table(
    "worker", metadata,
    Column("name", String(200), primary_key=True),
    Column("science_version", DIGEST, nullable=False),
    Column("started_at", Instant, nullable=False),
    Column("last_seen", Instant, nullable=False),
)  # fmt: skip
