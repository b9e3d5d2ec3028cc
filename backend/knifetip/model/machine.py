"""Records of a machine: its axes, its tool stations and its settings."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.model.dieline import LineType
from knifetip.model.tool import KINDS, Planner, Switching, Tool, kind_of


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
class Machine:
    """A flatbed machine that cuts, creases and grooves sheets of board, with its tool stations.

    Z is 0 on the top face of the cutting mat and positive upwards.
    """

    name: str
    title: str
    width: float  #: width of the table along X (mm)
    height: float  #: height of the table along Y (mm)
    x: Axis
    y: Axis
    z: Axis
    c: Axis
    stations: tuple[Station, ...]
    dialect: str  #: name of the controller language
    origin: tuple[float, float]  #: position of the lower left corner of a drawing (mm)
    travel_z: float  #: height of the tip above the mat in air moves (mm)
    clearance: float  #: height of the tip above the board where plunging begins (mm)
    into_mat: float  #: depth of a through cut in the mat (mm)
    settle: float  #: dwell after a piston or the oscillation is switched (s)
    feed: str = "manual"  #: loading of sheets: ``manual`` or ``automatic``
    controller: object = None  #: settings of the controller; their type depends on its language

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
