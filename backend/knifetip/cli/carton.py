"""knifetip carton: draw a carton of a standard style as a DXF file.

There is a subcommand for each style, whose options are the fields of its parameters.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from knifetip.cartons.registry import STYLES
from knifetip.cartons.style import Style
from knifetip.cli.options import expand
from knifetip.cli.terminal import in_words, print_json, print_line, write_bytes
from knifetip.library import load

Output = Annotated[Path, typer.Option("-o", "--output", metavar="FILE", help="DXF file to write.")]
Listing = Annotated[bool, typer.Option("--list", help="List the styles and their usual sizes.")]
Json = Annotated[bool, typer.Option("--json", help="With --list: print the list as JSON.")]


def register(app: typer.Typer) -> None:
    """Add the command ``carton`` with a subcommand for each style to a Typer application."""
    carton = typer.Typer(help="Draw a carton of a standard style as a DXF file.")

    @carton.callback(invoke_without_command=True)
    def list_styles(context: typer.Context, list: Listing = False, json: Json = False) -> None:
        """Draw a carton of a standard style as a DXF file.

        The dimensions are inner ones, in mm; the thickness of the board decides the allowances.
        """
        if json:
            print_json([_style_json(style) for style in STYLES.values()])
        elif list:
            for style in STYLES.values():
                print_line(f"{style.code:16} {in_words(style.name)}")
                print_line(f"{'':16} {in_words(style.description)}")
        elif context.invoked_subcommand is None:
            print_line(context.get_help())

    for style in STYLES.values():
        carton.command(style.code, help=_help(style))(expand(_command(style)))
    app.add_typer(carton, name="carton")


def _command(style: Style) -> Callable[..., None]:
    """Return the command that draws a style; its annotations decide its options."""

    def draw(parameters: Any, output: Path, board: str) -> None:
        from knifetip.cartons.file import carton_dxf  # ezdxf is slow to import

        data = carton_dxf(style.draw(parameters, load.board(board)))
        write_bytes(output, data)
        print_line(str(output))

    name = typer.Option(help="Name of a board of the library, or its TOML file.")
    draw.__annotations__ = {
        "parameters": style.parameters,
        "output": Output,
        "board": Annotated[str, name],
        "return": None,
    }
    return draw


def _help(style: Style) -> str:
    example = style.example
    return (
        f"{style.name}.\n\n{style.description}. "
        f"Example: --length {example.length:g} --width {example.width:g} "
        f"--depth {example.depth:g} --board {style.board} -o {style.code}.dxf"
    )


def _style_json(style: Style) -> dict[str, Any]:
    return {
        "code": style.code,
        "name": in_words(style.name),
        "description": in_words(style.description),
        "parameters": style.parameters.model_json_schema(),
        "example": style.example.model_dump(),
        "board": style.board,
    }
