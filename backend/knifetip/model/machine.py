"""Machine: its axes, and its tool stations with their datums."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.model.dieline import LineType
from knifetip.model.tool import KINDS, Planner, Switching, Tool, kind_of


@dataclass(frozen=True, slots=True)
class Axis:
    """One axis: its travel and its limits of speed (mm or degrees, and seconds)."""

    low: float  #: least joint position
    high: float  #: greatest joint position
    velocity: float  #: per second
    acceleration: float  #: per second squared


@dataclass(frozen=True, slots=True)
class Station:
    """A place on the head that holds one tool.

    Joint position = programmed position + datum.
    """

    number: int  #: the T word
    name: str
    tool: Tool
    x: float  #: datum (mm)
    y: float  #: datum (mm)
    z: float  #: datum (mm)
    c: float  #: mounting angle (degrees)
    output: int  #: digital output of the piston that lowers the station; -1 for none

    @property
    def beams(self) -> bool:
        """Whether its tool is switched on only while it cuts, like a laser."""
        return kind_of(self.tool).switching == Switching.CUT

    def planner(self, line_type: LineType) -> Planner:
        """Return the planner for a line type that its tool makes."""
        return kind_of(self.tool).planners[line_type]


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
    origin: tuple[float, float]  #: position of a drawing's lower left corner (mm)
    travel_z: float  #: height of the tip above the mat in air moves (mm)
    clearance: float  #: height of the tip above the board where plunging begins (mm)
    into_mat: float  #: depth of a through cut in the mat (mm)
    settle: float  #: dwell after a piston or the oscillation is switched (s)
    feed: str = "manual"  #: loading of sheets: ``manual`` or ``automatic``
    controller: object = None  #: settings of the controller; their type depends on its language

    @property
    def outputs(self) -> tuple[int, ...]:
        """All digital outputs of the pistons and of the tools, ascending."""
        pistons = {station.output for station in self.stations if station.output >= 0}
        others = {output for station in self.stations for output in station.tool.outputs}
        return tuple(sorted(pistons | others))

    @property
    def has_beam(self) -> bool:
        """Whether a station holds a beam, which must be off in all air moves."""
        return any(station.beams for station in self.stations)

    @property
    def offset_cuts(self) -> bool:
        """Whether cuts are offset from their line, so that corner types apply."""
        station = self.station_for(LineType.CUT)
        return station is not None and station.planner(LineType.CUT) == Planner.OFFSET_CUTS

    def station_for(self, line_type: LineType, caliper: float | None = None) -> Station | None:
        """Return the station for a line type, None if there is none.

        Of several stations with one kind of tool, the tool that suits the board is chosen if the
        board's caliper (mm) is given, and otherwise the first.
        """
        for kind in KINDS:
            held = [station for station in self.stations if type(station.tool) is kind.tool]
            if held and line_type in kind.planners:
                tools = [station.tool for station in held]
                return held[0 if caliper is None else kind.tool.best_for(tools, caliper)]
        return None

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
