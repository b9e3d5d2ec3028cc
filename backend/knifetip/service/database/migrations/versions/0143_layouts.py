"""Drawings that were composed from a layout."""

import sqlalchemy as sa
from alembic import op

revision = "0143"
down_revision = "0141"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("drawing", sa.Column("layout", sa.JSON(none_as_null=True), nullable=True))
