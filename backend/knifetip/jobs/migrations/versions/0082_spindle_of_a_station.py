"""The station whose spindle a person has switched on by hand."""

import sqlalchemy as sa
from alembic import op

revision = "0082"
down_revision = "0081"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("station", sa.Column("spindle", sa.Integer(), nullable=True))


def downgrade() -> None:
    op.drop_column("station", "spindle")
