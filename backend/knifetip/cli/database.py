"""knifetip db, backup and restore: migrate a database, back it up to a file, and restore it.

db current        print the revision of the tables
db check          exit with 1 if the tables must be migrated before a server can start
db upgrade        migrate the tables; a copy of an SQLite database is kept beside it
backup, restore   copy an SQLite database, also while a server uses it, and put a copy in its place
"""

from __future__ import annotations

import time
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from knifetip.cli.options import expand
from knifetip.cli.terminal import in_words, print_line
from knifetip.errors import StoreError
from knifetip.messages import Message
from knifetip.service.settings import DatabaseSettings

if TYPE_CHECKING:
    from knifetip.service.database.engine import Database
    from knifetip.service.database.schema import Migration, Schema

#: Exit code of ``db check`` if the tables must be migrated.
_MUST_MIGRATE = 1

Replace = Annotated[bool, typer.Option("--replace", help="Replace an existing file.")]


def register(app: typer.Typer) -> None:
    """Add the commands ``db``, ``backup`` and ``restore`` to a Typer application."""
    db = typer.Typer(
        help="Show or migrate the tables of a database.",
        no_args_is_help=True,
    )
    app.add_typer(db, name="db")
    db.command("current")(expand(show_schema))
    db.command("check")(expand(check_schema))
    db.command("upgrade")(expand(upgrade_schema))
    app.command("backup")(expand(back_up))
    app.command("restore")(expand(restore))


def show_schema(chosen: DatabaseSettings) -> None:
    """Print the revision of the tables, and the version of knifetip that made them."""
    with closing(_open_existing_database(chosen)) as database:
        print_line(in_words(_describe(database.schema())))


def check_schema(chosen: DatabaseSettings) -> None:
    """Exit with 0 if a server of this version can use the tables as they are.

    Exit with 1 if they must be migrated first, and with 3 if they are too new.
    """
    from knifetip.service.database.schema import require_known

    with closing(_open_existing_database(chosen)) as database:
        found = database.schema()
        require_known(found, database.url)
        print_line(in_words(_describe(found)))
        if not found.is_current:
            raise typer.Exit(_MUST_MIGRATE)


def upgrade_schema(chosen: DatabaseSettings) -> None:
    """Create the tables, or migrate them to those of this version.

    A copy of an SQLite database is kept beside it.  Stop all servers and workers first.
    """
    from knifetip.service.database.engine import Database

    with closing(Database(chosen.url)) as database:
        done = database.migrate()
        current = Message("output.tables-current")
        print_line(in_words(current if done is None else describe_migration(done)))


def back_up(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="File of the copy.")],
    replace: Replace = False,
    *,
    chosen: DatabaseSettings,
) -> None:
    """Copy an SQLite database to a file.  Its server and its workers may run meanwhile."""
    from knifetip.service.database.sqlite_copy import copy_database

    source = _file(chosen, must_exist=True)
    if file.exists() and not replace:
        raise StoreError("backup.exists", file=file)
    copy_database(source, file)
    typer.echo(f"{file}: {file.stat().st_size / 1e6:.1f} MB")


def restore(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="File that backup has written.")],
    replace: Annotated[
        bool,
        typer.Option(
            "--replace", help="Replace an existing database; it is kept under another name."
        ),
    ] = False,
    *,
    chosen: DatabaseSettings,
) -> None:
    """Put a copy of an SQLite database in its place.

    Stop the server and its workers first.
    """
    from knifetip.service.database import sqlite_copy
    from knifetip.service.database.damage import find_damage

    target = _file(chosen, must_exist=False)
    found = _schema_of_copy(file)
    if target.exists() and not replace:
        raise StoreError("backup.exists", file=target)
    moment = time.strftime("%Y%m%dT%H%M%SZ", time.gmtime())
    kept = target.with_name(f"{target.name}.replaced.{moment}")
    if target.exists():
        # Copied rather than renamed, so that there is a database at any time.
        if sqlite_copy.require_unused(target) and not find_damage(target):
            sqlite_copy.copy_database(target, kept)
        else:
            sqlite_copy.move_away(target, kept)
        print_line(in_words(Message("output.former-database", file=kept)))
    else:
        sqlite_copy.move_away(target, kept)  # its logs, if only the database was deleted
    sqlite_copy.copy_database(file, target)
    print_line(f"{target}: {in_words(_describe(found))}")


def describe_migration(done: Migration) -> Message:
    """Return a message about a completed migration."""
    copy = Message("output.migration-copy", file=done.copy) if done.copy else None
    if not done.before:
        return Message("output.migrated-new", after=done.after, copy=copy)
    return Message("output.migrated", before=done.before, after=done.after, copy=copy)


def _describe(found: Schema) -> Message:
    if found.is_empty:
        return Message("output.no-tables", newest=found.newest)
    writer = Message("output.writer", version=found.writer) if found.writer else None
    if found.is_current:
        return Message("output.revision-current", revision=found.revision, writer=writer)
    code = "output.revision-newer" if found.is_newer else "output.revision-older"
    return Message(code, revision=found.revision, writer=writer, newest=found.newest)


def _open_existing_database(chosen: DatabaseSettings) -> Database:
    """Return a database; a missing SQLite database is not created."""
    from knifetip.service.database.engine import Database
    from knifetip.service.database.url import sqlite_file

    file = sqlite_file(chosen.url)
    if file is not None and not file.is_file():
        raise StoreError("database.missing", file=file)
    return Database(chosen.url)


def _file(chosen: DatabaseSettings, *, must_exist: bool) -> Path:
    """Return the file of an SQLite database."""
    from knifetip.service.database.url import sqlite_file

    file = sqlite_file(chosen.url)
    if file is None:
        raise StoreError("backup.postgresql", url=chosen.shown)
    if must_exist and not file.is_file():
        raise StoreError("database.missing", file=file)
    return file


def _schema_of_copy(file: Path) -> Schema:
    """Return the revision of the tables in a copy; the copy is checked and not changed."""
    import sqlalchemy as sa

    from knifetip.service.database.schema import read_schema, require_known
    from knifetip.service.database.sqlite_copy import check_copy

    if not file.is_file():
        raise StoreError("database.missing", file=file)
    check_copy(file)
    address = f"sqlite:///file:{file.resolve().as_uri().removeprefix('file://')}?mode=ro&uri=true"
    engine = sa.create_engine(address)
    try:
        with engine.connect() as connection:
            found = read_schema(connection)
    finally:
        engine.dispose()
    if found.is_empty:
        raise StoreError("backup.foreign", file=file)
    require_known(found, str(file))
    return found
