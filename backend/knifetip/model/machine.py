"""Machine: its axes, its tool stations and where each stands."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.model.tool import Tool


@dataclass(frozen=True, slots=True)
class Axis:
    """One axis: its travel and how fast it can go (mm or degrees, and seconds)."""

    low: float  #: least joint position
    high: float  #: greatest joint position
    velocity: float  #: per second
    acceleration: float  #: per second squared


@dataclass(frozen=True, slots=True)
class Station:
    """A place on the beam that holds one tool.

    Joint position = programmed position + datum.
    """

    number: int  #: the T word
    name: str
    tool: Tool
    x: float  #: datum (mm)
    y: float  #: datum (mm)
    z: float  #: datum (mm)
    c: float  #: mounting angle (degrees)
    output: int  #: digital output of the piston that lowers the station; -1 where it has none


@dataclass(frozen=True, slots=True)
class Machine:
    """A flatbed sample-maker.  Z0 is the top of the cutting mat, up is positive."""

    name: str
    title: str
    width: float  #: of the table, along X (mm)
    height: float  #: of the table, along Y (mm)
    x: Axis
    y: Axis
    z: Axis
    c: Axis
    stations: tuple[Station, ...]
    dialect: str  #: name of its controller's language
    origin: tuple[float, float]  #: where a drawing's lower left corner is placed (mm)
    travel_z: float  #: height of the tip for rapids, above the mat (mm)
    clearance: float  #: height of the tip above the board where plunging begins (mm)
    into_mat: float  #: how deep a through cut goes into the mat (mm)
    settle: float  #: seconds to wait after a piston or the oscillation is switched
    feed: str = "manual"  #: how a sheet gets onto the table: ``manual`` or ``automatic``
    controller: object = None  #: settings of the controller, as its language reads them

    def station(self, number: int) -> Station:
        """Return the station with this T number.

        Raises
        ------
        KeyError
            The machine has no such station.
        """
        for station in self.stations:
            if station.number == number:
                return station
        raise KeyError(number)
