"""Entry point: the list of commands, loading them on demand, and reporting of errors."""

from __future__ import annotations

import gc
import sys
from importlib import import_module
from typing import Any, Final, NamedTuple

import typer
from typer.core import TyperCommand, TyperGroup

from knifetip.errors import KnifetipError


class _Command(NamedTuple):
    module: str  #: module of this package that registers the command
    help: str  #: first sentence of the help text


# The module of a command is imported only when that command runs.
COMMANDS: Final[dict[str, _Command]] = {
    "read": _Command("drawing", "Show unit, size and import report of a drawing."),
    "classify": _Command(
        "drawing",
        "Show line types of edges with the deciding rules; exits with 2 while questions are open.",
    ),
    "clean": _Command(
        "drawing",
        "Show which edges cleaning merges, shortens, joins or drops before a program is made.",
    ),
    "samples": _Command("drawing", "Write the sample cartons as DXF files."),
    "program": _Command(
        "program", "Compile a drawing to a program, and write it if the verifier accepts it."
    ),
    "verify": _Command("program", "Verify that a program makes a drawing."),
    "machine": _Command(
        "machine", "Show the stations of a machine with their datums and tool dimensions."
    ),
    "calibrate": _Command(
        "calibrate",
        "Compute the deflection of a cutter from a test contour cut without compensating it.",
    ),
    "job": _Command(
        "job", "Jobs of a server: list, show, confirm, hold, resume, cancel, finish, …"
    ),
    "serve": _Command(
        "service", "Run the page, the API and all parts of the service in one process until Ctrl-C."
    ),
    "worker": _Command("service", "Run a compile worker for a database until Ctrl-C."),
    "gateway": _Command(
        "service", "Claim the jobs of a machine and stream them to its controller."
    ),
    "simulator": _Command(
        "service", "Simulate a machine: listen like its controller and execute programs."
    ),
    "schema": _Command(
        "schema",
        "Print the JSON Schema of machine, board or profile files, for editors.",
    ),
    "profile": _Command("profile", "Classification profiles: list, show, export, import."),
}


def load_command(name: str) -> Any:
    """Import the module of a command and return the command with its parameters."""
    # Imported objects live until the process ends, so the garbage collector need not scan them,
    # neither now nor later.
    gc.disable()
    app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)
    app.callback()(lambda: None)  # without a callback, an app with one command has no subcommands
    import_module(f"knifetip.cli.{COMMANDS[name].module}").register(app)
    gc.freeze()
    gc.enable()
    group: Any = typer.main.get_command(app)
    return group.commands[name]


class _Commands(TyperGroup):
    """Command group that lists names and help texts, and imports only the command that runs."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Return the name of the invoked command, the loaded command, and its arguments."""
        name, _, rest = super().resolve_command(ctx, args)
        return name, None if name is None else load_command(name), rest


app = _Commands(
    name="knifetip",
    help="Compile carton dielines to compensated, verified machine programs.",
    commands={name: TyperCommand(name, help=command.help) for name, command in COMMANDS.items()},
    no_args_is_help=True,
    rich_markup_mode=None,
)


def main() -> None:
    """Run the command line; print a ``KnifetipError`` and exit with code 3."""
    try:
        app()
    except KnifetipError as error:
        from knifetip.cli.terminal import UNUSABLE, report_error  # imported only on failure

        report_error(error)
        sys.exit(UNUSABLE)
    except KeyboardInterrupt:
        sys.exit(130)
