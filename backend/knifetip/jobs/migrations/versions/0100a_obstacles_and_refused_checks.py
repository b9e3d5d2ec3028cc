"""Obstacles of stations, and programs that the check run of a machine has refused."""

import sqlalchemy as sa
from alembic import op

revision = "0100a"
down_revision = "0103a"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("station", sa.Column("obstacle", sa.JSON(), nullable=True))
    op.add_column("job", sa.Column("check_refusal", sa.JSON(), nullable=True))


def downgrade() -> None:
    op.drop_column("job", "check_refusal")
    op.drop_column("station", "obstacle")
