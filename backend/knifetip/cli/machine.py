"""knifetip machine: show the stations of a machine and the dimensions of their tools."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from knifetip.cli.drawing import Json
from knifetip.cli.terminal import print_json, print_line
from knifetip.errors import LibraryError
from knifetip.languages.registry import find_language
from knifetip.library import load
from knifetip.model.machine import Gantry, Machine, Station
from knifetip.model.tool import kind_of
from knifetip.post.rs274.tool_table import tool_table
from knifetip.presentation.machine import machine_json, station_json


def _machine_json(machine: Machine) -> dict[str, Any]:
    """Return a machine and its stations as JSON data (mm, degrees, mm/min)."""
    return {
        **machine_json(machine),
        "settle": machine.settle,
        "stations": [_station_json(station) for station in machine.stations],
    }


def _station_json(station: Station) -> dict[str, Any]:
    tool = station.tool
    return {
        **station_json(station),
        "tool": {"kind": kind_of(tool).name, **tool.dimensions, **tool.derived},
    }


def _print_carriages(machine: Machine, gantry: Gantry) -> None:
    """Print the carriages of a machine with the letters of their axes and their stations."""
    print_line(f"  carriages at least {gantry.min_distance:g} mm apart")
    for number, carriage in enumerate(gantry.carriages, 1):
        stations = [str(one.number) for one in machine.stations if one.carriage == number]
        print_line(
            f"  carriage {number}: axes {' '.join(carriage.letters)}, parks at "
            f"{carriage.letters[1]}{carriage.park:g}, stations {', '.join(stations) or 'none'}"
        )


def _setting_lines(machine: Machine) -> list[str]:
    """Return the lines that set the settings of the controller of a machine.

    Raises
    ------
    LibraryError
        The controllers of the machine's language have no settings that are known.
    """
    language = find_language(machine.dialect)
    if not language.setting_lines:
        raise LibraryError("library.no-settings", machine=machine.title)
    lines: list[str] = language.load_part("setting_lines")(machine)
    return lines


def register(app: typer.Typer) -> None:
    """Add the command ``machine`` to a Typer application."""

    @app.command()
    def machine(
        name: Annotated[
            str,
            typer.Argument(
                metavar="NAME", help="Name of a machine of the library, or its TOML file."
            ),
        ] = "demo-table",
        json: Json = False,
        table: Annotated[
            bool,
            typer.Option(
                "--tool-table",
                help="Print the tool table of the machine in the format of LinuxCNC.",
            ),
        ] = False,
        settings: Annotated[
            bool,
            typer.Option(
                "--settings",
                help="Print the settings that the controller must have, as lines to type at "
                "grblHAL, or as lines of the INI file of LinuxCNC.",
            ),
        ] = False,
    ) -> None:
        """Show the stations of a machine, with their positions and tools."""
        chosen = load.machine(name)
        if table:
            typer.echo(tool_table(chosen), nl=False)
            return
        if settings:
            for line in _setting_lines(chosen):
                typer.echo(line)
            return
        data = _machine_json(chosen)
        if json:
            print_json(data)
            return
        print_line(f"{chosen.title} ({chosen.name}), language {chosen.dialect}, {chosen.feed} feed")
        if chosen.gantry:
            _print_carriages(chosen, chosen.gantry)
        for zone in chosen.zones:
            print_line(
                f"  keep-out zone {zone.name}: X {zone.x:g} to {zone.x + zone.width:g}, "
                f"Y {zone.y:g} to {zone.y + zone.height:g}, {zone.top:g} mm high"
            )
        for row in data["stations"]:
            tool = dict(row["tool"])
            datum = ", ".join(f"{axis} {value:g}" for axis, value in row["datum"].items())
            print_line(f"  {row['number']}  {row['name']}: {tool.pop('kind')}, datum {datum}")
            print_line("     " + ", ".join(f"{key} {value:g}" for key, value in tool.items()))
