"""A PostgreSQL server in a temporary folder, for the tests of what runs beyond one machine."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import tempfile
import uuid
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import sqlalchemy as sa


def installed_binaries() -> Path | None:
    """Return the folder of ``initdb`` and ``pg_ctl``; None if PostgreSQL is not installed."""
    on_path = shutil.which("initdb")
    folders = [Path(on_path).resolve().parent] if on_path else []
    # Debian keeps the server's programs of each version in a folder that is not on the path.
    folders += sorted(Path("/usr/lib/postgresql").glob("*/bin"), reverse=True)
    return next((folder for folder in folders if (folder / "initdb").exists()), None)


class Cluster:
    """A PostgreSQL server without network address in a temporary folder.

    The server refuses to run as root, so root runs it as the user ``postgres``, which the package
    has created.

    Parameters
    ----------
    binaries
        Folder of ``initdb`` and ``pg_ctl``.
    environment
        Further environment variables of the server.
    """

    def __init__(self, binaries: Path, environment: Mapping[str, str] | None = None) -> None:
        self._binaries = binaries
        self._environment = {**os.environ, **(environment or {})}
        self._user = {"user": "postgres", "group": "postgres"} if os.geteuid() == 0 else {}
        # Not pytest's folder: the user postgres may not enter it, and a socket's path is short.
        self.folder = Path(tempfile.mkdtemp(prefix="knifetip-pg-"))
        if self._user:
            shutil.chown(self.folder, **self._user)
        self._data = self.folder / "data"
        self.url = f"postgresql+psycopg://postgres@/postgres?host={self.folder}"
        self._run("initdb", "-D", self._data, "-A", "trust", "-U", "postgres", "-E", "UTF8")

    def start(self) -> None:
        """Start the server and wait until it answers."""
        options = f"-k {self.folder} -c listen_addresses='' -c fsync=off"
        log = self.folder / "log"
        self._run("pg_ctl", "-D", self._data, "-o", options, "-l", log, "-w", "start")

    def stop(self) -> None:
        """Stop the server at once: its next start recovers from the log of transactions."""
        self._run("pg_ctl", "-D", self._data, "-m", "immediate", "-w", "stop")

    def kill(self) -> None:
        """Kill the first process of the server; its other processes then end by themselves."""
        number = int((self._data / "postmaster.pid").read_text().split("\n", 1)[0])
        os.kill(number, signal.SIGKILL)

    def delete(self) -> None:
        """Delete the folder of the server, which must not run."""
        shutil.rmtree(self.folder, ignore_errors=True)

    def _run(self, program: str, *arguments: object) -> None:
        subprocess.run(
            [str(self._binaries / program), *map(str, arguments)],
            cwd=self.folder,
            check=True,
            env=self._environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            timeout=60,
            **self._user,  # type: ignore[call-overload]  # mypy cannot match unpacked options
        )


@contextmanager
def run_server(binaries: Path) -> Iterator[str]:
    """Run a server without network address; yield the URL of its database ``postgres``."""
    cluster = Cluster(binaries)
    try:
        cluster.start()
        try:
            yield cluster.url
        finally:
            cluster.stop()
    finally:
        cluster.delete()


def create_database(server: str, name: str, template: str = "template1") -> str:
    """Create a database on a server and return its URL.

    Parameters
    ----------
    server
        URL of a database on the same server, as `run_server` yields it.
    name
        Name of the new database.
    template
        Name of the database that is copied; nobody may use it at this time.
    """
    _execute(server, f'CREATE DATABASE "{name}" TEMPLATE "{template}"')
    return server.replace("/postgres?", f"/{name}?")


@contextmanager
def temporary_database(server: str, template: str = "template1") -> Iterator[str]:
    """Create a database with a new name, yield its URL, and delete it; see `create_database`."""
    name = f"t{uuid.uuid4().hex}"
    yield create_database(server, name, template)
    _execute(server, f'DROP DATABASE "{name}" WITH (FORCE)')


#: The last change of each table, column, index, constraint, trigger and function.
_STRUCTURE = " UNION ALL ".join(
    f"SELECT '{catalogue}' || oid || ' ' || xmin AS one FROM {catalogue} WHERE {space} = %s"
    for catalogue, space in (
        ("pg_class", "relnamespace"),
        ("pg_constraint", "connamespace"),
        ("pg_proc", "pronamespace"),
    )
).replace("%s", "'public'::regnamespace") + (
    " UNION ALL SELECT a.attrelid || ' ' || a.attnum || ' ' || a.xmin FROM pg_attribute a"
    " JOIN pg_class c ON c.oid = a.attrelid WHERE c.relnamespace = 'public'::regnamespace"
    " AND a.attnum > 0"
    " UNION ALL SELECT 'trigger' || oid || ' ' || xmin FROM pg_trigger"
    " UNION ALL SELECT 'setting' || setdatabase || ' ' || xmin FROM pg_db_role_setting"
)
_END_CONNECTIONS = (
    "SELECT pg_terminate_backend(pid, 10000) FROM pg_stat_activity WHERE datname ="
    " current_database() AND pid <> pg_backend_pid() AND backend_type = 'client backend'"
)


class ReusedDatabase:
    """A database that one test after the other gets as if it was new.

    To create and to drop a database takes a third of a second of CPU time, to delete the rows of
    a test some milliseconds.

    Parameters
    ----------
    url
        URL of a database with all tables, which nothing uses at this time.
    """

    def __init__(self, url: str) -> None:
        self.url = url
        with self._connected() as connection:
            tables = sa.MetaData()
            tables.reflect(connection)
            self._tables = tables.sorted_tables
            self._rows = {
                table: [dict(row) for row in connection.execute(sa.select(table)).mappings()]
                for table in self._tables
            }
            self._sequences = _sequences(connection)
            self._structure = _structure(connection)

    def reset(self) -> bool:
        """Restore the first rows; return False if a test has changed more than rows."""
        with self._connected() as connection:
            connection.execute(sa.text(_END_CONNECTIONS))
            if _structure(connection) != self._structure:
                return False
            # Without checks of foreign keys.
            connection.execute(sa.text("SET LOCAL session_replication_role = replica"))
            statements = [f'DELETE FROM "{table.name}"' for table in self._tables]
            connection.exec_driver_sql("; ".join(statements))
            for table, rows in self._rows.items():
                if rows:
                    connection.execute(sa.insert(table), rows)
            for name, last in _sequences(connection).items():
                if self._sequences[name] != last:
                    value, used = self._sequences[name] or 1, self._sequences[name] is not None
                    connection.execute(sa.select(sa.func.setval(name, value, used)))
        return True

    @contextmanager
    def _connected(self) -> Iterator[sa.Connection]:
        engine = sa.create_engine(self.url)
        try:
            with engine.begin() as connection:
                yield connection
        finally:
            engine.dispose()


def _structure(connection: sa.Connection) -> Sequence[Any]:
    return sorted(connection.scalars(sa.text(_STRUCTURE)))


def _sequences(connection: sa.Connection) -> dict[str, int | None]:
    """Return the last number of each sequence; None if it has given none."""
    found = connection.execute(
        sa.text("SELECT quote_ident(sequencename), last_value FROM pg_sequences")
    )
    return {str(name): last for name, last in found}


def _execute(server: str, statement: str) -> None:
    engine = sa.create_engine(server, isolation_level="AUTOCOMMIT")
    try:
        with engine.connect() as connection:
            connection.execute(sa.text(statement))
    finally:
        engine.dispose()
