"""Rename what an operator has requested of a job's gateway: requested_action."""

from alembic import op

revision = "0006"
down_revision = "0005"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.alter_column("job", "wish", new_column_name="requested_action")


def downgrade() -> None:
    op.alter_column("job", "requested_action", new_column_name="wish")
