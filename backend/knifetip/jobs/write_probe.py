"""A real write to the database: its disk is not full, and it is not a read-only replica."""

from __future__ import annotations

import errno
import sqlite3
from typing import Final

import sqlalchemy as sa

from knifetip.jobs.database import Database
from knifetip.jobs.tables import WriteProbe

_DISK_FULL: Final = "53100"  # SQLSTATE of PostgreSQL


def is_disk_full(error: BaseException) -> bool:
    """Return whether the database or the system refused a write because a disk is full.

    Parameters
    ----------
    error
        The error of SQLAlchemy, of the driver or of the system.
    """
    if isinstance(error, OSError):
        return error.errno in (errno.ENOSPC, errno.EDQUOT)
    cause = error.orig if isinstance(error, sa.exc.DBAPIError) else error
    code = getattr(cause, "sqlite_errorcode", None)
    return code == sqlite3.SQLITE_FULL or getattr(cause, "sqlstate", None) == _DISK_FULL


def write_probe(database: Database) -> None:
    """Change a row of the database and commit it; raises the error of the database."""
    with database.writing(urgent=True) as session:
        session.execute(sa.update(WriteProbe).values(at=database.clock()))
