"""segments: convert the moves of one station to segments that an MCX314 can interpolate.

Positions are rounded to pulses, not distances: the rest of a pulse is in the next segment, so that
rounding errors do not add up.  The chip interpolates at most three axes, and arcs only of two; an
arc along which C or Z moves is therefore cut into chords.

A segment joins the one before it if the chip need not stop between them.  It is then written while
that one is executed, which must therefore take at least as long as the writing.  Chords of a tight
curve that would be shorter, and short segments that cannot be merged with their neighbours, are
driven at a lower speed than the feed: the board makes the ramps between them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.errors import ProgramError
from knifetip.geometry import arc
from knifetip.geometry.chords import split_moves
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.languages.mcx314 import figures
from knifetip.languages.mcx314.wiring import Wiring
from knifetip.messages import Message
from knifetip.model.machine import Machine
from knifetip.model.tool import Knife, Tool
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.post.check import describe_row, edges_of_rows

#: Fraction of the tolerance by which merged lines may deviate from the path.
MERGE_FRACTION: Final = 0.4
#: Deviation of chords from their arc that is aimed at (mm).  C turns along a chord, but the chord
#: does not; the verifier takes longer chords for turns in the board.
CHORD_DEVIATION: Final = 0.001
#: Greatest turn of C along a chord (degrees), besides that of an arc with this deviation from it:
#: tools other than a knife, whose swivel angle applies, may not turn farther in the board.
CHORD_TURN: Final = 1.0
#: Curves of a smaller radius are driven slower if the chip needs it (mm).  Short pieces of other
#: curves are merged.
SLOWED_RADIUS: Final = 18.0
#: A chord lasts this many times as long as the writing of the next one takes: rounding to pulses.
LASTING: Final = 1.05
#: Motions that may join; all others begin and end at rest.
_JOINING: Final = (Motion.LEAD_IN, Motion.FEED, Motion.LEAD_OUT)
#: A smaller bulge is straight, and a smaller change of Z or C is none.
_NOTHING: Final = 1e-9


@dataclass(frozen=True, eq=False, slots=True)
class Segments:
    """n segments of one station, in pulses of the joints X, Y, Z and C."""

    target: I64  #: (n, 4) position after each segment
    way: I64  #: (n, 4) signed distances
    centre: I64  #: (n, 2) centre of each arc relative to its start
    side: I64  #: (n,) 1 for an arc counter-clockwise, -1 for clockwise, 0 for a line
    rapid: Bool  #: (n,)
    speed: I64  #: (n,) drive speed (pulses/s); 0 for rapids
    joined: Bool  #: (n,) begins without a stop after the segment before
    row: I32  #: (n,) row of the toolpath


@dataclass(frozen=True, eq=False, slots=True)
class _Pieces:
    """n straight pieces and arcs between n + 1 points, before they are segments."""

    pose: F64  #: (n + 1, 4) mm and degrees
    point: I64  #: (n + 1, 4) pulses
    bulge: F64  #: (n,)
    joined: Bool  #: (n,)
    row: I64  #: (n,) row of the toolpath
    least: F64  #: (n,) least duration (s): that of a chord which the feed would make too short

    def select(self, kept: I64, joined: Bool) -> _Pieces:
        """Return longer pieces, which end where the pieces ``kept`` end; pieces between them are
        merged.
        """
        ends = np.concatenate([[0], kept + 1])
        return _Pieces(
            self.pose[ends],
            self.point[ends],
            self.bulge[kept],
            joined[kept],
            self.row[kept],
            self.least[kept],
        )


def encode(
    toolpath: Toolpath,
    first: int,
    last: int,
    datum: F64,
    machine: Machine,
    wiring: Wiring,
    tolerance: float,
) -> Segments:
    """Return the segments of rows ``first`` to ``last`` - 1 of a toolpath, which have one station.

    Parameters
    ----------
    datum : (4,)
        Offset of the station, which is added to the poses (mm and degrees).
    tolerance : float, mm
        Greatest deviation of the path from that of the toolpath.  The rounding of points to pulses
        comes in addition.

    Raises
    ------
    ProgramError
        A move needs four axes at once, or more pulses or another speed than the chip has.
    """
    deviation = MERGE_FRACTION * tolerance
    pieces = _split(toolpath, first, last, datum, machine, wiring, deviation)
    pieces = _drop_empty(pieces, toolpath)
    seconds = _durations(pieces, toolpath, machine, wiring)
    kept, slowed = _merge(pieces, seconds, toolpath, wiring, deviation)
    pieces.least[slowed] = LASTING * wiring.refill
    pieces = pieces.select(kept, _joined_after(pieces.joined, kept))
    seconds = _durations(pieces, toolpath, machine, wiring)
    return _segments(pieces, seconds, toolpath, wiring)


def _split(
    toolpath: Toolpath,
    first: int,
    last: int,
    datum: F64,
    machine: Machine,
    wiring: Wiring,
    deviation: float,
) -> _Pieces:
    """Return the pieces of rows of a toolpath, with chords for arcs along which C or Z move."""
    pose = toolpath.pose[first : last + 1] + datum
    bulge, motion = toolpath.bulge[first:last], toolpath.motion[first:last]
    bulge = np.where(np.abs(bulge) > _NOTHING, bulge, 0.0)
    turning = (np.abs(np.diff(pose[:, 2:], axis=0)) > _NOTHING).any(axis=1)
    flattened = (bulge != 0.0) & (turning | (wiring.pulses[0] != wiring.pulses[1]))
    bow = np.abs(bulge) * np.hypot(*np.diff(pose[:, :2], axis=0).T) / 2.0
    count = np.ceil(np.sqrt(bow / min(CHORD_DEVIATION, deviation)))
    # Not so many that they must be merged again, unless the tolerance needs them.
    lasting = np.floor(_spans(toolpath, first, last, machine) / (LASTING * wiring.refill))
    most = _chord_turn(machine.station(int(toolpath.tool[first])).tool)
    needed = np.maximum(np.ceil(np.sqrt(bow / deviation)), _least_chords(pose, bulge, most))
    count = np.maximum(np.minimum(count, lasting), needed)
    count = np.where(flattened, count, 1.0).astype(np.int64).clip(1)
    slowed = flattened & (count > lasting)
    slowed &= arc.radius(pose[:-1, :2], pose[1:, :2], bulge) < SLOWED_RADIUS
    joins = np.isin(motion, _JOINING)
    follows = np.zeros(last - first, np.bool_)
    follows[1:] = joins[1:] & joins[:-1] & (_turns(pose, bulge)[1:] <= wiring.corner)
    pose, row = split_moves(pose, bulge, count)
    inside = np.concatenate([[False], np.diff(row) == 0])
    point = np.rint(pose * wiring.pulses).astype(np.int64)
    straight = np.where(flattened, 0.0, bulge)[row]
    least = np.where(slowed, LASTING * wiring.refill, 0.0)[row]
    return _Pieces(pose, point, straight, inside | follows[row], row + first, least)


def _chord_turn(tool: Tool) -> float:
    """Return the greatest turn of a tool in place in the board (degrees)."""
    return tool.lift_angle if isinstance(tool, Knife) else CHORD_TURN


def _least_chords(pose: F64, bulge: F64, most: float) -> F64:
    """Return the least number of chords of n arcs along which C does not turn too far, (n,).

    Along one of k chords of an arc of length l and sweep s, C turns by s / k.  An arc whose sagitta
    is ``CHORD_DEVIATION`` turns by 8 ``CHORD_DEVIATION`` / (l / k) over the same chord.  So
    s / k = t + 8 d k / l, with t for ``most`` (degrees) and d for ``CHORD_DEVIATION``.
    """
    length = arc.length(pose[:-1, :2], pose[1:, :2], bulge)
    turn, sweep = np.radians(most), np.abs(arc.sweep(bulge))
    slope = 8.0 * CHORD_DEVIATION / np.maximum(length, 1e-9)
    root = np.sqrt(turn**2 + 4.0 * slope * sweep)
    result: F64 = np.ceil((root - turn) / (2.0 * slope))
    return result


def _spans(toolpath: Toolpath, first: int, last: int, machine: Machine) -> F64:
    """Return the time of each of some rows at its feed, (n,) s; 0 for rapids."""
    pose, bulge = toolpath.pose[first : last + 1], toolpath.bulge[first:last]
    length = arc.length(pose[:-1, :2], pose[1:, :2], bulge)
    feed = toolpath.feed[first:last] / 60.0
    seconds = np.divide(length, feed, out=np.zeros(len(length)), where=feed > 0.0)
    result: F64 = np.maximum(seconds, np.abs(np.diff(pose[:, 3])) / machine.c.velocity)
    return result


def _turns(pose: F64, bulge: F64) -> F64:
    """Return the change of direction in XY at the start of each of n moves, (n,) degrees."""
    leaving, arriving = arc.tangents(pose[:-1, :2], pose[1:, :2], bulge)
    turns = np.zeros(len(bulge))
    cross = arriving[:-1, 0] * leaving[1:, 1] - arriving[:-1, 1] * leaving[1:, 0]
    turns[1:] = np.degrees(np.abs(np.arctan2(cross, (arriving[:-1] * leaving[1:]).sum(axis=1))))
    return turns


def _drop_empty(pieces: _Pieces, toolpath: Toolpath) -> _Pieces:
    """Return the pieces that have pulses, and all rapids.

    A pass that is shorter than a pulse has none: the tool is not lowered for it.
    """
    moves = (np.diff(pieces.point, axis=0) != 0).any(axis=1)
    motion = toolpath.motion[pieces.row]
    moves |= motion == Motion.RAPID
    kept = np.flatnonzero(moves)
    down, up = kept[:-1], kept[1:]
    idle = (motion[down] == Motion.PLUNGE) & (motion[up] == Motion.LIFT) & (up - down > 1)
    idle &= (pieces.point[down] == pieces.point[up + 1]).all(axis=1)
    kept = np.delete(kept, np.flatnonzero(idle)[:, None] + (0, 1))
    # The path of a dropped piece runs through the point before it.
    points = np.concatenate([pieces.point[:1], pieces.point[kept + 1]])
    poses = np.concatenate([pieces.pose[:1], pieces.pose[kept + 1]])
    joined = _joined_after(pieces.joined, kept)
    return _Pieces(
        poses, points, pieces.bulge[kept], joined[kept], pieces.row[kept], pieces.least[kept]
    )


def _joined_after(joined: Bool, kept: I64) -> Bool:
    """Return the mask of n pieces that join the last kept piece before them, (n,)."""
    stops = np.cumsum(~joined)
    result = joined.copy()
    if len(kept):
        result[kept[0]] = False
        result[kept[1:]] = stops[kept[1:]] == stops[kept[:-1]]
    return result


def _durations(pieces: _Pieces, toolpath: Toolpath, machine: Machine, wiring: Wiring) -> F64:
    """Return the duration of each piece at its feed, (n,) s; infinite for rapids.

    It is computed from the pulses.  C may need more time than the feed permits, and so may the
    writing of the next piece.
    """
    way = np.diff(pieces.point, axis=0) / wiring.pulses
    flat = np.hypot(way[:, 0], way[:, 1])
    arcs = np.flatnonzero(pieces.bulge)
    if len(arcs):
        ends = pieces.pose[:, :2]
        flat[arcs] = arc.length(ends[arcs], ends[arcs + 1], pieces.bulge[arcs])
    motion, feed = toolpath.motion[pieces.row], toolpath.feed[pieces.row] / 60.0
    turn = np.abs(way[:, 3])
    with np.errstate(divide="ignore", invalid="ignore"):
        seconds = np.where(motion == Motion.SWIVEL, turn, np.hypot(flat, way[:, 2])) / feed
    result: F64 = np.maximum(np.maximum(seconds, turn / machine.c.velocity), pieces.least)
    result[motion == Motion.RAPID] = np.inf
    return result


def _merge(
    pieces: _Pieces, seconds: F64, toolpath: Toolpath, wiring: Wiring, deviation: float
) -> tuple[I64, I64]:
    """Return the pieces at whose ends segments end, and those of them that must be slower than
    their feed, so that each lasts until the next is written.

    A line that is too short is merged with the lines that join it, if the line that replaces them
    deviates from their ends by at most ``deviation`` (mm, degrees); else it is slower.
    """
    count = len(seconds)
    short = np.append(pieces.joined[1:], False) & (seconds < wiring.refill)
    if not short.any():
        return np.arange(count), np.zeros(0, np.int64)
    kept: list[int] = []
    slowed: list[int] = []
    start, at = 0, 0
    while at < count:
        spent = float(seconds[at])
        while spent < wiring.refill and at + 1 < count and pieces.joined[at + 1]:
            straight = not (pieces.bulge[at] or pieces.bulge[at + 1])
            same = toolpath.feed[pieces.row[at]] == toolpath.feed[pieces.row[at + 1]]
            if not (straight and same and _deviation(pieces.pose[start : at + 3]) <= deviation):
                slowed.append(at)
                break
            at += 1
            spent += float(seconds[at])
        kept.append(at)
        at += 1
        start = at
    return np.array(kept), np.array(slowed, np.int64)


def _deviation(poses: F64) -> float:
    """Return the greatest distance of poses from the line between the first and the last one."""
    way = poses[-1] - poses[0]
    square = float(way @ way)
    column = poses[1:-1] - poses[0]
    along = np.clip(column @ way / square, 0.0, 1.0) if square else np.zeros(len(column))
    return float(np.linalg.norm(column - along[:, None] * way, axis=1).max())


def _segments(pieces: _Pieces, seconds: F64, toolpath: Toolpath, wiring: Wiring) -> Segments:
    """Return the segments of pieces; check that the chip can execute each of them."""
    way = np.diff(pieces.point, axis=0)
    rapid = toolpath.motion[pieces.row] == Motion.RAPID
    side, centre = _arcs(pieces, way, wiring)
    longest = np.abs(way).max(axis=1, initial=0)
    length = longest.astype(np.float64)
    arcs = np.flatnonzero(side)
    if len(arcs):
        ends = pieces.pose[:, :2]
        span = arc.length(ends[arcs], ends[arcs + 1], pieces.bulge[arcs])
        length[arcs] = span * wiring.pulses[0]
        longest[arcs] = np.maximum(longest[arcs], np.abs(centre[arcs]).max(axis=1))
    rate = length / seconds
    speed = np.rint(rate).astype(np.int64)
    fastest = figures.FASTEST * wiring.multiple
    _refuse(longest > figures.LARGEST, "mcx314.too-far", pieces, toolpath, pulses=longest)
    axes = (way != 0).sum(axis=1)
    _refuse(~rapid & (axes > 3), "mcx314.four-axes", pieces, toolpath)
    slow = ~rapid & (speed < wiring.multiple)
    wrong = np.flatnonzero(slow | (speed > fastest))
    if len(wrong):
        raise _refusal(
            "mcx314.speed",
            toolpath,
            pieces.row[wrong],
            rate=float(rate[wrong[0]]),
            slowest=wiring.multiple,
            fastest=fastest,
        )
    return Segments(
        pieces.point[1:],
        way,
        centre,
        side,
        rapid,
        speed,
        pieces.joined,
        pieces.row.astype(np.int32),
    )


def _arcs(pieces: _Pieces, way: I64, wiring: Wiring) -> tuple[I64, I64]:
    """Return the side of each arc, (n,), and its centre relative to its start, (n, 2) pulses.

    An arc of a few pulses becomes a line: its rounded ends are not on one circle.
    """
    side = np.sign(pieces.bulge).astype(np.int64)
    centre = np.zeros((len(side), 2), np.int64)
    arcs = np.flatnonzero(side)
    if len(arcs) == 0:
        return side, centre
    ends = pieces.pose[:, :2]
    middle = arc.centre(ends[arcs], ends[arcs + 1], pieces.bulge[arcs]) * wiring.pulses[0]
    centre[arcs] = np.rint(middle).astype(np.int64) - pieces.point[arcs, :2]
    radius, other = np.hypot(*centre[arcs].T), np.hypot(*(way[arcs, :2] - centre[arcs]).T)
    tiny = (radius < 1.0) | (np.abs(radius - other) > 1.0)
    tiny |= np.abs(way[arcs, :2]).max(axis=1) <= 1
    side[arcs[tiny]] = 0
    centre[arcs[tiny]] = 0
    return side, centre


def _refuse(
    wrong: Bool, code: str, pieces: _Pieces, toolpath: Toolpath, pulses: I64 | None = None
) -> None:
    """Raise ``ProgramError`` for the first piece in the mask ``wrong``, if there is one."""
    for at in np.flatnonzero(wrong)[:1]:
        figures_of = {}
        if pulses is not None:
            figures_of = {"pulses": int(pulses[at]), "limit": figures.LARGEST}
        raise _refusal(code, toolpath, pieces.row[wrong], **figures_of)


def _refusal(code: str, toolpath: Toolpath, rows: I64, **measures: float) -> ProgramError:
    """Return the error for rows of a toolpath that the chip cannot execute.

    The first of them is that which the measures describe.
    """
    message = Message(code, place=describe_row(toolpath, int(rows[0])), **measures)
    return ProgramError(message, at_edges=edges_of_rows(toolpath, rows))
