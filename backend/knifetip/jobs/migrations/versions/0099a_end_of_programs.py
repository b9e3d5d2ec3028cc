"""Jobs whose program was handed over, and whose end a person confirms."""

import sqlalchemy as sa
from alembic import op

revision = "0099a"
down_revision = "0100a"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column(
        "job", sa.Column("awaits_end", sa.Boolean(), nullable=False, server_default=sa.false())
    )


def downgrade() -> None:
    op.drop_column("job", "awaits_end")
