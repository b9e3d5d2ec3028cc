"""sqlite_copy: copy an SQLite database while other processes write to it.

The copy is made by SQLite's online backup in one step: it shows the database as it was at one
moment, between two transactions.  In the WAL mode, which the store uses, no writer waits for it.
"""

from __future__ import annotations

import os
import sqlite3
from contextlib import closing, suppress
from pathlib import Path

from knifetip.errors import StoreError
from knifetip.service.database.damage import find_damage, is_damaged
from knifetip.service.database.disk_sync import sync

_BUSY = 30.0  # seconds to wait for a lock
#: Ends of the names of files beside a database that contain changes of it.
_LOGS = ("-wal", "-shm", "-journal")


def copy_database(source: Path, target: Path) -> None:
    """Copy a database to a new file, which only its owner can read.

    The file appears under its name when it is complete and on the disk.  An existing file of this
    name is replaced.

    Parameters
    ----------
    source
        File of the database.
    target
        File of the copy, one file without a write-ahead log.

    Raises
    ------
    StoreError
        The copy cannot be made, or the database is damaged; ``target`` is then as it was.
    """
    part = target.with_name(f"{target.name}.part")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        part.unlink(missing_ok=True)
        os.close(os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600))
        with (
            closing(_connect(source)) as original,
            closing(sqlite3.connect(part, timeout=_BUSY)) as copy,
        ):
            original.backup(copy)
            # In WAL mode a reader of the copy would need write access to its folder.
            copy.execute("PRAGMA journal_mode=DELETE")
        # A damaged copy would replace the good ones of earlier days.
        if fault := find_damage(part):
            part.unlink()
            raise StoreError("database.damaged", file=source, reason=fault)
        sync(part)
        part.replace(target)
        sync(target.parent)
    except (OSError, sqlite3.Error) as reason:
        with suppress(OSError):  # the first error is reported
            part.unlink(missing_ok=True)
        if is_damaged(reason):
            raise StoreError("database.damaged", file=source, reason=reason) from reason
        cause = getattr(reason, "strerror", None) or str(reason)
        raise StoreError("backup.unwritable", file=target, reason=cause) from reason


def check_copy(file: Path) -> None:
    """Check the structure of an SQLite database and the references between its tables.

    Raises
    ------
    StoreError
        The file is damaged, or it is no SQLite database.
    """
    try:
        with closing(sqlite3.connect(f"{file.resolve().as_uri()}?mode=ro", uri=True)) as database:
            faults = [row[0] for row in database.execute("PRAGMA integrity_check(1)")]
            if faults != ["ok"]:
                raise StoreError("backup.not-a-backup", file=file, reason=faults[0])
            if row := database.execute("PRAGMA foreign_key_check").fetchone():
                raise StoreError("backup.missing-row", file=file, table=row[0])
    except sqlite3.Error as reason:
        raise StoreError("backup.not-a-backup", file=file, reason=reason) from reason


def require_unused(file: Path) -> bool:
    """Raise an error if another process has opened a database; move its write-ahead log into it.

    Returns
    -------
    bool
        False if the file is damaged or no database; it can then be replaced, but not copied.

    Raises
    ------
    StoreError
        Another process uses the database.
    """
    try:
        with closing(sqlite3.connect(file, timeout=0.5)) as database:
            # SQLite leaves the WAL mode only if no other connection is open.
            database.execute("PRAGMA journal_mode=DELETE")
    except sqlite3.OperationalError as reason:
        raise StoreError("database.in-use", file=file) from reason
    except sqlite3.DatabaseError:
        return False
    return True


def move_away(file: Path, kept: Path) -> None:
    """Rename a database and its logs, as far as there are any.

    A log that remains would be applied to the next database with the name of the file.

    Raises
    ------
    StoreError
        A file cannot be renamed.
    """
    try:
        for end in ("", *_LOGS):
            with suppress(FileNotFoundError):
                file.with_name(file.name + end).rename(kept.with_name(kept.name + end))
    except OSError as reason:
        raise StoreError("backup.unwritable", file=kept, reason=reason.strerror) from reason


def _connect(file: Path) -> sqlite3.Connection:
    return sqlite3.connect(f"{file.resolve().as_uri()}?mode=rw", uri=True, timeout=_BUSY)
