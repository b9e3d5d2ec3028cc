"""knifetip ticket: write the job ticket of a job of a server to a PDF file."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from knifetip.cli.job import SERVER, Id, Key, Server
from knifetip.cli.job_client import JobClient
from knifetip.cli.terminal import print_line, user_language, write_bytes


def ticket(
    id: Id,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="PDF file. Default: JOB.pdf in this folder."),
    ] = None,
    language: Annotated[
        str, typer.Option(help="Language, such as en or de. Default: that of the user.")
    ] = "",
    server: Server = SERVER,
    key: Key = "",
) -> None:
    """Write the job ticket of a job of a server to a PDF file."""
    file = output or Path(f"{Path(id).name}.pdf")
    write_bytes(file, JobClient(server, key).ticket(id, language or user_language()))
    print_line(str(file))


def register(app: typer.Typer) -> None:
    """Add the command ``ticket`` to a Typer application."""
    app.command()(ticket)
