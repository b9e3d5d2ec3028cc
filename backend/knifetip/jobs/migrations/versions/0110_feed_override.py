"""The feed override of a controller."""

import sqlalchemy as sa
from alembic import op

revision = "0110"
down_revision = "0104a"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("station", sa.Column("override", sa.Integer(), nullable=True))


def downgrade() -> None:
    op.drop_column("station", "override")
