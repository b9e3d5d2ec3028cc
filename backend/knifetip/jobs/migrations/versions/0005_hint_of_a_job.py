"""Rename what an operator can do about a job's state to the word that users read: hint."""

from alembic import op

revision = "0005"
down_revision = "0004"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.alter_column("job", "mend", new_column_name="hint")


def downgrade() -> None:
    op.alter_column("job", "hint", new_column_name="mend")
