"""knifetip machine: show the stations of a machine and the dimensions of their tools."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from knifetip.cli.drawing import Json
from knifetip.cli.terminal import in_words, print_json, print_line
from knifetip.errors import LibraryError
from knifetip.languages.registry import find_language
from knifetip.library import load
from knifetip.messages import Argument, Message
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
    apart = Message("output.carriages", distance=gantry.min_distance)
    print_line(f"  {in_words(apart)}")
    for number, carriage in enumerate(gantry.carriages, 1):
        stations = [str(one.number) for one in machine.stations if one.carriage == number]
        axes: dict[str, Argument] = {
            "axes": list(carriage.letters),
            "letter": carriage.letters[1],
            "park": carriage.park,
        }
        if stations:
            row = Message("output.carriage", number=number, **axes, stations=stations)
        else:
            row = Message("output.carriage-without-station", number=number, **axes)
        print_line(f"  {in_words(row)}")


def _setting_lines(machine: Machine) -> list[str]:
    """Return the lines that set the settings of the controller of a machine.

    Raises ``LibraryError``: the controllers of the machine's language have no settings that are
    known.
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
        language, feed = chosen.dialect, chosen.feed
        title = {"title": chosen.title, "name": chosen.name}
        print_line(in_words(Message("output.machine", **title, language=language, feed=feed)))
        if chosen.gantry:
            _print_carriages(chosen, chosen.gantry)
        for zone in chosen.zones:
            x, y = (zone.x, zone.x + zone.width), (zone.y, zone.y + zone.height)
            extent = {"left": x[0], "right": x[1], "bottom": y[0], "back": y[1]}
            row = Message("output.zone", name=zone.name, **extent, top=zone.top)
            print_line(f"  {in_words(row)}")
        for row in data["stations"]:
            tool = dict(row["tool"])
            datum = ", ".join(f"{axis} {value:g}" for axis, value in row["datum"].items())
            station = {"number": row["number"], "name": row["name"], "tool": tool.pop("kind")}
            print_line(f"  {in_words(Message('output.station', **station, datum=datum))}")
            print_line("     " + ", ".join(f"{key} {value:g}" for key, value in tool.items()))
