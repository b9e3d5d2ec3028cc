"""Keys of compiles, and the job whose program another job has."""

import sqlalchemy as sa
from alembic import op

revision = "0089"
down_revision = "0085c"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column(
        "job", sa.Column("compile_key", sa.String(64), nullable=False, server_default="")
    )
    op.add_column("job", sa.Column("program_of", sa.String(32), nullable=False, server_default=""))
    op.create_index("job_by_compile_key", "job", ["compile_key", "serial"])


def downgrade() -> None:
    op.drop_index("job_by_compile_key", "job")
    op.drop_column("job", "program_of")
    op.drop_column("job", "compile_key")
