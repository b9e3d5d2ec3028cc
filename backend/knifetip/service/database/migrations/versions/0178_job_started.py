"""Time at which a machine began a job."""

import sqlalchemy as sa
from alembic import op

revision = "0178"
down_revision = "0162"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("job", sa.Column("started", sa.Double(), nullable=False, server_default="0"))
