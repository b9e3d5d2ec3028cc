"""Limits of API keys, owners of drawings and webhooks, times of changes, and answered requests."""

import sqlalchemy as sa
from alembic import op

revision = "0103a"
down_revision = "0101a"
branch_labels = None
depends_on = None

COLUMNS: tuple[tuple[str, sa.Column[object]], ...] = (
    ("api_key", sa.Column("customer", sa.String(200), nullable=False, server_default="")),
    ("api_key", sa.Column("machines", sa.JSON(), nullable=False, server_default="[]")),
    # Keys of gateways that exist are for any machine, new ones are bound.
    ("api_key", sa.Column("any_machine", sa.Boolean(), nullable=False, server_default=sa.true())),
    ("drawing", sa.Column("owner", sa.String(80), nullable=False, server_default="")),
    ("drawing", sa.Column("shared", sa.Boolean(), nullable=False, server_default=sa.false())),
    ("drawing", sa.Column("updated", sa.Double(), nullable=False, server_default="0")),
    ("job", sa.Column("claimed_by", sa.String(80), nullable=False, server_default="")),
    ("webhook", sa.Column("owner", sa.String(80), nullable=False, server_default="")),
    ("webhook", sa.Column("customer", sa.String(200), nullable=False, server_default="")),
    ("webhook", sa.Column("machines", sa.JSON(), nullable=False, server_default="[]")),
)
INDEXES = (
    ("drawing_by_created", "drawing", ["created"]),
    ("drawing_by_updated", "drawing", ["updated"]),
    ("job_by_created", "job", ["created"]),
    ("job_by_updated", "job", ["updated"]),
)


def upgrade() -> None:
    for table, column in COLUMNS:
        op.add_column(table, column)
    op.execute("UPDATE drawing SET updated = created")
    for name, table, columns in INDEXES:
        op.create_index(name, table, columns)
    op.create_table(
        "answered_request",
        sa.Column("key", sa.String(200), primary_key=True),
        sa.Column("fingerprint", sa.String(64), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("status", sa.Integer(), nullable=False),
        sa.Column("headers", sa.JSON(), nullable=False),
        sa.Column("body", sa.LargeBinary(), nullable=False),
    )
    op.create_index("answered_request_by_time", "answered_request", ["created"])


def downgrade() -> None:
    op.drop_table("answered_request")
    for name, table, _ in INDEXES:
        op.drop_index(name, table)
    for table, column in reversed(COLUMNS):
        op.drop_column(table, column.name)
