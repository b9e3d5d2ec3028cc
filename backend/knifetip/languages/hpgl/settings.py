"""settings: read the settings of an HPGL machine from ``[controller]`` in its TOML file."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from importlib import resources
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import AfterValidator, BeforeValidator, Field, GetJsonSchemaHandler
from pydantic_core import CoreSchema

from knifetip.fields import LISTED, InvalidFields, PartTable, check_fields, field_error
from knifetip.languages.hpgl.plotter import CM_PER_SECOND, Device, Pen, PenWork, Plotter
from knifetip.messages import Message
from knifetip.model.machine import Machine, Station
from knifetip.model.tool import Engine, Knife, kind_of
from knifetip.model.tool.base import Positive


class _Fault(NamedTuple):
    """A fault of a field of a TOML file: the path of the field, and the code and arguments of the
    message.
    """

    path: tuple[str, ...]
    code: str
    arguments: Mapping[str, Any]

    @property
    def message(self) -> Message:
        """The message of the fault, with the path of the field as an argument."""
        return Message(self.code, path=" → ".join(self.path), **self.arguments)


def _fault(path: Sequence[str], code: str, **arguments: Any) -> _Fault:
    """Return the fault of the field ``path`` of a TOML file, with the message code ``code``.

    Other keyword arguments are arguments of the message.
    """
    return _Fault(tuple(path), code, arguments)


@cache
def _shipped_devices() -> Mapping[str, Mapping[str, Any]]:
    """Return the settings of the HPGL devices that knifetip ships, by the name of the device."""
    text = (resources.files(__package__) / "devices.toml").read_text("utf-8")
    return tomllib.loads(text)


def _find_device(value: Any) -> Any:
    """Return the fields of an HPGL device.

    ``value`` is either the table of the fields itself, which is returned unchanged, or the name of
    a device that knifetip ships.  A name that is not the name of such a device raises a field
    error.
    """
    if isinstance(value, Mapping):
        return value
    if value not in list(_shipped_devices()):
        raise field_error("field.not-one-of", known=map(repr, sorted(_shipped_devices())))
    return _shipped_devices()[value]


def _check_area(value: list[int]) -> list[int]:
    x0, y0, x1, y1 = value
    if x0 >= x1 or y0 >= y1:
        raise field_error("hpgl.bad-area")
    return value


def _check_range(value: list[int]) -> list[int]:
    if not 0 < value[0] <= value[1]:
        raise field_error("hpgl.bad-range")
    return value


_Range = Annotated[list[int], Field(min_length=2, max_length=2), AfterValidator(_check_range)]


class DeviceTable(PartTable):
    """The TOML table of an HPGL device, as in ``devices.toml``."""

    title: str = Field(description="name of the device")
    units: Positive = Field(description="plotter units in one millimetre")
    area: Annotated[list[int], Field(min_length=4, max_length=4), AfterValidator(_check_area)] = (
        Field(
            title="Reachable area",
            description="x and y of two corners of the reachable area: x0, y0, x1, y1 (units)",
            json_schema_extra={"itemTitles": ["Left", "Bottom", "Right", "Top"]},
        )
    )
    origin: Annotated[Literal["corner", "centre"], LISTED] = Field(
        description="place of unit 0, 0: lower left corner or centre of the table"
    )
    pens: int = Field(gt=0, description="number of tools that SP can select")
    speed: _Range | None = Field(
        None,
        description="least and greatest VS (cm/s), if the device has it",
        json_schema_extra={"itemTitles": ["Least speed", "Greatest speed"]},
    )
    force: _Range | None = Field(
        None,
        description="least and greatest FS (steps of the device), if the device has it",
        json_schema_extra={"itemTitles": ["Least force", "Greatest force"]},
    )
    comments: bool = Field(False, description="the device reads the instruction CO (HP-GL/2)")

    def record(self, machine: Machine) -> Device:
        """Return the device that the TOML table describes; ``machine`` is the machine that it
        belongs to.
        """
        x0, y0, x1, y1 = self.area
        centred = self.origin == "centre"
        return Device(
            title=self.title,
            units=self.units,
            area=(x0, y0, x1, y1),
            zero=(machine.width / 2.0, machine.height / 2.0) if centred else (0.0, 0.0),
            pens=self.pens,
            speed=(self.speed[0], self.speed[1]) if self.speed else None,
            force=(self.force[0], self.force[1]) if self.force else None,
            comments=self.comments,
        )


class PenTable(PartTable):
    """The TOML table of one pen of an HPGL device."""

    number: int = Field(gt=0, description="number of the pen in programs (SP)")
    station: int = Field(description="number of the station that holds the tool")
    work: Annotated[PenWork, Field(strict=False), LISTED] = Field(
        description="what the pen makes in the board"
    )
    force: int = Field(0, description="force (FS); 0 if the device has none")

    def record(self) -> Pen:
        """Return the pen that the TOML table describes."""
        return Pen(self.number, self.station, self.work, self.force)


class _NamedDevice:
    """Annotation of a device, which may be the name of a device that knifetip ships."""

    def __get_pydantic_json_schema__(
        self, core: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        names = sorted(_shipped_devices())
        named = [{"type": "string", "const": name, "title": name} for name in names]
        own = {**handler(core), "title": "Another, with these properties"}
        return {"oneOf": [*named, own]}


class ControllerTable(PartTable):
    """The TOML table ``[controller]`` of an HPGL machine."""

    device: Annotated[DeviceTable, BeforeValidator(_find_device), _NamedDevice()] = Field(
        description="plotter or flat cutter: the name of a known device, or its properties"
    )
    pen: list[PenTable] = Field([], description="pens, one for each work of a tool")


class Settings(PartTable):
    """The part of a machine's TOML file that contains the settings of HPGL."""

    controller: ControllerTable


def read_settings(fields: Mapping[str, Any], machine: Machine) -> Plotter:
    """Return the HPGL settings of a machine, read from its TOML file.

    ``fields`` is the table ``[controller]`` of the file.

    Raises
    ------
    InvalidFields
        The table is invalid, or HPGL cannot drive such a machine.
    """
    table = check_fields(Settings, {"controller": fields}).controller
    device = table.device.record(machine)
    plotter = Plotter(device, tuple(pen.record() for pen in table.pen))
    for check in _CHECKS:
        if fault := next(check(plotter, machine), None):
            raise InvalidFields([fault.message], fault.path)
    return plotter


def _check_numbers(plotter: Plotter, _machine: Machine) -> Iterator[_Fault]:
    """Yield a fault if two pens of the plotter have the same number."""
    numbers = [pen.number for pen in plotter.pens]
    if len(set(numbers)) != len(numbers):
        yield _fault(("controller", "pen"), "field.repeated-numbers", numbers=numbers)


def _check_pens(plotter: Plotter, machine: Machine) -> Iterator[_Fault]:
    """Yield a fault for each field of a pen that its device or its station does not support."""
    device, stations = plotter.device, {station.number: station for station in machine.stations}
    works: set[tuple[int, PenWork]] = set()
    for row, pen in enumerate(plotter.pens, 1):
        path = ("controller", f"pen {row}")
        if pen.number > device.pens:
            limit = device.pens
            yield _fault((*path, "number"), "field.above", value=pen.number, limit=limit)
        yield from _check_force((*path, "force"), pen, device)
        if (station := stations.get(pen.station)) is None:
            numbers = sorted(stations)
            yield _fault((*path, "station"), "field.not-one-of", value=pen.station, known=numbers)
        elif _creases(station) is not (pen.work is PenWork.CREASE):
            work, number = pen.work.value, station.number
            yield _fault((*path, "work"), "hpgl.pen-cannot", work=work, station=number)
        if (pen.station, pen.work) in works:
            yield _fault(path, "hpgl.repeated-pen")
        works.add((pen.station, pen.work))


def _check_force(path: Sequence[str], pen: Pen, device: Device) -> Iterator[_Fault]:
    """Yield a fault if a device cannot set the force of a pen.

    ``path`` is the path of the field in the TOML file that contains the force.
    """
    if device.force is None:
        if pen.force:
            yield _fault(path, "hpgl.no-force", value=pen.force, device=device.title)
    elif not device.force[0] <= pen.force <= device.force[1]:
        low, high = device.force
        yield _fault(path, "field.outside", value=pen.force, low=low, high=high)


def _check_stations(plotter: Plotter, machine: Machine) -> Iterator[_Fault]:
    """Yield a fault for each setting with which HPGL cannot drive the tool of a station."""
    device = plotter.device
    for row, station in enumerate(machine.stations, 1):
        path, tool = (f"station {row}",), station.tool
        if kind_of(tool).engine not in (Engine.KNIFE, Engine.CREASE):
            yield _fault((*path, "tool"), "hpgl.tool-not-supported")
        if any((station.x, station.y, station.z, station.c)) or station.output >= 0:
            yield _fault(path, "hpgl.datum")
        if isinstance(tool, Knife) and tool.trail and not tool.free:
            yield _fault((*path, "tool", "trail"), "hpgl.trail", value=tool.trail)
        if isinstance(tool, Knife) and tool.swivel_depth:
            value = tool.swivel_depth
            yield _fault((*path, "tool", "swivel_depth"), "hpgl.swivel-depth", value=value)
        if device.speed is not None:
            speed, (least, greatest) = tool.feed / CM_PER_SECOND, device.speed
            if speed != round(speed) or not least <= speed <= greatest:
                yield _fault(
                    (*path, "tool", "feed"),
                    "hpgl.feed-not-supported",
                    value=tool.feed,
                    device=device.title,
                    step=CM_PER_SECOND,
                    slowest=least * CM_PER_SECOND,
                    fastest=greatest * CM_PER_SECOND,
                )


def _check_idle(plotter: Plotter, machine: Machine) -> Iterator[_Fault]:
    """Yield a fault for each station of the machine that no pen uses."""
    used = {pen.station for pen in plotter.pens}
    for row, station in enumerate(machine.stations, 1):
        if station.number not in used:
            yield _fault((f"station {row}",), "hpgl.station-without-pen")


def _check_travel(plotter: Plotter, machine: Machine) -> Iterator[_Fault]:
    """Yield a fault for each axis of the machine that travels farther than the device reaches."""
    device = plotter.device
    x0, y0, x1, y1 = device.area
    for axis, zero, ends in (("x", device.zero[0], (x0, x1)), ("y", device.zero[1], (y0, y1))):
        least, greatest = (zero + end / device.units for end in ends)
        low, high = getattr(machine, axis).low, getattr(machine, axis).high
        if low < least - 1e-9 or high > greatest + 1e-9:
            measures = {"low": low, "high": high, "least": least, "greatest": greatest}
            yield _fault(("axes", axis), "hpgl.travel", **measures)


def _creases(station: Station) -> bool:
    return kind_of(station.tool).engine is Engine.CREASE


_CHECKS: Sequence[Callable[[Plotter, Machine], Iterator[_Fault]]] = (
    _check_numbers,
    _check_stations,
    _check_pens,
    _check_idle,
    _check_travel,
)
