"""The commands of the command line, and how errors leave it."""

from __future__ import annotations

import gc
import sys
from importlib import import_module
from typing import Any, Final, NamedTuple

import typer
from typer.core import TyperCommand, TyperGroup

from knifetip.errors import KnifetipError


class _Command(NamedTuple):
    module: str  #: the one of this package that registers it
    help: str  #: the first sentence of its help


# A command's module, and all that it imports, is only loaded to run that command.
COMMANDS: Final[dict[str, _Command]] = {
    "read": _Command("drawing", "Say what is in a drawing, and what became of every entity."),
    "classify": _Command(
        "drawing",
        "Show the line type of every edge and the rule that gave it; exits with 2 if any is open.",
    ),
    "clean": _Command(
        "drawing",
        "Say what is put in order before a drawing is made: of each edge, what became of it.",
    ),
    "samples": _Command("drawing", "Draw the sample cartons that come with knifetip."),
    "program": _Command(
        "program", "Write the program that makes a drawing, once the judge has accepted it."
    ),
    "verify": _Command("program", "Judge whether a program cuts what was drawn."),
    "machine": _Command(
        "machine", "Show a machine: its stations, their datums and their tools' dimensions."
    ),
    "calibrate": _Command(
        "calibrate",
        "Say how far a cutter gives way, from a contour cut without any deflection set.",
    ),
    "job": _Command(
        "job", "The jobs of a server: list, show, confirm, hold, resume, cancel, finish, …"
    ),
    "serve": _Command(
        "service", "Serve the page and the API, with everything embedded, until Ctrl-C."
    ),
    "worker": _Command("service", "Compile the jobs of a database until Ctrl-C."),
    "gateway": _Command(
        "service", "Claim the jobs of a machine and stream them to its controller."
    ),
    "simulator": _Command(
        "service", "Be a table: listen where a controller would, and move as it would."
    ),
    "schema": _Command(
        "schema",
        "Print the JSON Schema of machine, board or profile files, for editors.",
    ),
    "profile": _Command("profile", "Classification profiles: list, show, export, import."),
}


def loaded(name: str) -> Any:
    """Return a command with its parameters, from the module that registers it."""
    # Imports create only objects that live until the end: not one is worth looking for, now or
    # in a later collection.
    gc.disable()
    app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)
    app.callback()(lambda: None)  # without one, an app of one command is that command
    import_module(f"knifetip.cli.{COMMANDS[name].module}").register(app)
    gc.freeze()
    gc.enable()
    group: Any = typer.main.get_command(app)
    return group.commands[name]


class _Commands(TyperGroup):
    """The commands by name and first sentence; the one that is called is loaded."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Return the name of the command that is called, the command, and its arguments."""
        name, _, rest = super().resolve_command(ctx, args)
        return name, None if name is None else loaded(name), rest


app = _Commands(
    name="knifetip",
    help="Puts the tip of the knife on the line: carton dielines in, compensated programs out.",
    commands={name: TyperCommand(name, help=one.help) for name, one in COMMANDS.items()},
    no_args_is_help=True,
    rich_markup_mode=None,
)


def main() -> None:
    """Run the command line; a ``KnifetipError`` is printed and ends with exit code 3."""
    try:
        app()
    except KnifetipError as error:
        from knifetip.cli.terminal import UNUSABLE, report_error  # most commands do not fail

        report_error(error)
        sys.exit(UNUSABLE)
    except KeyboardInterrupt:
        sys.exit(130)
