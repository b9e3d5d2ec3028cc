"""Profiles that customers keep, and the rules that drawings and jobs were made with."""

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "profile",
        sa.Column("name", sa.String(64), nullable=False),
        sa.Column("title", sa.String(200), nullable=False),
        sa.Column("text", sa.Text(), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("updated", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("name"),
    )
    for table in ("drawing", "job"):
        op.add_column(table, sa.Column("rules", sa.Text(), nullable=False, server_default=""))


def downgrade() -> None:
    for table in ("drawing", "job"):
        op.drop_column(table, "rules")
    op.drop_table("profile")
