"""url: the URL of a database, with a password from a file, or without it for display."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import sqlalchemy as sa

from knifetip.errors import StoreError
from knifetip.logs import without_secrets

#: Options of libpq.  A computer that does not acknowledge anything for 30 s is gone.  A database
#: without an encoding would send bytes instead of texts.
_OPTIONS: Final = {
    "client_encoding": "utf8",
    "connect_timeout": "10",
    "keepalives_idle": "10",
    "keepalives_interval": "5",
    "keepalives_count": "4",
    "tcp_user_timeout": "30000",
}


def parse_url(url: str) -> sa.URL:
    """Return the parts of the URL of an SQLite or PostgreSQL database.

    Raises
    ------
    StoreError
        The text is no such URL.
    """
    try:
        parts = sa.make_url(url)
        if parts.get_backend_name() in ("sqlite", "postgresql", "postgres"):
            return parts
    except (sa.exc.ArgumentError, ValueError):  # the second for a port that is no number
        pass
    raise StoreError("database.bad-url", url=hide_password(url))


def add_options(url: str) -> sa.URL:
    """Return the URL of a PostgreSQL database with its encoding and those time limits it lacks.

    Without these limits, a thread waits up to two hours for an answer of a computer that is gone.
    The URL of an SQLite database is returned as it is.
    """
    parts = sa.make_url(url)
    if parts.get_backend_name() != "postgresql":
        return parts
    return parts.update_query_dict(
        {name: value for name, value in _OPTIONS.items() if name not in parts.query}
    )


def sqlite_file(url: str) -> Path | None:
    """Return the file of an SQLite database; None if the URL is that of a PostgreSQL database.

    Raises
    ------
    StoreError
        The text is no URL of a database, or that of an SQLite database in memory.
    """
    parts = parse_url(url)
    if parts.get_backend_name() != "sqlite":
        return None
    if parts.database in (None, "", ":memory:"):
        raise StoreError("database.in-memory")
    return Path(parts.database)


def add_password(url: str, file: Path) -> str:
    """Return a URL with the password that a file contains; a final newline is not part of it.

    Raises
    ------
    StoreError
        The file cannot be read, is empty or not UTF-8, or the text is no URL of a database.
    """
    try:
        password = file.read_text("utf-8", "replace").rstrip("\r\n")
    except OSError as reason:
        raise StoreError("database.password-file", file=file, reason=reason.strerror) from reason
    if not password or "\ufffd" in password:
        raise StoreError("database.no-password", file=file)
    return parse_url(url).set(password=password).render_as_string(hide_password=False)


def hide_password(url: str) -> str:
    """Return a URL in which ``***`` replaces the password, for logs and messages."""
    try:
        return sa.make_url(url).render_as_string(hide_password=True)
    except (sa.exc.ArgumentError, ValueError):
        return without_secrets(url)
