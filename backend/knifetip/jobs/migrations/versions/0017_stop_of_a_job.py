"""The place where a job stopped, and whether its machine feeds the sheets itself."""

import sqlalchemy as sa
from alembic import op

revision = "0017"
down_revision = "0012"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("job", sa.Column("stopped_at", sa.JSON(none_as_null=True), nullable=True))
    op.add_column(
        "job", sa.Column("feeds", sa.Boolean(), nullable=False, server_default=sa.false())
    )


def downgrade() -> None:
    op.drop_column("job", "feeds")
    op.drop_column("job", "stopped_at")
