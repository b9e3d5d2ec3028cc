"""damage: find out whether the file of a database is damaged, or cannot be used at all.

A damaged SQLite file answers most queries, because each reads few pages; SQLite's own check reads
all of them.
"""

from __future__ import annotations

import errno
import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Final

import sqlalchemy as sa

from knifetip.errors import StoreError

#: Basic result codes of SQLite, without those of the extended ones.
_DAMAGED: Final = (sqlite3.SQLITE_CORRUPT, sqlite3.SQLITE_NOTADB)
_BASIC: Final = 0xFF
#: Class of the SQLSTATEs of PostgreSQL for damaged data and indices.
_DAMAGED_STATE: Final = "XX00"
_DISK_FULL: Final = "53100"  # SQLSTATE of PostgreSQL
_BUSY: Final = 30.0  # seconds to wait for a lock


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


def is_damaged(error: BaseException) -> bool:
    """Return whether a database has refused a request because its file is damaged.

    Parameters
    ----------
    error
        The error of SQLAlchemy or of the driver.
    """
    cause = error.orig if isinstance(error, sa.exc.DBAPIError) else error
    code = getattr(cause, "sqlite_errorcode", None)
    if code is not None:
        return code & _BASIC in _DAMAGED
    state = getattr(cause, "sqlstate", None) or ""
    return state in (f"{_DAMAGED_STATE}1", f"{_DAMAGED_STATE}2")


def find_damage(file: Path) -> str:
    """Return the first fault that SQLite finds in a database file; "" if it finds none.

    All pages are read (``PRAGMA quick_check``), which takes about a second per gigabyte.

    Raises
    ------
    sqlite3.Error
        The file cannot be opened or read.
    """
    try:
        with closing(
            sqlite3.connect(f"{file.resolve().as_uri()}?mode=ro", uri=True, timeout=_BUSY)
        ) as database:
            (fault,) = database.execute("PRAGMA quick_check(1)").fetchone()
    except sqlite3.DatabaseError as reason:
        if is_damaged(reason):
            return str(reason)
        raise
    return "" if fault == "ok" else str(fault)


def require_undamaged(file: Path) -> None:
    """Raise ``StoreError`` if a database file is damaged."""
    if fault := find_damage(file):
        raise StoreError("database.damaged", file=file, reason=fault)


def unusable(error: sa.exc.SQLAlchemyError) -> StoreError:
    """Return the error that states in one sentence why a database cannot be used."""
    cause = error.orig if isinstance(error, sa.exc.DBAPIError) and error.orig else error
    reason = str(cause).strip().partition("\n")[0]
    if is_damaged(error):
        return StoreError("server.database-damaged")
    if is_disk_full(error):
        return StoreError("limit.disk-full")
    return StoreError("database.unusable", reason=reason)
