"""Records of a machine: its axes, its carriages, its tool stations and its settings."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Final, TypeVar

from knifetip.geometry.columns import F64
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.machine_properties import MachineProperties
from knifetip.model.tool import KINDS, Cutter, Knife, Planner, Switching, Tool, kind_of

#: A coordinate, or a column of them.
_Length = TypeVar("_Length", float, F64)


@dataclass(frozen=True, slots=True)
class Axis:
    """Range of positions, maximum velocity and acceleration of one axis of a machine.

    The units are mm, mm/s and mm/s²; for a rotary axis degrees, degrees/s and degrees/s².
    """

    low: float  #: minimum joint position
    high: float  #: maximum joint position
    velocity: float  #: maximum velocity (per second)
    acceleration: float  #: maximum acceleration (per second squared)


@dataclass(frozen=True, slots=True)
class Carriage:
    """A carriage on the gantry of a machine: a head with its stations, and the axes that move it.

    All carriages share the X of the gantry.  The Y axes of all carriages have the same zero and the
    same direction.
    """

    axes: tuple[Axis, Axis, Axis, Axis]  #: X, Y, Z and C of the carriage
    #: letters of the words of these axes in programs: "XYZC", or for example "XVZA"; "XYZ" if no
    #: axis turns the tools
    letters: str
    park: float  #: position of the Y of the carriage while another carriage is in use (mm)

    @property
    def is_first(self) -> bool:
        """Whether X, Y and Z of programs move the carriage, so that G2 and G3 make its arcs."""
        return self.letters[:3] == "XYZ"


@dataclass(frozen=True, slots=True)
class Gantry:
    """The carriages of a machine that has more than one."""

    carriages: tuple[Carriage, ...]  #: in the order of their numbers, from 1
    min_distance: float  #: least distance along Y between the positions of two carriages (mm)


@dataclass(frozen=True, slots=True)
class Zone:
    """A keep-out zone: a box on the table, such as a clamp or a stop, that no tool may touch."""

    name: str
    x: float  #: left edge (mm)
    y: float  #: lower edge (mm)
    width: float  #: along X (mm)
    height: float  #: along Y (mm)
    top: float  #: height of its top above the mat (mm)


#: Axis C of a machine that cannot rotate its tools: it has no limits and takes no time.
NO_HEADING: Final = Axis(-1e9, 1e9, 1e9, 1e12)


def has_spindle(tool: Tool) -> bool:
    """Return whether a tool has an oscillation, a spindle or a beam that a program switches on.

    This is also true for a tool whose speed is missing.
    """
    return tool.spindle > 0 or tool.spindle_missing is not None


@dataclass(frozen=True, slots=True)
class Station:
    """A mount on the head of the machine, with one tool.

    The position of a machine axis is the programmed position plus the offset of the station (``x``,
    ``y``, ``z``, ``c``), which is called its datum.
    """

    number: int  #: number in the T word of programs
    name: str
    tool: Tool
    x: float  #: datum (mm)
    y: float  #: datum (mm)
    z: float  #: datum (mm)
    c: float  #: mounting angle (degrees)
    output: int  #: digital output of the piston that lowers the station; -1 for none
    carriage: int = 1  #: number of the carriage that carries the station, see ``Machine.carriages``
    #: radius about the station's axis of its holder at the height of the tip (mm); 0: the tool only
    envelope: float = 0.0
    life: float = 0.0  #: length that the tool may work in the board (m); 0 for no limit
    #: word that switches the oscillation or the spindle of the tool on: ``M3`` or ``M4``
    spindle: str = "M3"
    spindle_speed: float = 0.0  #: S word with it; 0 for that of the tool

    @property
    def reach(self) -> float:
        """Radius about the station's axis within which tool and holder lie at any heading (mm)."""
        return max(self.envelope, self.tool.reach)

    @property
    def speed(self) -> int:
        """S word of the program while the oscillation or the spindle is on; 0 if there is none."""
        if not has_spindle(self.tool):
            return 0
        return round(self.spindle_speed) or self.tool.spindle

    @property
    def is_beam(self) -> bool:
        """Whether the tool is switched on only while it cuts, like a laser."""
        return kind_of(self.tool).switching == Switching.CUT

    def planner(self, line_type: LineType) -> Planner:
        """Return the key of the planner that makes operations from edges of a line type.

        Raises
        ------
        KeyError
            The tool of the station does not make the line type.
        """
        return kind_of(self.tool).planners[line_type]


@dataclass(frozen=True, slots=True)
class Machine(MachineProperties):
    """A flatbed machine that cuts, creases and grooves sheets of board, with its tool stations.

    Z is 0 on the top face of the cutting mat and positive upwards.
    """

    name: str
    x: Axis
    y: Axis
    z: Axis
    c: Axis
    stations: tuple[Station, ...]
    origin: tuple[float, float]  #: position of the lower left corner of a drawing (mm)
    controller: object = None  #: settings of the controller; their type depends on its language
    gantry: Gantry | None = None  #: carriages, if the machine has more than one
    zones: tuple[Zone, ...] = ()  #: keep-out zones on the table
    version: int = 0  #: version of a user's machine; 0 for a machine of the library or of a file
    #: letter of the words of the axis ``c`` in programs: A, B or C; empty if the machine has no
    #: such axis, and ``c`` is then an axis without limits that only tool paths have
    heading_letter: str = "C"
    #: least and greatest feed override that a person may choose while a program runs (%)
    feed_override: tuple[int, int] = (10, 200)
    arcs: str = "arcs"  #: ``chords`` if programs must not contain arcs, otherwise ``arcs``

    @property
    def carriages(self) -> tuple[Carriage, ...]:
        """The carriages of the machine, in the order of their numbers, from 1.

        A machine without a gantry has one carriage, which parks at the position of its Y that is
        nearest to 0.
        """
        if self.gantry:
            return self.gantry.carriages
        park = min(max(0.0, self.y.low), self.y.high)
        return (Carriage((self.x, self.y, self.z, self.c), f"XYZ{self.heading_letter}", park),)

    @property
    def axes(self) -> dict[str, Axis]:
        """All axes by the letters of their words in programs; those of the first
        carriage come first.
        """
        return {
            letter: axis
            for carriage in self.carriages
            for letter, axis in zip(carriage.letters, carriage.axes, strict=False)
        }

    @property
    def outputs(self) -> tuple[int, ...]:
        """Numbers of all digital outputs of the pistons and the tools, ascending."""
        pistons = {station.output for station in self.stations if station.output >= 0}
        tool_outputs = {output for station in self.stations for output in station.tool.outputs}
        return tuple(sorted(pistons | tool_outputs))

    @property
    def has_beam(self) -> bool:
        """Whether a station has a laser, which must be off in all moves between cuts."""
        return any(station.is_beam for station in self.stations)

    @property
    def offset_cuts(self) -> bool:
        """Whether cuts are offset from the drawn line by the radius of a tool.

        Corner types of a job apply only if this is True.
        """
        station = self.station_for(LineType.CUT)
        return station is not None and station.planner(LineType.CUT) == Planner.OFFSET_CUTS

    def station_for(self, line_type: LineType, caliper: float | None = None) -> Station | None:
        """Return the station whose tool makes a line type, or None if no station does.

        Parameters
        ----------
        line_type
            The line type.
        caliper
            Thickness of the board (mm).  If several tools of one kind make the line type, the tool
            that suits this thickness best is chosen; None chooses the first.
        """
        for kind in KINDS:
            held = [station for station in self.stations if type(station.tool) is kind.tool]
            if held and line_type in kind.planners:
                tools = [station.tool for station in held]
                return held[0 if caliper is None else kind.tool.best_for(tools, caliper)]
        return None

    def stations_like(self, station: Station) -> tuple[Station, ...]:
        """Return the stations with a tool of the same kind as that of a station, itself included.

        One of them can make what the other one makes.
        """
        kind = type(station.tool)
        return tuple(one for one in self.stations if type(one.tool) is kind)

    def for_board(self, board: Board) -> Machine:
        """Return the machine with its tools limited to the feeds and depths of a board.

        The knives that suit the board are the first, so that one of them makes the cuts.
        """
        limited = [_limit_to_board(station, board) for station in self.stations]
        stations = tuple(sorted(limited, key=lambda station: not suits(station.tool, board)))
        return self if stations == self.stations else replace(self, stations=stations)

    def at_feed(self, factor: float) -> Machine:
        """Return the machine with the feeds of its tools multiplied by a factor."""
        if factor == 1.0:
            return self
        stations = []
        for station in self.stations:
            tool: Any = station.tool
            stations.append(replace(station, tool=replace(tool, feed=factor * tool.feed)))
        return replace(self, stations=tuple(stations))

    @property
    def is_square(self) -> bool:
        """Whether Y is perpendicular to X, so that axes and sheet have the same coordinates."""
        return self.squareness == 90.0

    def to_axes(self, x: _Length, y: _Length) -> tuple[_Length, _Length]:
        """Return where the axes X and Y are (mm) when the head is at a point of the sheet.

        X lies along the x of the sheet, Y at the angle γ (``squareness``) to it::

            Y = y / sin γ        X = x - Y cos γ

        Offsets of stations are offsets of axes, and are added to the result.
        """
        if self.is_square:
            return x, y
        angle = math.radians(self.squareness)
        along = y / math.sin(angle)
        return x - along * math.cos(angle), along

    def to_sheet(self, x: _Length, y: _Length) -> tuple[_Length, _Length]:
        """Return the point of the sheet at which the head is for positions of X and Y (mm).

        It is the inverse of ``to_axes``.
        """
        if self.is_square:
            return x, y
        angle = math.radians(self.squareness)
        return x + y * math.cos(angle), y * math.sin(angle)

    def sheet_pose(
        self, axes: tuple[float, float, float, float], station: Station | None
    ) -> tuple[float, float, float, float]:
        """Return where the head is on the sheet, x, y, z (mm) and c (degrees), with a station.

        It is the position of the axes minus the offset of the station; nothing is subtracted if
        there is none.
        """
        x, y, z, c = axes
        if station is not None:
            x, y, z, c = x - station.x, y - station.y, z - station.z, c - station.c
        x, y = self.to_sheet(x, y)
        return x, y, z, c

    def over_warp(self, height: float) -> Machine:
        """Return the machine with clearances that are greater by the warp of a board (mm)."""
        if height == 0.0:
            return self
        return replace(
            self,
            clearance=self.clearance + height,
            turn_clearance=self.turn_clearance + height,
        )

    def carriage_of(self, station: Station) -> Carriage:
        """Return the carriage that carries a station."""
        return self.carriages[station.carriage - 1]

    def station(self, number: int) -> Station:
        """Return the station with the T number ``number``.

        Raises
        ------
        KeyError
            The machine has no station with the number.
        """
        for station in self.stations:
            if station.number == number:
                return station
        raise KeyError(number)


def suits(tool: Tool, board: Board) -> bool:
    """Return whether a tool is no knife, or a knife of the kind that suits a board."""
    if not isinstance(tool, Knife):
        return True
    blade = next((one.blade for one in board.limits if one.kind == kind_of(tool).name), "")
    return not blade or tool.oscillating == (blade == "oscillating")


def _limit_to_board(station: Station, board: Board) -> Station:
    """Return a station whose tool works within the limits of a board."""
    tool: Any = station.tool
    for limits in board.limits:
        if limits.kind == kind_of(tool).name:
            if 0.0 < limits.feed < tool.feed:
                tool = replace(tool, feed=limits.feed)
            if isinstance(tool, Cutter | Knife) and limits.step:
                tool = replace(tool, step=min(limits.step, tool.step or limits.step))
            if isinstance(tool, Knife) and limits.slow_radius > tool.slow_radius:
                tool = replace(tool, slow_radius=limits.slow_radius)
    return station if tool is station.tool else replace(station, tool=tool)
