"""Reports of gateways on their machines, and operations of persons at the machines."""

import sqlalchemy as sa
from alembic import op

revision = "0013"
down_revision = "0015"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "station",
        sa.Column("machine", sa.String(200), primary_key=True),
        sa.Column("gateway", sa.String(200), nullable=False),
        sa.Column("reported", sa.Double(), nullable=False),
        sa.Column("watched", sa.Double(), nullable=False),
        sa.Column("connected", sa.Boolean(), nullable=False),
        sa.Column("state", sa.String(16), nullable=False),
        sa.Column("alarm", sa.JSON(none_as_null=True), nullable=True),
        sa.Column("position", sa.JSON(none_as_null=True), nullable=True),
        sa.Column("outputs", sa.JSON(), nullable=False),
        sa.Column("operations", sa.JSON(), nullable=False),
    )
    op.create_table(
        "operation",
        sa.Column(
            "serial",
            sa.BigInteger().with_variant(sa.Integer(), "sqlite"),
            primary_key=True,
            autoincrement=True,
        ),
        sa.Column("id", sa.String(32), nullable=False, unique=True),
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("request", sa.JSON(), nullable=False),
        sa.Column("state", sa.String(8), nullable=False),
        sa.Column("message", sa.JSON(none_as_null=True), nullable=True),
        sa.Column("asked", sa.Double(), nullable=False),
        sa.Column("handed", sa.Double(), nullable=True),
    )
    op.create_index("operation_by_state", "operation", ["machine", "state"])


def downgrade() -> None:
    op.drop_table("operation")
    op.drop_table("station")
