"""Running sums of the lengths that the stations of machines have worked."""

import sqlalchemy as sa
from alembic import op

revision = "0098"
down_revision = "0097"
branch_labels = None
depends_on = None

LENGTHS = "run_length JOIN machine_run ON machine_run.id = run_length.run"


def upgrade() -> None:
    op.create_table(
        "tool_work",
        sa.Column("machine", sa.String(200), primary_key=True),
        sa.Column("station", sa.Integer(), primary_key=True, autoincrement=False),
        sa.Column("length", sa.Double(), nullable=False),
    )
    op.execute(
        "INSERT INTO tool_work (machine, station, length)"
        f" SELECT machine_run.machine, run_length.station, sum(run_length.length) FROM {LENGTHS}"
        " WHERE machine_run.ended > 0 GROUP BY machine_run.machine, run_length.station"
    )
    op.add_column(
        "tool_event", sa.Column("worked_before", sa.Double(), nullable=False, server_default="0")
    )
    op.execute(
        "UPDATE tool_event SET worked_before = COALESCE((SELECT sum(run_length.length)"
        f" FROM {LENGTHS} WHERE machine_run.machine = tool_event.machine"
        " AND run_length.station = tool_event.station AND machine_run.ended > 0"
        " AND machine_run.ended <= tool_event.at), 0) WHERE kind = 'changed'"
    )


def downgrade() -> None:
    op.drop_column("tool_event", "worked_before")
    op.drop_table("tool_work")
