"""The contexts of the traces to which jobs and deliveries of webhooks belong."""

import sqlalchemy as sa
from alembic import op

revision = "0097"
down_revision = "0094"
branch_labels = None
depends_on = None

TABLES = ("job", "webhook_delivery")


def upgrade() -> None:
    for table in TABLES:
        op.add_column(
            table, sa.Column("traceparent", sa.String(55), nullable=False, server_default="")
        )


def downgrade() -> None:
    for table in TABLES:
        op.drop_column(table, "traceparent")
