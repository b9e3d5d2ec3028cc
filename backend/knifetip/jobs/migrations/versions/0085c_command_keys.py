"""Keys of commands, so that a repeated command changes nothing."""

import sqlalchemy as sa
from alembic import op

revision = "0085c"
down_revision = "0083"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Migrate to this schema."""
    op.create_table(
        "command_key",
        sa.Column("key", sa.String(200), primary_key=True),
        sa.Column("fingerprint", sa.String(64), nullable=False),
        sa.Column(
            "job", sa.String(32), sa.ForeignKey("job.id", ondelete="CASCADE"), nullable=False
        ),
        sa.Column("created", sa.Double(), nullable=False),
    )
    op.create_index("command_key_by_job", "command_key", ["job"])


def downgrade() -> None:
    """Migrate back to the schema before."""
    op.drop_table("command_key")
