"""knifetip calibrate: compute the deflection of a cutter in a board from a measured test cut."""

from __future__ import annotations

import csv
import io
from dataclasses import asdict
from enum import Enum
from pathlib import Path
from typing import Annotated

import typer

from knifetip.cli.drawing import Json
from knifetip.cli.options import expand
from knifetip.cli.program import TargetOptions
from knifetip.cli.terminal import print_json, print_message, read_bytes, write_bytes
from knifetip.compensation.calibration import calibrate as fit_deflection
from knifetip.errors import LibraryError
from knifetip.library import deflection, load
from knifetip.messages import Message
from knifetip.model.board import Deflection

_COLUMNS = ("azimuth", "dx", "dy")


class Side(Enum):
    """Side of the drawn contour on which the cutter ran, seen in the direction of travel."""

    LEFT = "left"
    RIGHT = "right"


def read_points(name: str, data: bytes) -> tuple[list[float], list[tuple[float, float]]]:
    """Return the azimuths (degrees) and the offsets (ΔX, ΔY) (mm) of the points in a CSV file.

    An azimuth is the direction of travel at a measured point; an offset is the vector from the
    drawn to the cut contour.  The file has the columns ``azimuth``, ``dx`` and ``dy``.

    Raises
    ------
    LibraryError
        A column is missing or a value is not a number; the message contains the line number.
    """
    try:
        rows = list(csv.DictReader(io.StringIO(data.decode("utf-8-sig")), strict=True))
    except (UnicodeDecodeError, csv.Error) as reason:
        raise LibraryError("calibration.not-csv", file=name, reason=reason) from reason
    azimuths, offsets = [], []
    for line, row in enumerate(rows, 2):
        if missing := [column for column in _COLUMNS if row.get(column) is None]:
            raise LibraryError("calibration.missing-column", file=name, line=line, columns=missing)
        try:
            azimuth, dx, dy = (float(row[column]) for column in _COLUMNS)
        except ValueError as reason:
            raise LibraryError(
                "calibration.not-a-number",
                file=name,
                line=line,
                values=[row[column] for column in _COLUMNS],
            ) from reason
        azimuths.append(azimuth)
        offsets.append((dx, dy))
    return azimuths, offsets


def calibrate(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="POINTS",
            help="CSV file with the heading azimuth,dx,dy; each other line has the values of one "
            "point, in degrees, mm and mm.",
        ),
    ],
    target: TargetOptions,
    tool: Annotated[
        str | None,
        typer.Option(
            help="Name of the station that carries the cutter. Default: the only station with a "
            "cutter."
        ),
    ] = None,
    side: Annotated[
        Side,
        typer.Option(
            help="Side of the contour on which the cutter moved, seen in the "
            "direction of travel. In "
            "programs of knifetip it is the left side."
        ),
    ] = Side.LEFT,
    store: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="Write a board file (TOML) that contains the deflection to "
            "FILE; the option --board "
            "of all commands accepts it. Default: print only.",
        ),
    ] = None,
    json: Json = False,
) -> None:
    """Compute the deflection of a cutter from a measured test cut.

    The test contour is cut without compensation of the deflection.
    Each point has the direction of travel AZIMUTH and the measured offset DX, DY of the cut
    contour from the drawn one.  Measure points on edges along X, along Y, and at 45°.
    """
    machine = load.machine(target.machine)
    text = load.board_toml(target.board)
    cutters = [station.name for station in machine.stations if station.tool.yields]
    if tool is None and len(cutters) > 1:
        raise LibraryError(
            "calibration.choose-cutter",
            machine=machine.title,
            count=len(cutters),
            cutters=cutters,
        )
    station = load.find_cutter(machine, tool or next(iter(cutters), ""))
    azimuths, offsets = read_points(file.name, read_bytes(file))
    fitted = fit_deflection(azimuths, offsets, 1 if side is Side.LEFT else -1)
    result = Deflection(station.name, fitted.x, fitted.y)
    lines = deflection.deflection_toml(result)
    if store is not None:
        write_bytes(store, deflection.replace_deflection(text, result).encode())
    if json:
        print_json({"tool": station.name, **asdict(fitted), "toml": lines})
        return
    typer.echo(lines, nl=False)
    added = Message("output.add-lines")
    where = added if store is None else Message("output.written-to", file=store)
    count, residual = len(azimuths), fitted.residual
    print_message(Message("output.calibrated", count=count, residual=residual, where=where))


def register(app: typer.Typer) -> None:
    """Add the command ``calibrate`` to the Typer application of the command line."""
    app.command()(expand(calibrate))
