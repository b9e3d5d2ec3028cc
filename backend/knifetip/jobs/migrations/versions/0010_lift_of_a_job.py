"""The height of the tool in turns of a job."""

import sqlalchemy as sa
from alembic import op

revision = "0010"
down_revision = "0009"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column(
        "job", sa.Column("lift", sa.String(16), nullable=False, server_default="clearance")
    )


def downgrade() -> None:
    op.drop_column("job", "lift")
