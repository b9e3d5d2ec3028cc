"""The properties that the verifier expects of each kind of tool.

The values are derived from the tools' drawings and the machines' manuals, independently of the
stages that make programs.  The verifier shares with these stages only the dimensions in the tools'
records.  To add a kind of tool, add a row to ``_EXPECTED``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, Final

import numpy as np

from knifetip.model.machine import Machine, Station
from knifetip.model.tool import CreaseWheel, Cutter, Knife, Laser, Tool, VCutter
from knifetip.verification.columns import I64

#: Greatest turn of C in place in the board for tools without a swivel angle (degrees).
MAX_TURN: Final = 1.01
#: Tolerance of angles (degrees); C is printed to 0.0001°.
ANGLE_TOLERANCE: Final = 0.01
#: Length of the lead of a cutter without a lead setting, in radii.
_ENTRY_RATIO: Final = 1.5


class OperationKind(IntEnum):
    """Kind of operation of a tool: cut, half-cut, crease, groove or mill."""

    CUT = 0  #: knife, through the board
    HALF_CUT = 1  #: knife, part of the way
    CREASE = 2
    GROOVE = 3
    MILL = 4  #: router bit or laser, which removes a disc, through the board

    @property
    def tool(self) -> str:
        """Return the word in ``english.NAMES`` for the tool that makes this operation.

        Messages contain the name of the tool that has this key.
        """
        return ("knife", "knife", "wheel", "v-cutter", "cutter")[self]


@dataclass(frozen=True, slots=True)
class Disc:
    """The disc of board that a rotating cutter or a laser beam removes."""

    radius: float  #: mm
    step: float  #: deepest cut in one pass (mm); 0 if one pass cuts through the board
    entry_length: float  #: longest path from the entry point to a contour (mm)


@dataclass(frozen=True, slots=True)
class Beam:
    """Properties of a laser beam, which cuts wherever it is on, at any height of the head."""

    focus: float  #: height of the focus above the board's top face (mm)
    pierce: float  #: dwell at the point where it is switched on (s)


@dataclass(frozen=True, slots=True)
class ExpectedTool:
    """Properties of a tool that the verifier checks a program against."""

    through_kind: OperationKind  #: operation at a depth through the board
    partial_kind: OperationKind  #: operation at a smaller depth
    ahead: float = 0.0  #: distance from the head's axis to the tip, in the direction of C (mm)
    right: float = 0.0  #: distance from the head's axis to the tip, to the right of C (mm)
    slope: float = 0.0  #: travel to the right per mm that the tip rises
    circles_tip: bool = False  #: the head moves round the resting tip while C turns
    trails: bool = False  #: the tip is dragged behind the axis, and nothing else turns the tool
    swivel: float = MAX_TURN  #: greatest turn of C in place in the board (degrees)
    max_turn: float = 180.0  #: greatest turn of C that is ever needed (degrees)
    follows_path: bool = True  #: C follows the direction of the path
    slow_radius: float = 0.0  #: mm, radius of a curve below which the feed is lower in proportion
    speed: float = 1.0  #: S word of M3, unless the station has its own
    needs_spindle: bool = False  #: the spindle is on while the tool cuts; if False, it is off
    stopped_code: str = ""  #: code of the message if M3 is not in force
    min_dwell: float = 0.0  #: dwell after switching, if longer than the machine's (s)
    disc: Disc | None = None
    beam: Beam | None = None
    outputs: tuple[int, ...] = ()  #: outputs on while it cuts, besides its station's

    def through_depth(self, caliper: float, into_mat: float) -> float:
        """Return the depth of the tip below the board's top face in a cut through the board (mm).

        For a beam, return instead the depth of its focus below the top face; it is negative if the
        focus is above that face.

        Parameters
        ----------
        caliper : mm
            Thickness of the board.
        into_mat : mm
            Depth to which a through cut enters the mat below the board.
        """
        return -self.beam.focus if self.beam else caliper + into_mat


def _knife(tool: Knife) -> ExpectedTool:
    return ExpectedTool(
        OperationKind.CUT,
        OperationKind.HALF_CUT,
        ahead=-tool.trail,
        circles_tip=tool.trail > 0.0,
        trails=tool.free,
        swivel=360.0 if tool.free else tool.swivel + ANGLE_TOLERANCE,
        # The machine does not turn a free blade, so its turn has no speed.
        slow_radius=0.0 if tool.free else tool.slow_radius,
        needs_spindle=tool.oscillating,
        stopped_code="verify.knife-at-rest",
    )


def _crease_wheel(_tool: CreaseWheel) -> ExpectedTool:
    return ExpectedTool(OperationKind.CREASE, OperationKind.CREASE, max_turn=90.0)


def _v_cutter(tool: VCutter) -> ExpectedTool:
    return ExpectedTool(
        OperationKind.GROOVE,
        OperationKind.GROOVE,
        ahead=-tool.half_width,
        right=-tool.back,
        slope=math.tan(math.radians(tool.tilt)),
    )


def _cutter(tool: Cutter) -> ExpectedTool:
    return ExpectedTool(
        OperationKind.MILL,
        OperationKind.MILL,
        follows_path=False,
        speed=tool.speed,
        needs_spindle=tool.speed > 0.0,
        stopped_code="verify.cutter-at-rest",
        min_dwell=tool.spin_up,
        disc=Disc(tool.radius, tool.step, tool.lead or _ENTRY_RATIO * tool.radius),
    )


def _laser(tool: Laser) -> ExpectedTool:
    radius = 0.5 * tool.kerf
    return ExpectedTool(
        OperationKind.MILL,
        OperationKind.MILL,
        follows_path=False,
        speed=tool.power,
        needs_spindle=True,
        stopped_code="verify.laser-off",
        disc=Disc(radius, 0.0, tool.lead or _ENTRY_RATIO * radius),
        beam=Beam(tool.focus, tool.pierce),
        outputs=(tool.air,) if tool.air >= 0 else (),
    )


_EXPECTED: Final[Mapping[type[Tool], Callable[[Any], ExpectedTool]]] = {
    Knife: _knife,
    CreaseWheel: _crease_wheel,
    VCutter: _v_cutter,
    Cutter: _cutter,
    Laser: _laser,
}


def body_radius(tool: Tool) -> float:
    """Return the radius about the head's axis that a tool fills when C turns (mm)."""
    match tool:
        case Knife():
            return tool.trail + tool.blade_width
        case VCutter():
            return math.hypot(tool.back, tool.half_width)
        case CreaseWheel():
            return math.hypot(tool.radius, 0.5 * tool.width)
        case _:
            disc = expected_tool(tool).disc
            return disc.radius if disc else 0.0


def footprint_corners(tool: Tool, depth: float) -> tuple[tuple[float, float], ...]:
    """Return the corners of the area that a tool can occupy below the board's top face (mm).

    The area is seen from above.  Each corner is a pair: its distance ahead of the head's axis, in
    the direction of C, and its distance to the right of it.

    Parameters
    ----------
    tool
        The tool.  Which way a knife's blade points from its tip is unknown, so it counts twice.
    depth : mm
        Greatest depth of the tip below the top face.
    """
    match tool:
        case Knife():
            return ((-tool.trail - tool.blade_width, 0.0), (tool.blade_width - tool.trail, 0.0))
        case VCutter():
            # The blade leans to the right, where it leaves the board beside its cutting edge.
            lean = max(depth, 0.0) * math.tan(math.radians(tool.tilt))
            back, front = -tool.half_width, tool.half_width
            left, right = -tool.back, lean - tool.back
            return ((back, left), (front, left), (front, right), (back, right))
        case CreaseWheel():
            sunk = min(max(depth, 0.0), tool.radius)
            half, side = math.sqrt(sunk * (2.0 * tool.radius - sunk)), 0.5 * tool.width
        case _:
            disc = expected_tool(tool).disc
            half = side = disc.radius if disc else 0.0
    return ((-half, -side), (half, -side), (half, side), (-half, side))


def extra_outputs(machine: Machine) -> tuple[int, ...]:
    """Return the numbers of the outputs that tools need besides the outputs of their stations,
    ascending.

    Such an output is, for example, the air supply of a laser.
    """
    return tuple(
        sorted({one for station in machine.stations for one in expected_tool(station.tool).outputs})
    )


@dataclass(frozen=True, slots=True)
class Spindle:
    """The command that switches the oscillation, the spindle or the beam of a station on."""

    code: int  #: number of the M word: 3 or 4
    speed: float  #: S word
    needed: bool  #: it is on while the tool cuts; if False, it is off


def expected_spindle(station: Station) -> Spindle:
    """Return the command that switches the spindle of a station on, as its machine states it.

    A station without its own speed has that of its tool.
    """
    tool = expected_tool(station.tool)
    own = station.spindle_speed
    needed = tool.needs_spindle or (own > 0.0 and isinstance(station.tool, Cutter))
    return Spindle(4 if station.spindle == "M4" else 3, own if own > 0.0 else tool.speed, needed)


def carriage_columns(machine: Machine) -> I64:
    """Return the columns of ``Machine.axes`` with the X, Y, Z and C of each station's carriage.

    The shape is (stations + 1, 4), or (stations + 1, 3) if the machine has no C.  The last row,
    index -1, is that of the first carriage, for moves without a station.
    """
    letters = list(machine.axes)
    carriages = [machine.carriages[station.carriage - 1] for station in machine.stations]
    rows = [carriage.letters for carriage in (*carriages, machine.carriages[0])]
    return np.array([[letters.index(letter) for letter in row] for row in rows])


def travel_heights(machine: Machine) -> dict[str, float]:
    """Return the joint position of each Z axis at which all its stations are at travel height."""
    carriages, heights = machine.carriages, {}
    for letter in dict.fromkeys(carriage.letters[2] for carriage in carriages):
        own = [
            station.z
            for station in machine.stations
            if carriages[station.carriage - 1].letters[2] == letter
        ]
        highest = machine.travel_z + max(own, default=0.0)
        heights[letter] = min(highest, machine.axes[letter].high)
    return heights


def has_beam(machine: Machine) -> bool:
    """Return whether a station of the machine carries a laser."""
    return any(expected_tool(station.tool).beam is not None for station in machine.stations)


def expected_tool(tool: Tool) -> ExpectedTool:
    """Return the properties that the verifier expects of a tool."""
    return _EXPECTED[type(tool)](tool)
