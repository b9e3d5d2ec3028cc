"""main: entry point of the command line, with the list of commands and the output of errors."""

from __future__ import annotations

import gc
import sys
from importlib import import_module
from pathlib import Path
from typing import Annotated, Any, Final, NamedTuple, NoReturn

import typer
from typer.core import TyperCommand, TyperGroup

from knifetip.errors import KnifetipError, NotADrawing


class _Command(NamedTuple):
    """The module that implements a command of the command line, and the command's help text."""

    module: str  #: module of this package that registers the command
    help: str  #: first sentence of the help text, at most 63 characters
    reads_file: bool = False  #: the first argument is the name of a file


# The module of a command is imported only when that command runs.
COMMANDS: Final[dict[str, _Command]] = {
    "read": _Command("drawing", "Show unit, size and import report of a drawing.", True),
    "classify": _Command(
        "drawing", "Show the line type of each edge and the rule that decided it.", True
    ),
    "clean": _Command(
        "drawing", "Show which edges cleaning merges, shortens, joins or drops.", True
    ),
    "samples": _Command("drawing", "Write the sample cartons as DXF files."),
    "carton": _Command("carton", "Draw a carton of a standard style as a DXF file."),
    "program": _Command("program", "Compile a drawing to a verified machine program.", True),
    "verify": _Command(
        "program", "Verify that a program cuts and creases what a drawing shows.", True
    ),
    "machine": _Command(
        "machine", "Show the stations of a machine, with their positions and tools."
    ),
    "calibrate": _Command(
        "calibrate", "Compute the deflection of a cutter from a measured test cut."
    ),
    "nest": _Command("nest", "Place drawings on as few sheets as possible, by true shapes.", True),
    "job": _Command("job", "List and control the jobs of a server."),
    "user": _Command("account", "Add, list and change the users of a server's database."),
    "key": _Command("account", "Create, list and revoke the API keys of a server's database."),
    "export": _Command("export", "Write jobs of a server to zip files."),
    "ticket": _Command("ticket", "Write the job ticket of a job of a server to a PDF file."),
    "serve": _Command(
        "service", "Run the server with its page, a compile worker and a simulated machine."
    ),
    "worker": _Command("service", "Run a compile worker for a database until Ctrl-C."),
    "gateway": _Command(
        "service", "Fetch the jobs of a machine from the server and send them to its controller."
    ),
    "simulator": _Command(
        "service", "Run a simulated controller, to try programs without a machine."
    ),
    "watch": _Command("watch", "Order a job for each drawing that is put into a folder."),
    "db": _Command("database", "Show or migrate the tables of a database."),
    "backup": _Command("database", "Copy an SQLite database to a file."),
    "restore": _Command("database", "Put a copy of an SQLite database in its place."),
    "doctor": _Command("doctor", "Check this installation, and print what to do."),
    "schema": _Command("schema", "Print the JSON Schema of machine, board, tool or profile files."),
    "profile": _Command(
        "profile", "List, show, export and import classification profiles (rules for line types)."
    ),
}


def load_command(name: str) -> Any:
    """Import the module of a command; return the command as a Typer object.

    Parameters
    ----------
    name
        Name of the command, such as ``read``.
    """
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


def _check_exists(file: Path) -> None:
    """Raise ``NotADrawing`` if a file does not exist, before the imports of a command, which take
    longer than the check.
    """
    try:
        file.stat()
    except OSError as reason:
        raise NotADrawing(
            "command.unreadable-file", path=file, reason=reason.strerror or reason
        ) from reason


class _Commands(TyperGroup):
    """Command group that lists all commands, and imports only the module of the invoked command."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Return the name of the invoked command, the command, and its arguments.

        Imports the module of the command.

        ``ctx``: context of click.
        ``args``: arguments of the command line, with the name of the command first.
        """
        name, _, rest = super().resolve_command(ctx, args)
        if name is not None and COMMANDS[name].reads_file and rest and rest[0][:1] != "-":
            _check_exists(Path(rest[0]))
        return name, None if name is None else load_command(name), rest


def _print_version(wanted: bool) -> None:
    """Print the version of knifetip and end the command, if the option --version is given."""
    if wanted:
        from importlib.metadata import version  # slow to import

        typer.echo(f"knifetip {version('knifetip')}")
        raise typer.Exit


def _common_options() -> list[Any]:
    """Return the options that precede the name of a command."""

    def options(
        version: Annotated[
            bool,
            typer.Option(
                "--version",
                is_eager=True,
                callback=_print_version,
                help="Print the version and exit.",
            ),
        ] = False,
    ) -> None:
        """Typer creates the option from the parameter, whose value is not used otherwise."""

    parsed = typer.Typer(add_completion=False)
    parsed.callback()(options)
    group: Any = typer.main.get_group(parsed)
    return list(group.params)


app = _Commands(
    name="knifetip",
    help="Compile dielines (flat drawings of cartons) to compensated, verified machine programs.",
    commands={name: TyperCommand(name, help=command.help) for name, command in COMMANDS.items()},
    params=_common_options(),
    no_args_is_help=True,
    rich_markup_mode=None,
)


def _report_database_error(error: Exception) -> NoReturn:
    """Print why a database cannot be used and exit; raise any other error again.

    The errors of SQLAlchemy name statements and its documentation, not what to do.
    """
    library = sys.modules.get("sqlalchemy.exc")
    if library is None or not isinstance(error, library.SQLAlchemyError):
        raise error
    from knifetip.cli.terminal import exit_code, report_error
    from knifetip.service.database.damage import unusable

    reason = unusable(error)
    report_error(reason)
    sys.exit(exit_code(reason))


def main() -> None:
    """Run the command line.

    If a command raises a ``KnifetipError``, the text and the hint of the error are printed and the
    process exits with code 3, or with 4 if a server refuses a gateway.
    """
    try:
        app()
    except KnifetipError as error:
        from knifetip.cli.terminal import exit_code, report_error  # imported only on failure

        report_error(error)
        sys.exit(exit_code(error))
    except KeyboardInterrupt:
        sys.exit(130)
    except Exception as error:
        _report_database_error(error)
