"""The revision of a database: created, migrated with its data, refused if newer or too old."""

from __future__ import annotations

import hashlib
import sqlite3
import threading
from collections.abc import Callable, Iterator
from contextlib import closing
from importlib.metadata import version
from pathlib import Path

import psycopg
import pytest
import sqlalchemy as sa

from knifetip.contract.job import State
from knifetip.errors import StoreError
from knifetip.service.content.store import address_of
from knifetip.service.database.engine import Database
from knifetip.service.database.schema import Migration
from knifetip.service.database.url import add_password, hide_password
from knifetip.service.store import Store
from tests.support.job_states import ordered
from tests.support.revisions import newest_revision

DRAWN = b"0\nEOF\n"
PROGRAM = b"G21\nG1 X10\nM2\n"
#: States of jobs, each on a machine of its own.
STATES = tuple(str(state) for state in State if state != State.CONTINUED)


def execute(url: str, statement: str, **values: object) -> None:
    engine = sa.create_engine(url)
    with engine.begin() as connection:
        connection.execute(sa.text(statement), values)
    engine.dispose()


def fill(url: str) -> None:
    """Create all tables, with a drawing and a job in every state."""
    with closing(Database(url)) as database:
        database.migrate()
    engine = sa.create_engine(url)
    tables = sa.MetaData()
    with engine.begin() as connection:
        tables.reflect(connection)
        drawing, job, event, content = (
            tables.tables[name] for name in ("drawing", "job", "event", "content")
        )
        for data in (DRAWN, PROGRAM):
            row = _row(content, address=address_of(data), data=data)
            connection.execute(sa.insert(content).values(row))
        row = _row(drawing, id="d1", content_address=address_of(DRAWN))
        connection.execute(sa.insert(drawing).values(row))
        for number, state in enumerate(STATES):
            row = _row(job, id=f"j{number}", drawing="d1", state=state, machine=f"m{number}")
            row |= {"program_address": address_of(PROGRAM)}
            row |= {"program_sha256": hashlib.sha256(PROGRAM).hexdigest()}
            connection.execute(sa.insert(job).values(row))
            connection.execute(
                sa.insert(event).values(_row(event, kind="job", subject=f"j{number}", state=state))
            )
    engine.dispose()


def _row(table: sa.Table, **values: object) -> dict[str, object]:
    """Return the columns of a row: the given ones, and an empty value for the others."""
    row: dict[str, object] = {}
    for column in table.columns:
        kind = column.type
        if column.nullable or column.autoincrement is True or column.name in ("serial",):
            continue
        if table.name == "event" and column.name == "id":
            continue
        if isinstance(kind, sa.JSON):
            row[column.name] = {} if column.name == "summary" else []
        elif isinstance(kind, sa.LargeBinary):
            row[column.name] = b""
        elif isinstance(kind, sa.Boolean):
            row[column.name] = False
        elif isinstance(kind, sa.String):
            row[column.name] = ""
        else:
            row[column.name] = 0
    return row | values


@pytest.fixture
def newer_url(database_url: str) -> str:
    """URL of a database that a newer version of knifetip has migrated."""
    with closing(Database(database_url)) as database:
        database.migrate()
    execute(database_url, "UPDATE alembic_version SET version_num = '9999'")
    execute(
        database_url,
        "INSERT INTO database_version (version, revision, at) VALUES ('7.1.0', '9999', 0)",
    )
    return database_url


@pytest.fixture
def database(database_url: str) -> Iterator[Database]:
    with closing(Database(database_url)) as database:
        yield database


def test_a_database_is_created_once_and_records_the_version_that_created_it(
    database: Database,
) -> None:
    assert database.schema().is_empty
    done = database.prepare()
    assert done is not None
    assert (done.before, done.copy) == ("", None)
    found = database.schema()
    assert found.is_current
    assert not found.is_newer
    assert found.writer == version("knifetip")
    assert database.prepare() is None


def test_the_data_is_there_after_a_migration(
    database_url: str, later_version: Callable[[], None]
) -> None:
    fill(database_url)
    later_version()
    with closing(Store(database_url)) as store:
        assert store.database.schema().revision == newest_revision()
        done = store.prepare(migrate=True)
        assert done is not None
        assert (done.before, done.after) == (newest_revision(), "9000")
        assert store.drawings.column("d1", "content") == DRAWN
        with store.database.reading() as session:
            assert session.scalar(sa.text("SELECT later FROM drawing")) == "new"
        for number, state in enumerate(STATES):
            job = store.jobs.get(f"j{number}")
            assert (job.state, job.drawing, job.machine) == (state, "d1", f"m{number}")
            program = store.jobs.column(job.id, "program")
            assert hashlib.sha256(program).hexdigest() == job.program_sha256
            (event,) = store.events.of_job(job.id)
            assert event.state == state
        assert ordered(store).state == "received"


def test_a_database_of_before_the_first_release_is_refused_and_not_changed(
    database_url: str,
) -> None:
    with closing(Database(database_url)) as database:
        database.migrate()
    execute(database_url, "UPDATE alembic_version SET version_num = '0097'")
    with closing(Database(database_url)) as database:
        with pytest.raises(StoreError, match="revision 0097, from before the first release") as no:
            database.prepare(migrate=True)
        assert "version of knifetip that wrote it" in no.value.hint
        assert database.schema().revision == "0097"


@pytest.mark.parametrize("work", [Database.prepare, Database.migrate])
def test_a_database_of_a_newer_version_is_refused_and_not_changed(
    newer_url: str, work: object
) -> None:
    assert callable(work)
    with closing(Database(newer_url)) as database:
        with pytest.raises(
            StoreError, match=r"written by knifetip 7\.1\.0 \(revision 9999\)"
        ) as no:
            work(database)
        assert "newer" in no.value.hint
        assert "backup" in no.value.hint
        assert database.schema().revision == "9999"


def test_an_older_postgresql_database_is_migrated_on_request_only(
    postgresql_url: str, later_version: Callable[[], None]
) -> None:
    fill(postgresql_url)
    later_version()
    with closing(Database(postgresql_url)) as database:
        with pytest.raises(StoreError, match=f"has revision {newest_revision()}") as older:
            database.prepare()
        assert "knifetip db upgrade" in older.value.hint
        assert database.schema().revision == newest_revision()
        assert database.prepare(migrate=True) is not None
        assert database.schema().is_current


def test_servers_that_start_together_migrate_a_database_once(
    database_url: str, later_version: Callable[[], None]
) -> None:
    fill(database_url)
    later_version()
    together = threading.Barrier(4)
    results: list[Migration | None] = []

    def start() -> None:
        with closing(Database(database_url)) as database:
            together.wait(30.0)
            results.append(database.prepare(migrate=True))

    servers = [threading.Thread(target=start) for _ in range(4)]
    for server in servers:
        server.start()
    for server in servers:
        server.join(60.0)
    assert len(results) == 4
    assert sum(result is not None for result in results) == 1
    with closing(Database(database_url)) as database:
        assert database.schema().is_current


def test_a_copy_of_an_older_sqlite_database_is_kept_beside_it(
    tmp_path: Path, later_version: Callable[[], None]
) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    fill(url)
    later_version()
    with closing(Database(url)) as database:
        done = database.prepare()
    assert done is not None
    assert done.copy is not None
    assert done.copy.parent == tmp_path
    assert done.copy.name.startswith(f"shop.sqlite.revision-{newest_revision()}.")
    assert done.copy.stat().st_mode & 0o077 == 0
    with closing(Database(f"sqlite:///{done.copy}")) as copy:
        assert copy.schema().revision == newest_revision()
    with closing(sqlite3.connect(done.copy)) as copied:
        assert copied.execute("SELECT count(*) FROM job").fetchone() == (len(STATES),)
        assert "later" not in {row[1] for row in copied.execute("PRAGMA table_info(drawing)")}


def test_a_database_that_cannot_be_copied_is_not_migrated(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, later_version: Callable[[], None]
) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    fill(url)
    later_version()

    def full(*_arguments: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("knifetip.service.database.sqlite_copy.os.fsync", full)
    with closing(Database(url)) as database:
        with pytest.raises(StoreError, match="No space left on device"):
            database.prepare()
        assert database.schema().revision == newest_revision()
    assert not list(tmp_path.glob("*.part"))


def test_a_connection_ends_when_the_computer_of_the_database_is_gone(postgresql_url: str) -> None:
    url = sa.make_url(postgresql_url).update_query_dict({"keepalives_count": "9"})
    with (
        closing(Database(url.render_as_string(hide_password=False))) as database,
        database.reading() as session,
    ):
        connection = session.connection().connection.driver_connection
        assert isinstance(connection, psycopg.Connection)
        found = connection.info.get_parameters()
    limits = {"connect_timeout", "keepalives_idle", "keepalives_interval", "tcp_user_timeout"}
    assert all(0 < int(found[name]) <= 30_000 for name in limits)
    assert found["keepalives_count"] == "9"  # of the URL


def test_the_password_comes_from_a_file_and_is_not_shown(tmp_path: Path) -> None:
    file = tmp_path / "password"
    file.write_text("p@ss/w:rd\n")
    url = add_password("postgresql://shop@db.local:5432/knifetip", file)
    assert sa.make_url(url).password == "p@ss/w:rd"
    assert "ss" not in hide_password(url)
    file.write_text("\n")
    with pytest.raises(StoreError, match="contains no password"):
        add_password("postgresql://shop@db.local/knifetip", file)
    with pytest.raises(StoreError, match="No such file"):
        add_password("postgresql://shop@db.local/knifetip", tmp_path / "none")


@pytest.mark.parametrize("encoding", ["SQL_ASCII", "LATIN1"])
def test_a_database_that_cannot_store_all_names_is_refused(
    postgresql_server: str, encoding: str
) -> None:
    name = f"names_{encoding.lower()}"
    options = f"TEMPLATE template0 ENCODING '{encoding}' LC_COLLATE 'C' LC_CTYPE 'C'"
    engine = sa.create_engine(postgresql_server, isolation_level="AUTOCOMMIT")
    with engine.connect() as connection:
        connection.execute(sa.text(f"CREATE DATABASE {name} {options}"))
    engine.dispose()
    url = sa.make_url(postgresql_server).set(database=name).render_as_string(hide_password=False)
    with closing(Database(url)) as database:
        with pytest.raises(StoreError, match=encoding) as no:
            database.prepare()
        assert "ENCODING 'UTF8'" in no.value.hint
        assert database.schema().is_empty
