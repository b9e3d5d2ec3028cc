"""tracks: create the moves of tracks: plunge, feed, swivel and lift.

A track is a path that a tool follows without lifting.  The compensation of each kind of tool
computes the poses of the head at both ends of every segment of a track; this module creates the
moves of all segments at once.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields, replace
from typing import Any, NamedTuple

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.azimuth import azimuth, turn_angle
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.path import Paths
from knifetip.kernels import F64_1, F64_2, I32_1, U8_1, Bool_1, kernel
from knifetip.model.operation import Operation
from knifetip.model.toolpath import Motion, Toolpath

#: Smallest change of heading (degrees) or depth (mm) that gets a move of its own.
_MIN_CHANGE = 1e-7
# Kernels take plain numbers.
_RAPID, _PLUNGE, _SWIVEL = int(Motion.RAPID), int(Motion.PLUNGE), int(Motion.SWIVEL)
_LIFT, _FEED = int(Motion.LIFT), int(Motion.FEED)


def end_azimuths(paths: Paths) -> tuple[F64, F64]:
    """Return the azimuth of travel at the start and at the end of each segment, (n,) degrees."""
    ahead, last = arc.tangents(paths.start, paths.end, paths.bulge)
    begin = azimuth(ahead)
    return begin, azimuth(last) if paths.bulge.any() else begin


def headings(paths: Paths) -> tuple[F64, F64]:
    """Return the heading C of the tool at the start and end of every segment, (n,) degrees each.

    The first heading of a path is its azimuth in [0, 360).  Along an arc C turns with the tangent,
    at a corner by the smaller angle.  Headings of a path have no jumps of 360°.
    """
    begin, arriving = end_azimuths(paths)
    swept = np.degrees(arc.sweep(paths.bulge))
    corner = np.zeros(len(begin))
    corner[1:] = turn_angle(arriving[:-1], begin[1:])
    first = paths.first[:-1]
    corner[first] = 0.0
    gained = np.cumsum(corner + swept) - swept
    start: F64 = gained + (begin[first] - gained[first])[paths.path_of]
    return start, start + swept


def at_height(pose: F64, height: float) -> F64:
    """Return a copy of n poses of the head with Z set to ``height`` (mm).

    ``pose`` (n, 4) contains X, Y, Z (mm) and C (degrees) of each pose.
    """
    above = pose.copy()
    above[:, 2] = height
    return above


def empty_toolpath() -> Toolpath:
    """Return a toolpath without moves."""
    none, rows, codes = np.zeros(0), np.zeros(0, np.int32), np.zeros(0, np.uint8)
    return Toolpath(np.zeros((1, 4)), none, codes, none, rows, codes, rows)


@dataclass(frozen=True, eq=False, slots=True)
class Strokes:
    """n segments of the tip's path in machining order, with the poses of the head at both ends.

    A segment with equal ends is a press: the tool plunges and lifts without travel.
    """

    start: F64  #: (n, 4) pose of the head at the start: x, y, z (mm), c (degrees)
    end: F64  #: (n, 4) pose of the head at the end
    bulge: F64  #: (n,) tan(sweep / 4) of the head's path
    above_start: F64  #: (n, 4) pose where a plunge starts; unused without ``down``
    above_end: F64  #: (n, 4) pose where a lift ends; unused without ``up``
    down: Bool  #: (n,) whether the tool plunges before the segment
    up: Bool  #: (n,) whether the tool lifts after the segment
    track: I32  #: (n,) number of the track of each segment, ascending
    source: I32  #: (n,) row of the edge in the Dieline
    #: (n,) bulge of the head's path around the tip where C turns in the board; 0 by default
    swing: F64 = field(default_factory=lambda: np.zeros(0))
    #: (n,) Motion of each segment: FEED (by default), LEAD_IN or LEAD_OUT
    motion: U8 = field(default_factory=lambda: np.zeros(0, np.uint8))
    #: (n,) part of the feed of the operation with which the tool moves along each segment; 1 by
    #: default
    slowing: F64 = field(default_factory=lambda: np.zeros(0))
    drags: bool = False  #: the swing drags the tool round at its feed; no axis turns it
    #: (n,) height to which a tool that drags is lifted where it turns before the segment, if it is
    #: above the segment (mm); -inf by default
    swivel_z: F64 = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        count = len(self.bulge)
        if len(self.swing) != count:
            object.__setattr__(self, "swing", np.zeros(count))
        if len(self.slowing) != count:
            object.__setattr__(self, "slowing", np.ones(count))
        if len(self.swivel_z) != count:
            object.__setattr__(self, "swivel_z", np.full(count, -math.inf))
        if len(self.motion) != count:
            object.__setattr__(self, "motion", np.full(count, Motion.FEED, np.uint8))

    def merged_with(self, other: Strokes) -> Strokes:
        """Return these strokes and the strokes of ``other`` in one record, ordered by track."""
        if len(other.track) == 0:
            return self
        order = np.argsort(np.concatenate([self.track, other.track]), kind="stable")
        pairs = {
            column.name: (getattr(self, column.name), getattr(other, column.name))
            for column in fields(self)
        }
        columns: dict[str, Any] = {
            name: np.concatenate(pair)[order]
            for name, pair in pairs.items()
            if isinstance(pair[0], np.ndarray)
        }
        return replace(self, **columns)

    def to_toolpath(self, operation: Operation) -> Toolpath:
        """Return the toolpath of all strokes: air moves, plunges, swivels, feeds and lifts.

        ``operation`` contains the feeds and the station of the tool.  Without strokes, the toolpath
        has no moves.
        """
        if len(self.track) == 0:
            return empty_toolpath()
        columns = _StrokeColumns(*(getattr(self, name) for name in _StrokeColumns._fields))
        pose, bulge, motion, feed, source, track = _write_moves(
            columns,
            operation.feed * self.slowing,
            operation.plunge,
            operation.feed if self.drags else operation.swivel,
            _FEED if self.drags else _SWIVEL,
        )
        # Read-only arrays are stored without a copy.
        for column in (pose, bulge, motion, feed, source, track):
            column.flags.writeable = False
        # The first row is the air move to the first track; the toolpath starts at its end.
        return Toolpath(
            pose=pose,
            bulge=bulge[1:],
            motion=motion[1:],
            feed=feed[1:],
            source=source[1:],
            tool=np.full(len(motion) - 1, operation.station, np.uint8),
            track=track[1:],
        )


class _StrokeColumns(NamedTuple):
    """The columns of ``Strokes`` that a kernel reads; it describes their shapes and units."""

    start: F64_2
    end: F64_2
    bulge: F64_1
    above_start: F64_2
    above_end: F64_2
    down: Bool_1
    up: Bool_1
    track: I32_1
    source: I32_1
    swing: F64_1
    motion: U8_1
    swivel_z: F64_1


@kernel
def _write_moves(
    strokes: _StrokeColumns, feed: F64_1, plunge: float, swivel: float, swivel_motion: int
) -> Any:
    """Return the moves of n strokes as columns of a ``Toolpath``.

    A stroke is the feed along one segment of a track.  With its travel, plunge, turn and lift it
    has up to eight moves.  Where a tool turns and changes its depth between two strokes, it turns
    at the smaller depth.

    ``feed`` (n,) mm/min: feed of each stroke.
    ``plunge``, ``swivel``: feeds for plunges and lifts (mm/min), and for swivels (degrees/min;
    mm/min if the swing drags the tool round).
    ``swivel_motion``: ``Motion`` of swivels.
    Returns ``pose, bulge, motion, feed, source, track`` (m, 4) and (m,) each: pose of the head at
    the end of each move, and the attributes of the move, as in ``Toolpath``.
    """
    start, end, bulge, above_start, above_end, down, up, track, source, swing, motion, swivel_z = (
        strokes
    )
    count = len(bulge)
    travels = (start[:, 0] != end[:, 0]) | (start[:, 1] != end[:, 1])
    depth_changes = np.zeros(count, np.bool_)
    turns = np.zeros(count, np.bool_)
    lifts = np.zeros(count, np.bool_)
    for i in range(count):
        if not down[i]:
            depth_changes[i] = abs(start[i, 2] - end[i - 1, 2]) > _MIN_CHANGE
            turns[i] = abs(start[i, 3] - end[i - 1, 3]) > _MIN_CHANGE
            lifts[i] = turns[i] and swivel_z[i] > max(start[i, 2], end[i - 1, 2])
            depth_changes[i] = depth_changes[i] and not lifts[i]
    rows = (
        2 * lifts.sum()
        + 2 * down.sum()
        + depth_changes.sum()
        + turns.sum()
        + travels.sum()
        + up.sum()
    )
    poses = np.empty((rows, 4))
    bent = np.zeros(rows)
    kind = np.empty(rows, np.uint8)
    speed = np.empty(rows)
    edge = np.empty(rows, np.int32)
    tracks = np.empty(rows, np.int32)
    row = 0
    for i in range(count):
        first_move = row
        if down[i]:
            poses[row] = above_start[i]
            kind[row], speed[row] = _RAPID, 0.0
            poses[row + 1] = start[i]
            kind[row + 1], speed[row + 1] = _PLUNGE, plunge
            row += 2
        turns_first = turns[i] and depth_changes[i] and start[i, 2] < end[i - 1, 2]
        if depth_changes[i] and not turns_first:
            poses[row] = end[i - 1]
            poses[row, 2] = start[i, 2]
            kind[row], speed[row] = _PLUNGE, plunge
            row += 1
        if lifts[i]:
            poses[row] = end[i - 1]
            poses[row, 2] = swivel_z[i]
            kind[row], speed[row] = _LIFT, plunge
            row += 1
        if turns[i]:
            poses[row] = start[i]
            if lifts[i]:
                poses[row, 2] = swivel_z[i]
            if turns_first:
                poses[row, 2] = end[i - 1, 2]
            kind[row], speed[row], bent[row] = swivel_motion, swivel, swing[i]
            row += 1
        if turns_first or lifts[i]:
            poses[row] = start[i]
            kind[row], speed[row] = _PLUNGE, plunge
            row += 1
        if travels[i]:
            poses[row] = end[i]
            kind[row], speed[row], bent[row] = motion[i], feed[i], bulge[i]
            row += 1
        if up[i]:
            poses[row] = above_end[i]
            kind[row], speed[row] = _LIFT, plunge
            row += 1
        edge[first_move:row] = source[i]
        tracks[first_move:row] = track[i]
        if down[i]:
            edge[first_move] = -1
            if i == 0 or track[i] != track[i - 1]:
                tracks[first_move] = -1  # the air move to the start of a track belongs to no track
    return poses, bent, kind, speed, edge, tracks
