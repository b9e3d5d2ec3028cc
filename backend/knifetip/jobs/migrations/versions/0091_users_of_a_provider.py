"""Users who sign in at a provider of OpenID Connect."""

import sqlalchemy as sa
from alembic import op

revision = "0091"
down_revision = "0092"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.add_column(
        "user_account",
        sa.Column("kind", sa.String(16), nullable=False, server_default="password"),
    )
    op.add_column("user_account", sa.Column("subject", sa.String(64), nullable=True))
    op.create_index("user_account_by_subject", "user_account", ["subject"], unique=True)
    op.create_table(
        "used_sign_in",
        sa.Column("digest", sa.String(64), primary_key=True),
        sa.Column("at", sa.Double(), nullable=False),
    )


def downgrade() -> None:
    op.drop_table("used_sign_in")
    op.drop_index("user_account_by_subject", "user_account")
    op.drop_column("user_account", "subject")
    op.drop_column("user_account", "kind")
