"""Jobs that continue the work of another job, or make it again."""

import sqlalchemy as sa
from alembic import op

revision = "0014"
down_revision = "0013"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column("job", sa.Column("resumes", sa.String(32), nullable=True))
    op.add_column("job", sa.Column("rest", sa.JSON(none_as_null=True), nullable=True))
    op.create_index("ix_job_resumes", "job", ["resumes"])


def downgrade() -> None:
    op.drop_index("ix_job_resumes", "job")
    op.drop_column("job", "rest")
    op.drop_column("job", "resumes")
