"""schema: the revision of the tables of a database, and their migration to the newest one.

Alembic numbers the revisions.  The table ``database_version`` records which version of knifetip has
migrated the tables, so that an older version can name the version that it needs.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import sqlalchemy as sa
from alembic import command
from alembic.config import Config
from alembic.migration import MigrationContext
from alembic.script import ScriptDirectory

from knifetip.errors import StoreError
from knifetip.messages import Message
from knifetip.service.database.tables import DatabaseVersion
from knifetip.service.database.url import hide_password

_MIGRATIONS = Path(__file__).parent / "migrations"
_MIGRATING = 0x6B6E_6966  # PostgreSQL's advisory lock of the migration


@dataclass(frozen=True, slots=True)
class Schema:
    """Revision of the tables of a database, beside the newest one of this version."""

    revision: str  #: "" if the database is empty
    newest: str
    oldest: str  #: the first one of the first release, from which this version migrates
    is_newer: bool  #: whether a newer version of knifetip has made the revision
    writer: str  #: version of knifetip that made the revision; "" if that is not recorded

    @property
    def is_empty(self) -> bool:
        """Whether the database has no tables of knifetip."""
        return not self.revision

    @property
    def is_unreleased(self) -> bool:
        """Whether the tables are from before the first release, so they cannot be migrated."""
        return "" < self.revision < self.oldest

    @property
    def is_current(self) -> bool:
        """Whether the tables are those that this version of knifetip needs."""
        return self.revision == self.newest


@dataclass(frozen=True, slots=True)
class Migration:
    """A completed migration: its revisions, and the copy of the database from before it."""

    before: str  #: revision before the migration; "" if the database was empty
    after: str
    copy: Path | None  #: None if no copy was made


def read_schema(connection: sa.Connection) -> Schema:
    """Return the revision of the tables of the database of a connection."""
    scripts = ScriptDirectory.from_config(_settings())
    newest = scripts.get_current_head() or ""
    revision = MigrationContext.configure(connection).get_current_revision() or ""
    known = [script.revision for script in scripts.walk_revisions()]
    return Schema(
        revision,
        newest,
        oldest=known[-1],
        is_newer=revision > known[-1] and revision not in known,
        writer=_writer(connection, revision),
    )


def _writer(connection: sa.Connection, revision: str) -> str:
    """Return the version of knifetip that made a revision; "" if that is not recorded."""
    if not sa.inspect(connection).has_table(DatabaseVersion.__tablename__):
        return ""
    # Only columns that the first version of the table had, since a newer version may read as well.
    query = sa.select(DatabaseVersion.version).where(DatabaseVersion.revision == revision)
    return connection.scalar(query.order_by(DatabaseVersion.id.desc()).limit(1)) or ""


def lock_migrations(connection: sa.Connection) -> None:
    """Wait until no other server migrates the same database, until the end of the transaction.

    SQLite needs no lock, because a transaction that writes excludes the others.
    """
    if connection.dialect.name == "postgresql":
        connection.execute(sa.select(sa.func.pg_advisory_xact_lock(_MIGRATING)))


def upgrade(connection: sa.Connection, now: float) -> None:
    """Migrate the tables to the newest revision, in the transaction of a connection.

    Parameters
    ----------
    connection
        Connection in a transaction that may write.
    now
        Time to record, in seconds since 1970.
    """
    settings = _settings()
    settings.attributes["connection"] = connection
    command.upgrade(settings, "head")
    revision = MigrationContext.configure(connection).get_current_revision()
    row = {"version": version("knifetip"), "revision": revision, "at": now}
    connection.execute(sa.insert(DatabaseVersion).values(**row))


def require_known(schema: Schema, url: str) -> None:
    """Raise an error if another version of knifetip has made the tables, without a way to this one.

    Raises
    ------
    StoreError
        The tables have a revision that is unknown to this version of knifetip.
    """
    if (error := unknown_revision(schema, url)) is not None:
        raise error


def unknown_revision(schema: Schema, url: str) -> StoreError | None:
    """Return the error about tables with an unknown revision; None if the revision is known."""
    facts = {"url": hide_password(url), "revision": schema.revision, "version": version("knifetip")}
    if schema.is_unreleased:
        return StoreError(Message("database.unreleased", oldest=schema.oldest, **facts))
    if not schema.is_newer:
        return None
    if schema.writer:
        facts |= {"writer": schema.writer, "newest": schema.newest}
        return StoreError(Message("database.newer", **facts))
    return StoreError(Message("database.newer-unrecorded", newest=schema.newest, **facts))


def require_utf8(connection: sa.Connection, url: str) -> None:
    """Raise an error if a database cannot store all characters of names.

    Raises
    ------
    StoreError
        A PostgreSQL database has another encoding than UTF-8.
    """
    if connection.dialect.name != "postgresql":
        return
    encoding = str(connection.scalar(sa.text("SHOW server_encoding")))
    if encoding != "UTF8":
        raise StoreError("database.not-utf8", url=hide_password(url), encoding=encoding)


def require_migrated(schema: Schema, url: str) -> None:
    """Raise an error if the tables of a database must be migrated first.

    Raises
    ------
    StoreError
        The tables have an older revision than this version of knifetip needs.
    """
    if not schema.is_current:
        raise StoreError(
            "database.older",
            url=hide_password(url),
            revision=schema.revision,
            version=version("knifetip"),
            newest=schema.newest,
        )


def _settings() -> Config:
    settings = Config()
    settings.set_main_option("script_location", str(_MIGRATIONS).replace("%", "%%"))
    return settings
