"""knifetip calibrate: how far a cutter gives way in a board, from a test cut that was measured."""

from __future__ import annotations

import csv
import io
from dataclasses import asdict
from enum import Enum
from pathlib import Path
from typing import Annotated

import typer

from knifetip.cli.drawing import Json
from knifetip.cli.program import BoardName, MachineName
from knifetip.cli.terminal import print_stderr, read_bytes, show, write_bytes
from knifetip.compensation.calibration import calibrate as fit_deflection
from knifetip.errors import LibraryError
from knifetip.library import deflection, load
from knifetip.model.board import Deflection

_COLUMNS = ("azimuth", "dx", "dy")


class Side(Enum):
    """On which side of travel the cutter ran."""

    LEFT = "left"
    RIGHT = "right"


def points(name: str, data: bytes) -> tuple[list[float], list[tuple[float, float]]]:
    """Return azimuths (degrees), and ΔX and ΔY (mm), of a CSV file with these three columns.

    Raises
    ------
    LibraryError
        A column is missing, or a value is no number; the line is named.
    """
    try:
        rows = list(csv.DictReader(io.StringIO(data.decode("utf-8-sig")), strict=True))
    except (UnicodeDecodeError, csv.Error) as reason:
        raise LibraryError("calibration.not-csv", file=name, reason=reason) from reason
    azimuths, measured = [], []
    for line, row in enumerate(rows, 2):
        if lost := [column for column in _COLUMNS if row.get(column) is None]:
            raise LibraryError(
                "calibration.missing-column", file=name, line=line, columns=" or ".join(lost)
            )
        try:
            azimuth, dx, dy = (float(row[column]) for column in _COLUMNS)
        except ValueError as reason:
            raise LibraryError(
                "calibration.not-a-number", file=name, line=line, reason=reason
            ) from reason
        azimuths.append(azimuth)
        measured.append((dx, dy))
    return azimuths, measured


def register(app: typer.Typer) -> None:
    """Add the commands of this module."""

    @app.command()
    def calibrate(
        file: Annotated[
            Path, typer.Argument(metavar="POINTS", help="CSV: azimuth,dx,dy in degrees and mm.")
        ],
        machine: MachineName,
        board: BoardName,
        tool: Annotated[
            str | None, typer.Option(help="Name of the cutter's station; else the only one.")
        ] = None,
        side: Annotated[
            Side, typer.Option(help="Of travel, where the cutter ran: left in our programs.")
        ] = Side.LEFT,
        store: Annotated[
            Path | None,
            typer.Option(metavar="FILE", help="Write the board's TOML with it, for --board."),
        ] = None,
        json: Json = False,
    ) -> None:
        """Say how far a cutter gives way, from a contour cut without any deflection set.

        A point is where the cutter ran along AZIMUTH and the contour came to lie DX and DY beside
        where it was drawn.  Take points where it runs along X, and others along Y, or at 45°.
        """
        table = load.machine(machine)
        text = load.text_of_board(board)
        cutters = [one.name for one in table.stations if one.tool.yields]
        if tool is None and len(cutters) > 1:
            raise LibraryError(
                "calibration.choose-cutter",
                machine=table.title,
                count=len(cutters),
                cutters=cutters,
            )
        station = load.cutter_of(table, tool or next(iter(cutters), ""))
        azimuths, measured = points(file.name, read_bytes(file))
        made = fit_deflection(azimuths, measured, 1 if side is Side.LEFT else -1)
        kept = Deflection(station.name, made.x, made.y)
        lines = deflection.table(kept)
        if store is not None:
            write_bytes(store, deflection.stored(text, kept).encode())
        if json:
            show({"tool": station.name, **asdict(made), "toml": lines})
            return
        typer.echo(lines, nl=False)
        where = f"kept in {store}" if store is not None else "lines for the board's file"
        print_stderr(
            f"{len(azimuths)} points, none farther than {made.residual:.4f} mm from it; {where}."
        )
