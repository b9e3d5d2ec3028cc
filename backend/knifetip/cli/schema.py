"""knifetip schema: JSON Schema of machines, boards and profiles, for editors."""

from __future__ import annotations

from enum import Enum
from typing import Annotated

import typer

from knifetip.cli.terminal import show
from knifetip.library.schema import json_schema


class File(Enum):
    """What a file describes."""

    MACHINE = "machine"
    BOARD = "board"
    PROFILE = "profile"


def register(app: typer.Typer) -> None:
    """Add the commands of this module."""

    @app.command()
    def schema(
        file: Annotated[File, typer.Argument(metavar="FILE", help="machine, board or profile.")],
    ) -> None:
        """Print the JSON Schema of machine, board or profile files, for editors."""
        show(json_schema(file.value))
