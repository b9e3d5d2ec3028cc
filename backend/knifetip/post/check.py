"""check: refuse toolpaths with rows that no controller language can express as a program."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from typing import Final

import numpy as np

from knifetip.errors import ProgramError
from knifetip.geometry.columns import I32, I64, Bool
from knifetip.messages import Message
from knifetip.model.machine import Machine, Station
from knifetip.model.toolpath import Motion, Toolpath

#: Greatest coordinate of a pose (mm or degrees); no table is larger.
MAX_COORDINATE: Final = 1e6
#: Least feed (mm/min).
MIN_FEED: Final = 1e-3
#: Greatest feed (mm/min, degrees/min).
MAX_FEED: Final = 1e8

#: Codes of the names of motions.
_MOTIONS: Final[Mapping[int, str]] = {
    Motion.RAPID: "motion.rapid",
    Motion.PLUNGE: "motion.plunge",
    Motion.LEAD_IN: "motion.lead-in",
    Motion.FEED: "motion.feed",
    Motion.SWIVEL: "motion.swivel",
    Motion.LEAD_OUT: "motion.lead-out",
    Motion.LIFT: "motion.lift",
}


def describe_row(toolpath: Toolpath, row: int) -> Message:
    """Return a message that names a row of a toolpath, the row's motion and, if any, its edge."""
    edge = int(toolpath.source[row])
    number = int(toolpath.motion[row])
    code = _MOTIONS.get(number)
    motion = Message(code) if code else Message("motion.unknown", number=number)
    if edge < 0:
        return Message("toolpath.row", row=row, motion=motion)
    return Message("toolpath.row-of-edge", row=row, motion=motion, edge=edge)


def edges_of_rows(toolpath: Toolpath, rows: Bool | I32 | I64) -> I32:
    """Return the edges that rows of a toolpath make, each once, ascending."""
    source = toolpath.source[rows]
    edges: I32 = np.unique(source[source >= 0])
    return edges


def _describe_move(toolpath: Toolpath, row: int) -> Message:
    """Return a message with the end poses, the bulge and the feed of a row of a toolpath.

    The numbers are texts, because JSON has no number for NaN and infinity.
    """
    start, end = ([f"{value:g}" for value in pose] for pose in toolpath.pose[row : row + 2])
    bulge, feed = f"{toolpath.bulge[row]:g}", f"{toolpath.feed[row]:g}"
    return Message("toolpath.move", start=start, end=end, bulge=bulge, feed=feed)


def check_toolpath(toolpath: Toolpath) -> None:
    """Raise an error for the first row of a toolpath that cannot be written as a program.

    Raises
    ------
    ProgramError
        The toolpath is empty; or a row has a number that is not finite or out of range, an unknown
        motion, a feed that is too fast or (except in a rapid) missing, an arc in a rapid, or an arc
        of more than half a turn.
    """
    if len(toolpath) == 0:
        raise ProgramError("toolpath.empty")

    def refuse(wrong: Bool, code: str, **measures: float) -> None:
        """Raise ``ProgramError`` for the first row in the mask ``wrong``; do nothing if the mask is
        empty.

        ``code`` is the code of the error message.
        """
        if wrong.any():
            row = int(np.argmax(wrong))
            place, move = describe_row(toolpath, row), _describe_move(toolpath, row)
            message = Message(code, place=place, move=move, **measures)
            raise ProgramError(message, at_edges=edges_of_rows(toolpath, wrong))

    # By column, since operations on rows of four numbers are slow.
    numbers: Bool = reduce(np.logical_and, np.isfinite(toolpath.pose).T)
    finite = numbers[1:] & numbers[:-1] & np.isfinite(toolpath.bulge) & np.isfinite(toolpath.feed)
    refuse(~finite, "toolpath.not-finite")
    far: Bool = reduce(np.logical_or, (np.abs(toolpath.pose) > MAX_COORDINATE).T)
    refuse(far[1:] | far[:-1], "toolpath.too-far", limit=MAX_COORDINATE)
    rapid = toolpath.motion == Motion.RAPID
    refuse(toolpath.motion > max(Motion), "toolpath.unknown-motion")
    refuse(~rapid & (toolpath.feed < MIN_FEED), "toolpath.no-feed")
    refuse(toolpath.feed > MAX_FEED, "toolpath.feed-too-fast")
    refuse(rapid & (np.abs(toolpath.bulge) > 0), "toolpath.rapid-arc")
    refuse(np.abs(toolpath.bulge) > 1.0 + 1e-6, "toolpath.arc-too-long")


def station_at(toolpath: Toolpath, machine: Machine, first: int) -> Station:
    """Return the station whose moves begin at row ``first`` of a toolpath.

    Raises
    ------
    ProgramError
        The machine has no such station, its tool lacks a spindle speed, or the row is not a rapid.
    """
    number = int(toolpath.tool[first])
    try:
        station = machine.station(number)
    except KeyError:
        numbers = [str(station.number) for station in machine.stations]
        raise ProgramError(
            "toolpath.unknown-station",
            place=describe_row(toolpath, first),
            station=number,
            machine=machine.name,
            known=numbers,
        ) from None
    if (reason := station.tool.spindle_missing) and not station.speed:
        raise ProgramError(
            "tool.cannot-work",
            station=number,
            name=station.name,
            machine=machine.name,
            reason=reason,
        )
    if toolpath.motion[first] != Motion.RAPID:
        raise ProgramError(
            "toolpath.no-approach", place=describe_row(toolpath, first), station=number
        )
    return station
