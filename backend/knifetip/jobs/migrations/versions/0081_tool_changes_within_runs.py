"""Changes of tools within a run, so that the new tool begins with length 0."""

import sqlalchemy as sa
from alembic import op

revision = "0081"
down_revision = "0079"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Migrate to this schema."""
    op.add_column(
        "tool_event", sa.Column("unfinished", sa.Double(), nullable=False, server_default="0")
    )


def downgrade() -> None:
    """Migrate back to the schema before."""
    op.drop_column("tool_event", "unfinished")
