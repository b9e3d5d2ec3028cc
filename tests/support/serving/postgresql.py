"""A PostgreSQL server in a temporary folder, for the tests of what runs beyond one machine."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
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


@contextmanager
def run_server(binaries: Path) -> Iterator[str]:
    """Run a server without network address; yield the URL of its database ``postgres``.

    The server refuses to run as root, so root runs it as the user ``postgres``, which the
    package has created.
    """
    as_user = {"user": "postgres", "group": "postgres"} if os.geteuid() == 0 else {}
    # Not pytest's folder: the user postgres may not enter it, and a socket's path must be short.
    folder = Path(tempfile.mkdtemp(prefix="knifetip-pg-"))
    if as_user:
        shutil.chown(folder, **as_user)

    def run(*command: object) -> None:
        subprocess.run(
            [str(word) for word in command],
            cwd=folder,
            check=True,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            timeout=60,
            **as_user,  # type: ignore[call-overload]  # mypy cannot match unpacked options
        )

    data = folder / "data"
    try:
        run(binaries / "initdb", "-D", data, "-A", "trust", "-U", "postgres", "-E", "UTF8")
        options = f"-k {folder} -c listen_addresses='' -c fsync=off"
        run(binaries / "pg_ctl", "-D", data, "-o", options, "-l", folder / "log", "-w", "start")
        try:
            yield f"postgresql+psycopg://postgres@/postgres?host={folder}"
        finally:
            run(binaries / "pg_ctl", "-D", data, "-m", "immediate", "-w", "stop")
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def create_database(server: str, name: str) -> str:
    """Create a database on a server and return its URL.

    Parameters
    ----------
    server
        URL of a database on the same server, as `run_server` yields it.
    name
        Name of the new database.
    """
    engine = sa.create_engine(server, isolation_level="AUTOCOMMIT")
    with engine.connect() as connection:
        connection.execute(sa.text(f'CREATE DATABASE "{name}"'))
    engine.dispose()
    return server.replace("/postgres?", f"/{name}?")
