"""knifetip export: write jobs of a server to zip files."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from knifetip.cli.job import SERVER, Key, Server
from knifetip.cli.job_client import JobClient
from knifetip.cli.terminal import print_line, write_bytes


def export(
    folder: Annotated[
        Path, typer.Argument(metavar="DIR", help="Folder for the files JOB.zip; it is created.")
    ],
    job: Annotated[
        list[str] | None,
        typer.Option("--job", help="Id of a job; may be repeated. Default: all jobs."),
    ] = None,
    server: Server = SERVER,
    key: Key = "",
) -> None:
    """Write jobs of a server to zip files.

    Each file has the job as JSON, its events, drawing, program and verdict.  Without --job, all
    jobs of the server are written.
    """
    client = JobClient(server, key)
    for id in job or client.ids():
        file = folder / f"{Path(id).name}.zip"
        write_bytes(file, client.export(id))
        print_line(str(file))


def register(app: typer.Typer) -> None:
    """Add the command ``export`` to a Typer application."""
    app.command()(export)
