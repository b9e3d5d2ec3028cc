"""Details of orders on drawings and jobs: numbers of other systems, customer, due, metadata."""

import sqlalchemy as sa
from alembic import op

revision = "0085"
down_revision = "0090"
branch_labels = None
depends_on = None

_TABLES = ("drawing", "job")
_COLUMNS = ("external_id", "customer", "due", "notes", "metadata")
_SERIAL = sa.BigInteger().with_variant(sa.Integer(), "sqlite")


def upgrade() -> None:
    """Migrate to this schema."""
    for table in _TABLES:
        for column in (
            sa.Column("external_id", sa.String(200), nullable=False, server_default=""),
            sa.Column("customer", sa.String(200), nullable=False, server_default=""),
            sa.Column("due", sa.Double(), nullable=True),
            sa.Column("notes", sa.Text(), nullable=False, server_default=""),
            sa.Column("metadata", sa.JSON(), nullable=False, server_default="{}"),
        ):
            op.add_column(table, column)
        op.create_index(f"{table}_by_external_id", table, ["external_id", "serial"])
        op.create_index(f"{table}_by_customer", table, ["customer", "serial"])
        op.create_index(f"{table}_by_due", table, ["due"])
        op.create_table(
            f"{table}_metadata",
            sa.Column("token", sa.String(40), primary_key=True),
            sa.Column(
                "owner",
                _SERIAL,
                sa.ForeignKey(f"{table}.serial", ondelete="CASCADE"),
                primary_key=True,
            ),
        )
        op.create_index(f"{table}_metadata_by_owner", f"{table}_metadata", ["owner"])


def downgrade() -> None:
    """Migrate back to the schema before."""
    for table in _TABLES:
        op.drop_table(f"{table}_metadata")
        for name in ("external_id", "customer", "due"):
            op.drop_index(f"{table}_by_{name}", table)
        for name in _COLUMNS:
            op.drop_column(table, name)
