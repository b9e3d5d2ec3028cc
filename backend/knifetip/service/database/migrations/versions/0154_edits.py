"""Edits of the geometry of drawings."""

import sqlalchemy as sa
from alembic import op

revision = "0154"
down_revision = "0150"
branch_labels = None
depends_on = None


def upgrade() -> None:
    for table in ("drawing", "job"):
        op.add_column(table, sa.Column("edits", sa.JSON, nullable=False, server_default="[]"))
