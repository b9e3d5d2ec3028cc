"""machine: machines as JSON data, for the API and the command line."""

from __future__ import annotations

from dataclasses import asdict, fields
from typing import Any

from knifetip.languages.registry import find_language
from knifetip.model.machine import Machine, Station
from knifetip.model.machine_properties import MachineProperties


def machine_json(machine: Machine) -> dict[str, Any]:
    """Return a machine without its stations as JSON data (mm, degrees, mm/min)."""
    names = [one.name for one in fields(MachineProperties)]
    return {
        "name": machine.name,
        "version": machine.version,
        **{name: getattr(machine, name) for name in names},
        "language": find_language(machine.dialect).title,
        "origin": list(machine.origin),
        "feed_override": list(machine.feed_override),
        "axes": {letter.lower(): asdict(axis) for letter, axis in machine.axes.items()},
        "carriages": [
            {"number": number, "letters": carriage.letters, "park": carriage.park}
            for number, carriage in enumerate(machine.carriages, 1)
        ],
        "min_distance": machine.gantry.min_distance if machine.gantry else None,
        "zones": [asdict(zone) for zone in machine.zones],
    }


def station_json(station: Station) -> dict[str, Any]:
    """Return a station without its tool as JSON data (mm, degrees)."""
    return {
        "number": station.number,
        "name": station.name,
        "carriage": station.carriage,
        "datum": {axis: getattr(station, axis) for axis in "xyzc"},
        "output": station.output,
        "envelope": station.envelope,
        "life": station.life,
        "spindle": station.spindle if station.speed else "",
        "spindle_speed": station.speed,
    }
