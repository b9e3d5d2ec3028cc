"""The commands, put together, and how errors leave the house."""

from __future__ import annotations

import sys

import typer

from knifetip.cli import calibrate, drawing, job, machine, profile, program, service
from knifetip.cli.terminal import UNUSABLE, say
from knifetip.errors import KnifetipError

app = typer.Typer(
    name="knifetip",
    help="Puts the tip of the knife on the line: carton dielines in, compensated programs out.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)
for _commands in (drawing, program, profile, machine, calibrate, job, service):
    _commands.register(app)


def main() -> None:
    """Run the command line; a known error becomes its words and exit code 3."""
    try:
        app()
    except KnifetipError as error:
        say(error)
        sys.exit(UNUSABLE)
    except KeyboardInterrupt:
        sys.exit(130)
