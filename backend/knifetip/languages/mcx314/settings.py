"""settings: read the settings of an MCX314 machine from ``[controller]`` in its TOML file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any

from annotated_types import Le
from pydantic import Field

from knifetip.fields import InvalidFields, PartTable, check_fields
from knifetip.languages.mcx314 import figures
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.model.tool.base import Positive

#: Slowest rate of a feed (pulses/s): whole pulses per second are exact enough above it.
LEAST_RATE = 5000.0
#: Outputs of the board, numbered from 0.
OUTPUTS = 16

_Fault = tuple[tuple[str, ...], str, dict[str, Any]]


class PulsesTable(PartTable):
    """The TOML table of the pulses of each axis."""

    x: Positive
    y: Positive
    z: Positive
    c: Positive


class ControllerTable(PartTable):
    """The TOML table ``[controller]`` of an MCX314 machine."""

    pulses: PulsesTable
    multiple: int = Field(gt=0, le=figures.GREATEST_MULTIPLE)
    start: int = Field(gt=0)
    acceleration: int = Field(gt=0)
    refill: Positive
    corner: Annotated[float, Le(90.0)] = Field(ge=0.0)

    def record(self) -> Wiring:
        """Return the wiring that the TOML table describes."""
        pulses = self.pulses
        return Wiring(
            (pulses.x, pulses.y, pulses.z, pulses.c),
            self.multiple,
            self.start,
            self.acceleration,
            self.refill,
            self.corner,
        )


class Settings(PartTable):
    """The part of a machine's TOML file that contains the settings of an MCX314."""

    controller: ControllerTable


def read_settings(fields: Mapping[str, Any], machine: Machine) -> Wiring:
    """Return the settings of an MCX314 machine, read from its TOML file.

    ``fields`` is the table ``[controller]`` of the file.

    Raises
    ------
    InvalidFields
        The table is invalid, or the chip cannot drive such a machine.
    """
    wiring = check_fields(Settings, {"controller": fields}).controller.record()
    for check in (_check_rates, _check_axes, _check_stations):
        if fault := next(check(wiring, machine), None):
            path, code, arguments = fault
            message = Message(code, path=" → ".join(path), **arguments)
            raise InvalidFields([message], path)
    return wiring


def _check_rates(wiring: Wiring, machine: Machine) -> Iterator[_Fault]:
    """Yield a fault if the registers of the chip cannot contain the start speed or the ramp."""
    del machine
    unit = wiring.multiple
    for name, value, step, most in (
        ("start", wiring.start, unit, figures.FASTEST),
        ("acceleration", wiring.acceleration, unit * figures.RAMP_UNIT, figures.STEEPEST),
    ):
        if value % step or value > step * most:
            path = ("controller", name)
            yield path, "mcx314.bad-rate", {"value": value, "step": step, "limit": step * most}


def _check_axes(wiring: Wiring, machine: Machine) -> Iterator[_Fault]:
    """Yield a fault for each axis that is too fast or too long for the chip."""
    fastest = figures.FASTEST * wiring.multiple
    for letter, scale in zip("xyzc", wiring.pulses, strict=True):
        axis = getattr(machine, letter)
        path = ("axes", letter)
        if axis.velocity * scale > fastest:
            rate = axis.velocity * scale
            yield (*path, "velocity"), "mcx314.axis-too-fast", {"rate": rate, "limit": fastest}
        pulses = round((axis.high - axis.low) * scale)
        if pulses > figures.LARGEST:
            yield path, "mcx314.axis-too-long", {"pulses": pulses, "limit": figures.LARGEST}


def _check_stations(wiring: Wiring, machine: Machine) -> Iterator[_Fault]:
    """Yield a fault for each setting with which a program cannot drive the tool of a station."""
    for row, station in enumerate(machine.stations, 1):
        path = (f"station {row}",)
        if station.is_beam or station.tool.outputs:
            yield (*path, "tool"), "mcx314.tool-not-supported", {}
        if station.spindle != "M3" or station.spindle_speed:
            yield (*path, "spindle"), "mcx314.spindle-not-supported", {}
        if station.output >= OUTPUTS:
            yield (*path, "output"), "field.above", {"value": station.output, "limit": OUTPUTS - 1}
        for name in ("feed", "plunge"):
            # A move along a diagonal in space has the lowest rate.
            rate = getattr(station.tool, name) / 60.0 * min(wiring.pulses[:3]) / 3.0**0.5
            if rate < LEAST_RATE:
                arguments = {"rate": rate, "limit": LEAST_RATE}
                yield (*path, "tool", name), "mcx314.feed-too-slow", arguments
