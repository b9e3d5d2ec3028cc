"""Rows of the edges because of which a job was refused."""

import sqlalchemy as sa
from alembic import op

revision = "0117"
down_revision = "0110b"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("job", sa.Column("edges", sa.JSON(), nullable=False, server_default="[]"))


def downgrade() -> None:
    op.drop_column("job", "edges")
