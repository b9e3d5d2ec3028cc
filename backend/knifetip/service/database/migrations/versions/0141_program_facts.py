"""Facts about the program of a job."""

import sqlalchemy as sa
from alembic import op

revision = "0141"
down_revision = "0131"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("job", sa.Column("facts", sa.JSON(), nullable=False, server_default="{}"))
