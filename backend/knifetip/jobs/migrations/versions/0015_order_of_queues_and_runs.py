"""The order of queues, the end of a job, the runs of machines, and the wear of their tools."""

import sqlalchemy as sa
from alembic import op

revision = "0015"
down_revision = "0011"
branch_labels = None
depends_on = None

SERIAL = sa.BigInteger().with_variant(sa.Integer(), "sqlite")
ENDED = "('done', 'refused', 'interrupted', 'scrapped', 'cancelled')"


def upgrade() -> None:
    op.add_column("job", sa.Column("rank", sa.Double(), nullable=False, server_default="0"))
    op.add_column(
        "job", sa.Column("on_hold", sa.Boolean(), nullable=False, server_default=sa.false())
    )
    op.add_column("job", sa.Column("ended", sa.Double(), nullable=False, server_default="0"))
    op.add_column("job", sa.Column("lengths", sa.LargeBinary(), nullable=True))
    op.execute("UPDATE job SET rank = queued")
    op.execute(f"UPDATE job SET ended = updated WHERE state IN {ENDED}")
    op.create_index("job_by_end", "job", ["ended"])
    op.create_table(
        "machine_run",
        sa.Column("id", SERIAL, primary_key=True, autoincrement=True),
        sa.Column("job", sa.String(32), nullable=False),
        sa.Column("epoch", sa.Integer(), nullable=False),
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("board", sa.String(200), nullable=False),
        sa.Column("started", sa.Double(), nullable=False),
        sa.Column("ended", sa.Double(), nullable=False),
        sa.Column("outcome", sa.String(16), nullable=False),
        sa.Column("copies", sa.Integer(), nullable=False),
        sa.Column("sheets", sa.Integer(), nullable=False),
        sa.UniqueConstraint("job", "epoch", name="one_run_of_a_claim"),
    )
    op.create_index("run_by_end", "machine_run", ["machine", "ended"])
    op.create_table(
        "run_length",
        sa.Column(
            "run",
            SERIAL,
            sa.ForeignKey("machine_run.id", ondelete="CASCADE"),
            primary_key=True,
        ),
        sa.Column("station", sa.Integer(), primary_key=True),
        sa.Column("line_type", sa.String(16), primary_key=True),
        sa.Column("length", sa.Double(), nullable=False),
    )
    op.create_table(
        "tool_event",
        sa.Column("id", SERIAL, primary_key=True, autoincrement=True),
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("station", sa.Integer(), nullable=False),
        sa.Column("kind", sa.String(8), nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.Column("who", sa.String(200), nullable=False),
        sa.Column("length", sa.Double(), nullable=False),
    )
    op.create_index("tool_event_by_machine", "tool_event", ["machine", "station"])


def downgrade() -> None:
    for table in ("tool_event", "run_length", "machine_run"):
        op.drop_table(table)
    op.drop_index("job_by_end", "job")
    for column in ("lengths", "ended", "on_hold", "rank"):
        op.drop_column("job", column)
