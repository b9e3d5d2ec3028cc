"""A row that health checks change, to check whether the database can be written to."""

import sqlalchemy as sa
from alembic import op

revision = "0084"
down_revision = "0086"
branch_labels = None
depends_on = None


def upgrade() -> None:
    table = op.create_table(
        "write_probe",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("id"),
    )
    op.bulk_insert(table, [{"id": 1, "at": 0.0}])


def downgrade() -> None:
    op.drop_table("write_probe")
