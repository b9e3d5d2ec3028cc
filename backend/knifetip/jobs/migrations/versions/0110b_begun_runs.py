"""Whether a line of a program may have been executed since its job was claimed."""

import sqlalchemy as sa
from alembic import op

revision = "0110b"
down_revision = "0110a"
branch_labels = None
depends_on = None


def upgrade() -> None:
    # Of jobs that run now it is not known.
    op.add_column(
        "job", sa.Column("begun", sa.Boolean(), nullable=False, server_default=sa.true())
    )


def downgrade() -> None:
    op.drop_column("job", "begun")
