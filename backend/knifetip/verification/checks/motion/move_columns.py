"""The columns of moves and tools that the kernels of the motion checks read."""

from __future__ import annotations

import math
from typing import Final, NamedTuple

import numpy as np

from knifetip.kernels import F64_1, F64_2, I32_1, U8_1, Bool_1, inline_kernel
from knifetip.model.machine import Machine
from knifetip.verification.kinematics import TipPoses
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import ExpectedTool, expected_tool

#: Greatest error of the position of a free blade's tip by printed digits and by its chords (mm).
_POSITION_ERROR: Final = 1e-3


class MoveColumns(NamedTuple):
    """Columns of n moves; see ``Moves`` and, for the last three, ``TipPoses``."""

    start: F64_2  #: (n, 4)
    end: F64_2  #: (n, 4)
    centre: F64_2  #: (n, 2)
    sweep: F64_1
    code: U8_1
    feed: F64_1
    inverse: Bool_1
    station: I32_1
    tip_start: F64_2  #: (n, 4)
    tip_end: F64_2  #: (n, 4)
    inside: Bool_1


class ToolColumns(NamedTuple):
    """Properties of the tools of s stations, (s + 1,) each.

    The last row, index -1, is for moves without a station; its tool has no feed.
    """

    feed: F64_1  #: mm/min at constant height, NaN for no tool
    plunge: F64_1  #: mm/min of moves that change the height
    turn_velocity: F64_1  #: degrees/s, greatest velocity of C
    beam: Bool_1  #: the tool is a laser
    circles_tip: Bool_1  #: the head moves round the resting tip while C turns
    slope: F64_1  #: travel to the right per mm that the tip rises
    swivel: F64_1  #: degrees, greatest turn in place in the board
    max_turn: F64_1  #: degrees, greatest turn that is ever needed
    follows_path: Bool_1  #: C follows the direction of the path
    slow_radius: F64_1  #: mm, radius of a curve below which the feed is lower in proportion
    other_carriage: Bool_1  #: the station is not on the first carriage


def move_columns(moves: Moves, tip: TipPoses) -> MoveColumns:
    """Return the columns of the moves of a program and of the poses of the tip."""
    return MoveColumns(
        moves.start, moves.end, moves.centre, moves.sweep, moves.code, moves.feed, moves.inverse,
        moves.station, tip.start, tip.end, tip.inside,
    )  # fmt: skip


def tool_columns(machine: Machine, resolution: float) -> ToolColumns:
    """Return the properties of the tools of a machine's stations.

    ``resolution`` is the unit of the program's coordinates (mm), whose rounding turns free blades.
    """
    stations = machine.stations
    tools = [expected_tool(station.tool) for station in stations]
    rounding = [_turn_error(tool, resolution) for tool in tools]
    carriages = [machine.carriages[station.carriage - 1] for station in stations]
    return ToolColumns(
        feed=np.array([*(station.tool.feed for station in stations), math.nan]),
        plunge=np.array([*(station.tool.plunge for station in stations), math.nan]),
        turn_velocity=np.array([*(one.axes[3].velocity for one in carriages), machine.c.velocity]),
        beam=np.array([*(tool.beam is not None for tool in tools), False]),
        circles_tip=np.array([*(tool.circles_tip for tool in tools), False]),
        slope=np.array([*(tool.slope for tool in tools), 0.0]),
        swivel=np.array([*(tool.swivel for tool in tools), 0.0]),
        max_turn=np.array([*np.add([tool.max_turn for tool in tools], rounding), 0.0]),
        follows_path=np.array([*(tool.follows_path for tool in tools), False]),
        slow_radius=np.array([*(tool.slow_radius for tool in tools), 0.0]),
        other_carriage=np.array([*(not one.is_first for one in carriages), False]),
    )


def _turn_error(tool: ExpectedTool, resolution: float) -> float:
    """Return the greatest turn of a free blade that rounding can cause (degrees); 0 for other
    tools.  Coordinates are rounded to ``resolution`` (mm).
    """
    return math.degrees((resolution + _POSITION_ERROR) / -tool.ahead) if tool.trails else 0.0


@inline_kernel
def rests_tip(moves: MoveColumns, tools: ToolColumns, row: int) -> bool:
    """Return whether the tip does not move along X and Y during a move.

    The head of a drag knife may move round its resting tip in such a move.
    """
    distance = math.hypot(
        moves.tip_end[row, 0] - moves.tip_start[row, 0],
        moves.tip_end[row, 1] - moves.tip_start[row, 1],
    )
    return distance < 1e-3 and (moves.sweep[row] == 0.0 or tools.circles_tip[moves.station[row]])
