"""Links the processes of one database: each has a name of its own, and wakes the others.

The name of a process must be the same after a restart, so that it takes back its compiles at once.
Two running processes cannot have one name.  ``join`` reserves the name until the process
ends: with a session of PostgreSQL that holds an advisory lock (``postgres_link``), or with a lock
on a file beside a SQLite database.
"""

from __future__ import annotations

import os
import re
import secrets
import socket
import sqlite3
from contextlib import suppress
from itertools import count
from pathlib import Path
from typing import Protocol

import sqlalchemy as sa

from knifetip.errors import StoreError
from knifetip.service.database.change_notifier import ChangeNotifier


class ProcessLink(Protocol):
    """The name of this process, and its connection to the other processes of the database."""

    @property
    def name(self) -> str:
        """Name of this process, which no other running process has."""

    def close(self) -> None:
        """End the connection; other processes may reserve the name then."""


def join(url: str, changes: ChangeNotifier, name: str, role: str) -> ProcessLink:
    """Reserve a name for this process, and connect it to the other processes of its database.

    Parameters
    ----------
    url
        URL of the database, with the name of its driver.
    changes
        Notifier of this process; with PostgreSQL it is connected to those of other processes.
    name
        Name of this process; "" for the name of the computer and a random suffix, which is stored
        in the folder of the database or of the user's state.
    role
        Kind of process, such as "server": a default name is not shared between kinds.

    Raises
    ------
    StoreError
        A running process has this name.
    """
    if name:
        link = _try_name(url, changes, name)
        if link is None:
            raise StoreError("process.name-taken", name=name)
        return link
    host = socket.gethostname()
    for number in count(1):
        own = f"{host}-{_stored_suffix(_state_folder(url) / f'{role}-{number}.id')}"
        link = _try_name(url, changes, own)
        if link is not None:
            return link
    raise AssertionError("unreachable")


def _try_name(url: str, changes: ChangeNotifier, name: str) -> ProcessLink | None:
    if url.startswith("postgresql"):
        from knifetip.service.database.postgres_link import PostgresLink

        return PostgresLink.try_name(url, changes, name)
    return FileLink.try_name(sa.make_url(url).database or "", name)


def _state_folder(url: str) -> Path:
    """Return the folder with the names of the processes of a database."""
    parts = sa.make_url(url)
    if parts.get_backend_name() == "sqlite" and parts.database:
        path = Path(parts.database)
        return path.with_name(f"{path.name}.processes")
    state = os.environ.get("XDG_STATE_HOME")
    folder = Path(state) if state else Path.home() / ".local" / "state"
    place = re.sub(r"[^A-Za-z0-9._-]+", "-", f"{parts.host} {parts.port or ''} {parts.database}")
    return folder / "knifetip" / f"{place[-100:]}.processes"


def _stored_suffix(path: Path) -> str:
    """Return the random suffix in a file, which is created if it does not exist.

    If it cannot be created, the suffix is a new one at each start.
    """
    suffix = secrets.token_hex(4)
    with suppress(OSError):  # a folder that cannot be written to
        path.parent.mkdir(parents=True, exist_ok=True)
        draft = path.with_suffix(f".{suffix}")
        draft.write_text(suffix, "ascii")
        # Unlike renaming, linking fails if another process has created the file meanwhile.
        with suppress(FileExistsError):
            os.link(draft, path)
        draft.unlink()
    with suppress(OSError):  # not created, see above
        return path.read_text("ascii") or suffix
    return suffix


class FileLink:
    """The name of a process with a SQLite database: a lock on a file, which ends with the process.

    The file is itself a SQLite database, whose locks work on every system and are not inherited by
    worker processes.
    """

    def __init__(self, name: str, lock: sqlite3.Connection) -> None:
        self._name = name
        self._lock = lock

    @classmethod
    def try_name(cls, database: str, name: str) -> FileLink | None:
        """Return a link with a name, None if a running process has it."""
        folder = _state_folder(f"sqlite:///{database}")
        folder.mkdir(parents=True, exist_ok=True)
        file = re.sub(r"[^A-Za-z0-9._-]", lambda other: f"%{ord(other[0]):x}", name)
        lock = sqlite3.connect(
            folder / f"{file}.lock", timeout=0.0, isolation_level=None, check_same_thread=False
        )
        try:
            lock.execute("BEGIN EXCLUSIVE")
        except sqlite3.OperationalError:
            lock.close()
            return None
        return cls(name, lock)

    @property
    def name(self) -> str:
        """Name of this process."""
        return self._name

    def close(self) -> None:
        """End the connection; other processes may reserve the name then."""
        self._lock.close()
