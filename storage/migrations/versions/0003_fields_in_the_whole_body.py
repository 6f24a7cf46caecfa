"""Fields in the whole body, beside a result."""

from collections.abc import Sequence

import sqlalchemy as sa
from alembic import op

revision: str = "0003"
down_revision: str | None = "0002"
branch_labels: str | Sequence[str] | None = None
depends_on: str | Sequence[str] | None = None


def upgrade() -> None:
    files = sa.Column("body_files_sha256", sa.String(length=64), nullable=True)
    if op.get_bind().dialect.name == "sqlite":
        # SQLite takes a foreign key with a new column, and not afterwards
        op.execute(
            "ALTER TABLE result ADD COLUMN body_files_sha256 VARCHAR(64) "
            "CONSTRAINT fk_result_body_files_sha256 REFERENCES artifact (sha256)"
        )
    else:
        op.add_column("result", files)
        op.create_foreign_key(
            op.f("fk_result_body_files_sha256"), "result", "artifact",
            ["body_files_sha256"], ["sha256"],
        )  # fmt: skip
    op.add_column("result", sa.Column("body_files_points", sa.Integer(), nullable=True))
