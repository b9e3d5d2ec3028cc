"""database_options: the options that name the database of a command."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

DATABASE = "sqlite:///knifetip.sqlite"


@dataclass(frozen=True, slots=True)
class DatabaseOptions:
    """Options that name a database: its URL, and the file that contains its password."""

    database: Annotated[
        str,
        typer.Option(
            envvar="KNIFETIP_DATABASE",
            help="SQLAlchemy URL of an SQLite or PostgreSQL database.",
        ),
    ] = DATABASE
    database_password_file: Annotated[
        Path | None,
        typer.Option(
            envvar="KNIFETIP_DATABASE_PASSWORD_FILE",
            help="File that contains the password of the database, so that it is not in the URL.",
        ),
    ] = None

    @property
    def url(self) -> str:
        """URL of the database, with its password."""
        if self.database_password_file is None:
            return self.database
        from knifetip.jobs.database_url import add_password  # slow to import

        return add_password(self.database, self.database_password_file)

    @property
    def shown(self) -> str:
        """URL of the database without its password, for output."""
        from knifetip.jobs.database_url import hide_password

        return hide_password(self.database)


@dataclass(frozen=True, slots=True)
class StoreOptions:
    """Option that names the folder or the bucket for large values."""

    store: Annotated[
        str,
        typer.Option(
            envvar="KNIFETIP_STORE",
            help="Folder or bucket for drawings and programs beyond 4 kB: file:///FOLDER or "
            "s3://BUCKET/PREFIX, the same for all servers and workers of a database. Default: the "
            "database.",
        ),
    ] = ""
