"""The mesh that a question asks for."""

from collections.abc import Sequence

import sqlalchemy as sa
from alembic import op

revision: str = "0002"
down_revision: str | None = "0001"
branch_labels: str | Sequence[str] | None = None
depends_on: str | Sequence[str] | None = None


def upgrade() -> None:
    for table in ("job", "result"):
        op.add_column(table, sa.Column("mesh", sa.String(length=20), nullable=True))
