"""What the operator confirms before a job starts, its tools, and whose report counts last."""

import sqlalchemy as sa
from alembic import op

revision = "0004"
down_revision = "0003"
branch_labels = None
depends_on = None

ON_TABLE = sa.text("state IN ('running', 'held', 'interrupted')")
RESERVES_TABLE = sa.text(
    "state IN ('running', 'held', 'interrupted') OR (state = 'queued' AND confirmation <> '')"
)


def _index(where: sa.TextClause) -> None:
    op.create_index(
        "one_job_on_a_table",
        "job",
        ["machine"],
        unique=True,
        sqlite_where=where,
        postgresql_where=where,
    )


def upgrade() -> None:
    op.add_column(
        "job", sa.Column("owner_epoch", sa.Integer(), nullable=False, server_default="0")
    )
    op.add_column(
        "job", sa.Column("confirmation", sa.String(8), nullable=False, server_default="")
    )
    op.add_column("job", sa.Column("tools", sa.JSON(), nullable=False, server_default="[]"))
    # What is on a table was started by an operator: its next copy waits for one, too.
    op.execute(
        "UPDATE job SET confirmation = 'given', owner_epoch = epoch"
        " WHERE state IN ('running', 'held')"
    )
    op.drop_index("one_job_on_a_table", "job")
    _index(RESERVES_TABLE)


def downgrade() -> None:
    op.drop_index("one_job_on_a_table", "job")
    _index(ON_TABLE)
    for column in ("tools", "confirmation", "owner_epoch"):
        op.drop_column("job", column)
