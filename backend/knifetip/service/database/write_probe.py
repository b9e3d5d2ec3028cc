"""A real write to the database: its disk is not full, and it is not a read-only replica."""

from __future__ import annotations

import sqlalchemy as sa

from knifetip.service.database.engine import Database
from knifetip.service.database.tables import WriteProbe


def write_probe(database: Database) -> None:
    """Change a row of the database and commit it; raises the error of the database."""
    with database.writing(urgent=True) as session:
        session.execute(sa.update(WriteProbe).values(at=database.clock()))
