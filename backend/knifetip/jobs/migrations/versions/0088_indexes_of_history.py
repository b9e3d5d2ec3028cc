"""Indexes with which no step of the queue takes longer with more ended jobs."""

from alembic import op

revision = "0088"
down_revision = "0084"
branch_labels = None
depends_on = None

ADDED = (
    ("job_by_state_serial", "job", ["state", "serial"]),
    ("drawing_by_sha256", "drawing", ["sha256"]),
    ("run_by_end_of_all", "machine_run", ["ended"]),
    ("run_by_machine", "machine_run", ["machine", "id"]),
)


def upgrade() -> None:
    for name, table, columns in ADDED:
        op.create_index(name, table, columns)
    op.drop_index("job_by_end", "job")
    op.create_index("job_by_end", "job", ["ended", "serial"])


def downgrade() -> None:
    op.drop_index("job_by_end", "job")
    op.create_index("job_by_end", "job", ["ended"])
    for name, table, _ in ADDED:
        op.drop_index(name, table)
