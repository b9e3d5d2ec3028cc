"""What a machine does for a person while a job waits: a run above the board."""

import sqlalchemy as sa
from alembic import op

revision = "0079"
down_revision = "0018"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("station", sa.Column("activity", sa.JSON(none_as_null=True), nullable=True))


def downgrade() -> None:
    op.drop_column("station", "activity")
