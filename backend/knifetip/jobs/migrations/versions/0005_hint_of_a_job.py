"""Rename the column of a job's advice to the operator from mend to hint."""

from alembic import op

revision = "0005"
down_revision = "0004"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.alter_column("job", "mend", new_column_name="hint")


def downgrade() -> None:
    op.alter_column("job", "hint", new_column_name="mend")
