"""rules: find a classification profile by its name, in a file, the library or a database."""

from __future__ import annotations

import os
from pathlib import Path

from knifetip.errors import LibraryError
from knifetip.library import custom_profiles, load
from knifetip.model.profile import LineRules

#: Environment variable with the URL of the database, and the SQLite file that is used if the
#: variable is not set.
DATABASE_VARIABLE = "KNIFETIP_DATABASE"
DATABASE_FILE = Path("knifetip.sqlite")


def database_of(option: str | None) -> str | None:
    """Return the URL of the database that contains stored profiles, or None if there is none.

    The first of the following is used: the option, the environment variable ``KNIFETIP_DATABASE``,
    and the file ``knifetip.sqlite`` if it exists.

    Parameters
    ----------
    option
        URL of a database from a command-line option; None if the option is missing.
    """
    if url := option or os.environ.get(DATABASE_VARIABLE):
        return url
    return f"sqlite:///{DATABASE_FILE}" if DATABASE_FILE.is_file() else None


def stored_profiles(database: str | None) -> dict[str, str]:
    """Return the TOML texts of the profiles in a database, by name of the profile.

    The result is empty if there is no database.

    Parameters
    ----------
    database
        URL of the database; None for the default of ``database_of``.
    """
    url = database_of(database)
    if url is None:
        return {}
    from knifetip.service.store import Store  # slow to import

    store = Store(url)
    try:
        store.prepare()
        return {row.name: row.text for row in store.profiles.all()}
    finally:
        store.close()


def profile_toml(name: str, database: str | None = None) -> str:
    """Return the TOML text of a classification profile.

    Parameters
    ----------
    name
        Name of a profile of the library or of the database, or path of a TOML file.
    database
        URL of the database; None for the default of ``database_of``.

    Raises
    ------
    KnifetipError
        There is no such profile, or it cannot be read.
    """
    if name in load.names("profiles"):
        return load.library_text("profiles", name)
    if name.endswith(".toml"):
        load.profile(name)
        return Path(name).read_text("utf-8")
    stored = stored_profiles(database)
    if name in stored:
        return stored[name]
    known = [*stored, *load.names("profiles")]
    raise LibraryError("library.unknown", name=name[:200], known=known, shelf="profile")


def find_profile(name: str, database: str | None = None) -> LineRules:
    """Return the rules of a classification profile.

    For the parameters and errors see ``profile_toml``.
    """
    if name in load.names("profiles") or name.endswith(".toml"):
        return load.profile(name)
    return custom_profiles.parse_text(name, profile_toml(name, database))
