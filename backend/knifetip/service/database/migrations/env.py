"""env: lets Alembic work on the connection that the store hands over, in its transaction."""

from __future__ import annotations

from alembic import context

from knifetip.service.database.tables import Base

context.configure(
    connection=context.config.attributes["connection"],
    target_metadata=Base.metadata,
    # SQLite cannot alter a column in place: Alembic makes the table anew there.
    render_as_batch=True,
)
context.run_migrations()
