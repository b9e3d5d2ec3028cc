"""Outputs of stations that are not known, because the gateway was started during an alarm."""

import sqlalchemy as sa
from alembic import op

revision = "0110a"
down_revision = "0110"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column(
        "station",
        sa.Column("outputs_known", sa.Boolean(), nullable=False, server_default=sa.true()),
    )


def downgrade() -> None:
    op.drop_column("station", "outputs_known")
