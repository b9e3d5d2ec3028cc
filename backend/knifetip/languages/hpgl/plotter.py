"""plotter: the settings of an HPGL device and its pens, read from a machine's TOML file.

The emitter and the verifier's reader of HPGL share these records, but no computation.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from importlib import resources
from typing import Any, Final

from knifetip.model.machine import Machine, Station
from knifetip.model.tool import Engine, Knife, kind_of

#: Number of mm/min in 1 cm/s.
CM_PER_SECOND: Final = 600.0


class PenWork(StrEnum):
    """Operation that a pen makes in the board: cut, half-cut or crease."""

    CUT = "cut"  #: through the board
    HALF_CUT = "half-cut"
    CREASE = "crease"


@dataclass(frozen=True, slots=True)
class Device:
    """Type of plotter or flat cutter."""

    title: str
    units: float  #: plotter units per millimetre
    area: tuple[int, int, int, int]  #: x0 y0 x1 y1 of the reachable area (plotter units)
    zero: tuple[float, float]  #: position of unit 0, 0 on the table (mm)
    pens: int  #: number of pens that SP can select
    speed: tuple[int, int] | None  #: least and greatest VS (cm/s); None without VS
    force: tuple[int, int] | None  #: least and greatest FS; None without FS
    comments: bool  #: whether the device supports the comment instruction CO


@dataclass(frozen=True, slots=True)
class Pen:
    """One pen number of an HPGL device: a tool in a station, used for one kind of operation."""

    number: int  #: argument of SP
    station: int  #: number of the machine's station
    work: PenWork
    force: int  #: argument of FS; 0 if the device lacks FS


@dataclass(frozen=True, slots=True)
class Plotter:
    """Settings of an HPGL machine: its device and its pens."""

    device: Device
    pens: tuple[Pen, ...]


def read_settings(fields: Mapping[str, Any], machine: Machine) -> Plotter:
    """Return the HPGL settings of a machine, read from its TOML file.

    ``fields`` is the table ``[controller]`` of the file.

    Raises
    ------
    ValueError
        The table is invalid, or HPGL cannot drive such a machine.
    """
    device = _read_device(fields.get("device", ""), machine)
    pens = tuple(_read_pen(row, device) for row in fields.get("pen", ()))
    numbers = [pen.number for pen in pens]
    if len(set(numbers)) != len(numbers):
        raise ValueError(f"pen numbers {numbers} must differ; give each pen its own number")
    for station in machine.stations:
        _check_station(station, device)
    for pen in pens:
        _check_pen(pen, machine)
    works = [(pen.station, pen.work) for pen in pens]
    if len(set(works)) != len(works):
        raise ValueError("two pens of one station do the same work; remove one of them")
    if idle := {station.number for station in machine.stations} - {pen.station for pen in pens}:
        raise ValueError(f"station {min(idle)} has no [[controller.pen]]; add one")
    x0, y0, x1, y1 = device.area
    for axis, zero, low, high in (("x", 0, x0, x1), ("y", 1, y0, y1)):
        reach = [device.zero[zero] + edge / device.units for edge in (low, high)]
        travel = getattr(machine, axis)
        if travel.low < reach[0] - 1e-9 or travel.high > reach[1] + 1e-9:
            raise ValueError(
                f"axes.{axis} goes from {travel.low:g} to {travel.high:g}, but the device reaches "
                f"{reach[0]:g} to {reach[1]:g} mm"
            )
    return Plotter(device, pens)


@cache
def _shipped_devices() -> Mapping[str, Mapping[str, Any]]:
    """Return the settings of the HPGL devices that knifetip ships, by the name of the device."""
    text = (resources.files(__package__) / "devices.toml").read_text("utf-8")
    return tomllib.loads(text)


def _read_device(value: Any, machine: Machine) -> Device:
    """Return the HPGL device that ``value``, a field of a machine's TOML file, names or describes.

    ``value`` is the name of a shipped device, or a table with the fields of a device.  Raises
    ``ValueError`` if there is no such device or a field is invalid.
    """
    if not isinstance(value, Mapping):
        if value not in _shipped_devices():
            known = ", ".join(sorted(_shipped_devices()))
            raise ValueError(
                f"controller.device is {value!r}; give one of {known}, or a table with their fields"
            )
        value = _shipped_devices()[value]
    units = float(value["units"])
    x0, y0, x1, y1 = (int(edge) for edge in value["area"])
    if not units > 0.0 or x0 >= x1 or y0 >= y1:
        raise ValueError("controller.device must have units of more than 0 and x0 < x1, y0 < y1")
    if value["origin"] not in ("corner", "centre"):
        raise ValueError(f"controller.device.origin is {value['origin']!r}: corner or centre")
    centred = value["origin"] == "centre"
    return Device(
        title=str(value["title"]),
        units=units,
        area=(x0, y0, x1, y1),
        zero=(machine.width / 2.0, machine.height / 2.0) if centred else (0.0, 0.0),
        pens=int(value["pens"]),
        speed=_read_range(value.get("speed"), "speed"),
        force=_read_range(value.get("force"), "force"),
        comments=bool(value.get("comments", False)),
    )


def _read_range(value: Any, name: str) -> tuple[int, int] | None:
    """Return the least and greatest value of a device's setting, None if the setting is absent.

    ``value`` is the setting, a pair of numbers or None; ``name`` is its name, for errors.
    """
    if value is None:
        return None
    least, greatest = int(value[0]), int(value[1])
    if not 0 < least <= greatest:
        raise ValueError(f"controller.device.{name} is {value!r}, and must be [least, greatest]")
    return least, greatest


def _read_pen(row: Mapping[str, Any], device: Device) -> Pen:
    """Return the pen that one table ``[[controller.pen]]`` describes, given as ``row``.

    Raises ``ValueError`` if a field of the pen is invalid.
    """
    number, force = int(row["number"]), int(row.get("force", 0))
    if not 1 <= number <= device.pens:
        raise ValueError(f"pen {number}: {device.title} has pens 1 to {device.pens}")
    if device.force is None and force:
        raise ValueError(
            f"pen {number} has a force, but {device.title} has no FS; remove the force"
        )
    if device.force is not None and not device.force[0] <= force <= device.force[1]:
        raise ValueError(
            f"pen {number}: force is {force}, and must be {device.force[0]} to {device.force[1]}"
        )
    try:
        work = PenWork(row["work"])
    except ValueError:
        known = ", ".join(PenWork)
        raise ValueError(f"pen {number}: work is {row['work']!r}; give one of {known}") from None
    return Pen(number, int(row["station"]), work, force)


def _check_station(station: Station, device: Device) -> None:
    """Raise ``ValueError`` if HPGL cannot drive the tool of a station."""
    where = f"station {station.number}"
    tool = station.tool
    if kind_of(tool).engine not in (Engine.KNIFE, Engine.CREASE):
        raise ValueError(
            f"{where}: HPGL has neither depths nor headings, but the tool needs them; remove the "
            "station"
        )
    if any((station.x, station.y, station.z, station.c)) or station.output >= 0:
        raise ValueError(
            f"{where}: the device stores the offsets of its tools; set the datum to 0 and remove "
            "output"
        )
    if isinstance(tool, Knife) and tool.trail:
        raise ValueError(f"{where}: the device compensates the trail of its knife; set trail to 0")
    if device.speed is None:
        return
    speed = tool.feed / CM_PER_SECOND
    if speed != round(speed) or not device.speed[0] <= speed <= device.speed[1]:
        least, greatest = (CM_PER_SECOND * limit for limit in device.speed)
        raise ValueError(
            f"{where}: feed is {tool.feed:g} mm/min, but {device.title} has multiples of "
            f"{CM_PER_SECOND:g} from {least:g} to {greatest:g}"
        )


def _check_pen(pen: Pen, machine: Machine) -> None:
    """Raise ``ValueError`` if a pen's station does not exist or cannot make the pen's operation."""
    try:
        tool = machine.station(pen.station).tool
    except KeyError:
        raise ValueError(f"pen {pen.number}: the machine has no station {pen.station}") from None
    if (kind_of(tool).engine is Engine.CREASE) is not (pen.work is PenWork.CREASE):
        raise ValueError(f"pen {pen.number}: the tool of station {pen.station} cannot {pen.work}")
