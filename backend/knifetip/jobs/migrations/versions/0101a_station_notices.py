"""Notices of stations: why the controller is not connected, and differences of its settings."""

import sqlalchemy as sa
from alembic import op

revision = "0101a"
down_revision = "0098"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("station", sa.Column("notices", sa.JSON(), nullable=False, server_default="[]"))


def downgrade() -> None:
    op.drop_column("station", "notices")
