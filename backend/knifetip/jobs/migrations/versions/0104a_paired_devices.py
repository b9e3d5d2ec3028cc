"""Browsers that are paired with a machine, and the codes with which they are paired."""

import sqlalchemy as sa
from alembic import op

revision = "0104a"
down_revision = "0099b"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column(
        "api_key", sa.Column("device", sa.Boolean(), nullable=False, server_default=sa.false())
    )
    op.create_table(
        "pairing_code",
        sa.Column("digest", sa.String(64), primary_key=True),
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("created_by", sa.String(200), nullable=False),
        sa.Column("expires", sa.Double(), nullable=False),
    )


def downgrade() -> None:
    op.drop_table("pairing_code")
    # A former version would accept the secret of a device as that of a program.
    op.execute(sa.text("DELETE FROM api_key WHERE device"))
    op.drop_column("api_key", "device")
