"""knifetip schema: print the JSON Schema of machine, board, tool or profile files."""

from __future__ import annotations

from enum import Enum
from typing import Annotated

import typer

from knifetip.cli.terminal import print_json
from knifetip.library.schema import json_schema


class File(Enum):
    """Kinds of TOML files for which a JSON Schema can be printed."""

    MACHINE = "machine"
    BOARD = "board"
    TOOL = "tool"
    PROFILE = "profile"


def register(app: typer.Typer) -> None:
    """Add the command ``schema`` to a Typer application."""

    @app.command()
    def schema(
        file: Annotated[
            File,
            typer.Argument(
                metavar="KIND", help="Kind of TOML file: machine, board, tool or profile."
            ),
        ],
    ) -> None:
        """Print the JSON Schema of machine, board, tool or profile files.

        Editors use it to check and complete TOML files.
        """
        print_json(json_schema(file.value))
