"""Statements that hands are clear of a machine, and that the button of a jog is still held."""

import sqlalchemy as sa
from alembic import op

revision = "0099b"
down_revision = "0099a"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column(
        "station", sa.Column("hands_clear", sa.Double(), nullable=False, server_default="-1e9")
    )
    op.add_column("operation", sa.Column("renewed", sa.Double(), nullable=True))


def downgrade() -> None:
    op.drop_column("operation", "renewed")
    op.drop_column("station", "hands_clear")
