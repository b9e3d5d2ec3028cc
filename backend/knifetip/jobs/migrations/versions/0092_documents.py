"""Large JSON answers about drawings and jobs."""

import sqlalchemy as sa
from alembic import op

revision = "0092"
down_revision = "0089"
branch_labels = None
depends_on = None

SERIAL = sa.BigInteger().with_variant(sa.Integer(), "sqlite")


def upgrade() -> None:
    for owner in ("drawing", "job"):
        op.create_table(
            f"{owner}_document",
            sa.Column("owner", SERIAL, nullable=False),
            sa.Column("kind", sa.String(40), nullable=False),
            sa.Column("version", sa.String(200), nullable=False),
            sa.Column("content", sa.LargeBinary(), nullable=False),
            sa.ForeignKeyConstraint(["owner"], [f"{owner}.serial"], ondelete="CASCADE"),
            sa.PrimaryKeyConstraint("owner", "kind"),
        )


def downgrade() -> None:
    for owner in ("drawing", "job"):
        op.drop_table(f"{owner}_document")
