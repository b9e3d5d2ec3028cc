"""A PostgreSQL server in a temporary folder, for the tests of what runs beyond one machine."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import tempfile
import uuid
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

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


def _execute(server: str, statement: str) -> None:
    engine = sa.create_engine(server, isolation_level="AUTOCOMMIT")
    with engine.connect() as connection:
        connection.execute(sa.text(statement))
    engine.dispose()
