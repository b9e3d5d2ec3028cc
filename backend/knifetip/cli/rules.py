"""Profiles by name, as every command finds them: in a file, in the library, or kept by a server.

"acme" -> LineRules
"""

from __future__ import annotations

import os
from pathlib import Path

from knifetip.errors import LibraryError
from knifetip.library import load, own
from knifetip.model.profile import LineRules

#: Where the command line looks for what a server keeps.
VARIABLE = "KNIFETIP_DATABASE"
BESIDE = Path("knifetip.sqlite")


def database_of(given: str | None) -> str | None:
    """Return the URL of the database that profiles are kept in, None where there is none."""
    if url := given or os.environ.get(VARIABLE):
        return url
    return f"sqlite:///{BESIDE}" if BESIDE.is_file() else None


def kept(database: str | None) -> dict[str, str]:
    """Return the profiles that a server keeps: names and their TOML."""
    url = database_of(database)
    if url is None:
        return {}
    from knifetip.jobs.store import Store  # a database's driver is not for every command

    store = Store(url)
    try:
        store.migrate()
        return {row.name: row.text for row in store.profiles.all()}
    finally:
        store.close()


def text_of(name: str, database: str | None = None) -> str:
    """Return the TOML of a profile: from a file, from the library, or kept by a server.

    Raises
    ------
    KnifetipError
        There is none, or it cannot be read.
    """
    if name in load.names("profiles"):
        return own.text_of(name)
    if name.endswith(".toml"):
        load.profile(name)
        return Path(name).read_text("utf-8")
    theirs = kept(database)
    if name in theirs:
        return theirs[name]
    known = [*theirs, *load.names("profiles")]
    raise LibraryError("library.unknown", name=name[:200], known=known, shelf="profile")


def named(name: str, database: str | None = None) -> LineRules:
    """Return a profile: from a file, from the library, or kept by a server."""
    if name in load.names("profiles") or name.endswith(".toml"):
        return load.profile(name)
    return own.parsed(name, text_of(name, database))
