"""Connection to SQLite or PostgreSQL: transactions, and migration of the tables."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, cast

import sqlalchemy as sa
from sqlalchemy import event as on
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.orm import Session

from knifetip.errors import StoreError
from knifetip.service.database import schema
from knifetip.service.database.acting import add_audit_entry
from knifetip.service.database.change_notifier import ChangeNotifier
from knifetip.service.database.damage import find_damage
from knifetip.service.database.schema import Migration, Schema
from knifetip.service.database.shared_clock import SharedClock
from knifetip.service.database.sqlite_copy import copy_database
from knifetip.service.database.tables import Base
from knifetip.service.database.url import add_options, sqlite_file
from knifetip.service.database.write_lock import NoLock, PriorityLock

_TOPICS = "topics"  # key of a session's topics in ``Session.info``


def _sqlite(engine: sa.Engine, file: Path) -> None:
    @on.listens_for(engine, "do_connect")
    def create_private(*_arguments: object) -> None:
        # SQLite would let all users of the computer read a new file, which contains secrets of
        # webhooks.  The files beside it get its permissions.
        with suppress(OSError):  # it exists, or the driver reports the error
            os.close(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600))

    @on.listens_for(engine, "connect")
    def connect(connection: Any, _record: object) -> None:
        # ``begin`` below begins transactions.  By default the driver begins them only before the
        # first write, so that rows could change between reading and writing.
        connection.isolation_level = None
        connection.execute("PRAGMA busy_timeout=30000")
        connection.execute("PRAGMA journal_mode=WAL")
        connection.execute("PRAGMA synchronous=FULL")
        connection.execute("PRAGMA foreign_keys=ON")

    @on.listens_for(engine, "begin")
    def begin(connection: sa.Connection) -> None:
        writes = connection.get_execution_options().get("writes", False)
        connection.exec_driver_sql("BEGIN IMMEDIATE" if writes else "BEGIN")


def _close_late(engine: sa.Engine, closed: threading.Event) -> None:
    """Close connections that are returned after the engine was disposed of.

    They would stay open in the old pool until the garbage collector finds it.
    """

    @on.listens_for(engine, "checkin")
    def close(_connection: object, record: Any) -> None:
        if closed.is_set():
            record.close()


def _check(url: str) -> Path | None:
    """Create the folder of an SQLite database; return its file, or None for PostgreSQL."""
    file = sqlite_file(url)
    if file is not None:
        try:
            file.parent.mkdir(parents=True, exist_ok=True)
        except OSError as reason:
            raise StoreError(
                "database.folder-unusable", folder=file.parent, reason=reason.strerror
            ) from reason
    return file


def dialect_url(url: str) -> str:
    """Return a database URL in the form that SQLAlchemy needs.

    In the URL of a PostgreSQL database, the name of the driver (psycopg) is added to the scheme;
    URLs of other databases are returned unchanged.
    """
    for scheme in ("postgresql://", "postgres://"):
        if url.startswith(scheme):
            return "postgresql+psycopg://" + url.removeprefix(scheme)
    return url


class Database:
    """Connections to one database; safe to use from several threads and processes.

    Parameters
    ----------
    url
        ``sqlite:///FILE`` or ``postgresql://USER@HOST/NAME``.
    clock
        Returns the seconds since 1970.  None for the one clock that all processes with this
        database share: that of the PostgreSQL server, or of the computer with the SQLite file.

    Attributes
    ----------
    timer
        Clock for durations, which all processes with this database share.  Unlike ``clock``, it
        does not jump when the clock of the computer is set.
    """

    def __init__(self, url: str, clock: Callable[[], float] | None = None) -> None:
        self.url = dialect_url(url)
        self.changes = ChangeNotifier()
        file = _check(self.url)
        self._engine = sa.create_engine(add_options(self.url), pool_size=10, max_overflow=40)
        self._closed = threading.Event()
        _close_late(self._engine, self._closed)
        self._write_lock: PriorityLock | NoLock = NoLock()
        if file is not None:
            _sqlite(self._engine, file)
            self._write_lock = PriorityLock()
            self.clock = clock or time.time
            self.timer = clock or time.monotonic
        else:
            self.timer = self.clock = clock or SharedClock(self.server_time)
        self._writer = self._engine.execution_options(writes=True)

    def schema(self) -> Schema:
        """Return the revision of the tables, and the newest one of this version."""
        with self._engine.connect() as connection:
            return schema.read_schema(connection)

    def prepare(self, *, migrate: bool = False) -> Migration | None:
        """Make the tables ready for a server; return the migration that was necessary, or None.

        Tables of an empty database are created, and those of an older SQLite database are migrated.
        Several servers may use one PostgreSQL database, so that its tables are migrated on request
        only.

        Parameters
        ----------
        migrate
            Whether the tables of an older PostgreSQL database are migrated.

        Raises
        ------
        StoreError
            The tables must be migrated first, or a newer version of knifetip has made them.
        """
        found = self.schema()
        schema.require_known(found, self.url)
        if not (migrate or found.is_empty or self._engine.dialect.name == "sqlite"):
            schema.require_migrated(found, self.url)
        return None if found.is_current else self.migrate()

    def migrate(self) -> Migration | None:
        """Create the tables, or migrate existing tables to the newest revision.

        A copy of an SQLite database that is not empty is made beside it first.

        Returns
        -------
        Migration or None
            None if the tables had the newest revision.

        Raises
        ------
        StoreError
            A newer version of knifetip has made the tables, the database cannot store all
            characters, or the copy cannot be made.
        """
        with self._writer.begin() as connection:
            schema.lock_migrations(connection)
            found = schema.read_schema(connection)
            schema.require_known(found, self.url)
            schema.require_utf8(connection, self.url)
            if found.is_current:
                return None
            copy = None if found.is_empty else self._copy_before(found.revision)
            schema.upgrade(connection, time.time())
        return Migration(found.revision, found.newest, copy)

    def _copy_before(self, revision: str) -> Path | None:
        """Copy an SQLite database of a revision to a file beside it; return the file."""
        file = sqlite_file(self.url)
        if file is None:
            return None
        moment = time.strftime("%Y%m%dT%H%M%SZ", time.gmtime())
        copy = file.with_name(f"{file.name}.revision-{revision}.{moment}")
        copy_database(file, copy)
        return copy

    def server_time(self) -> float:
        """Return the time of the PostgreSQL server: seconds since 1970."""
        now = sa.select(sa.func.extract("epoch", sa.func.clock_timestamp()))
        with self.reading() as session:
            return float(session.scalar(now) or 0.0)

    def damage(self) -> str:
        """Return a fault of the file of an SQLite database; "" if there is none.

        A PostgreSQL server checks its files itself.
        """
        file = sqlite_file(self.url)
        return "" if file is None or not file.is_file() else find_damage(file)

    def close(self) -> None:
        """Close all connections; those that another thread uses when it returns them."""
        self._closed.set()
        self._engine.dispose()

    @contextmanager
    def reading(self) -> Iterator[Session]:
        """Return a context with a database session for reading, in one transaction."""
        with Session(self._engine, expire_on_commit=False) as session:
            yield session

    @contextmanager
    def writing(self, *, urgent: bool = False) -> Iterator[Session]:
        """Return a context with a database session for writing, in one transaction.

        If the transaction has called ``note_change``, the functions subscribed to the attribute
        ``changes`` are called after the commit.

        Parameters
        ----------
        urgent
            Whether the transaction begins before waiting transactions of this process that are not
            urgent.
        """
        with (
            self._write_lock.acquired(urgent),
            Session(self._writer, expire_on_commit=False) as session,
        ):
            with session.begin():
                yield session
                acting = add_audit_entry(session, self.clock())
            if acting is not None:
                acting.written = True
            topics = topics_of(session)
        if topics:
            self.changes.notify(topics)

    def alive(self) -> bool:
        """Return True if the database answers a query, else raise the error of the database."""
        with self.reading() as session:
            return bool(session.scalar(sa.select(sa.literal(1))))


def note_change(session: Session, *topics: str) -> None:
    """Have subscribers of ``Database.changes`` called after the commit of a transaction.

    Parameters
    ----------
    session
        Session with the transaction.
    *topics
        Topics of the change (see ``changes``).
    """
    session.info.setdefault(_TOPICS, set()).update(topics)


def topics_of(session: Session) -> frozenset[str]:
    """Return the topics of the changes that a transaction has made."""
    return frozenset(session.info.get(_TOPICS, ()))


def insert_into(session: Session, table: type[Base]) -> postgresql.Insert | sqlite.Insert:
    """Return an INSERT statement that supports ON CONFLICT, for the database of a session."""
    if session.get_bind().dialect.name == "sqlite":
        return sqlite.insert(table)
    return postgresql.insert(table)


def rows(session: Session, statement: sa.Update | sa.Delete) -> int:
    """Execute a statement and return the number of table rows that it changed."""
    return cast("sa.CursorResult[Any]", session.execute(statement)).rowcount


def short(id: str) -> str:
    """Return the id of a drawing or job for an error message: quoted, shortened if it is long."""
    return repr(id if len(id) <= 40 else id[:40] + "…")
