"""Tracks: how a tool that goes down, along its path and up again becomes a Toolpath.

An engine says for every segment where the head stands at both its ends; this module lays out the
moves, all segments at once.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.azimuth import azimuth, turn
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.path import Paths
from knifetip.kernels import F64_1, F64_2, I32_1, U8_1, Bool_1, kernel
from knifetip.model.operation import Operation
from knifetip.model.toolpath import Motion, Toolpath

#: A smaller change of direction or depth needs no move of its own (degrees, mm).
_STILL = 1e-7
# A kernel knows plain numbers.
_RAPID, _PLUNGE, _SWIVEL = int(Motion.RAPID), int(Motion.PLUNGE), int(Motion.SWIVEL)
_LIFT = int(Motion.LIFT)


def headings(paths: Paths) -> tuple[F64, F64]:
    """Return C at the start and at the end of every segment (degrees), unwrapped along each path.

    The first heading of a path is its azimuth in [0, 360); along an arc C turns with the tangent,
    at a corner by the smaller angle.
    """
    ahead, last = arc.tangents(paths.start, paths.end, paths.bulge)
    begin = azimuth(ahead)
    swept = np.degrees(arc.sweep(paths.bulge))
    corner = np.zeros(len(begin))
    corner[1:] = turn(azimuth(last)[:-1], begin[1:])
    first = paths.first[:-1]
    corner[first] = 0.0
    gained = np.cumsum(corner + swept) - swept
    start: F64 = gained + (begin[first] - gained[first])[paths.path_of]
    return start, start + swept


@dataclass(frozen=True, eq=False, slots=True)
class Strokes:
    """n segments in working order, at least one, with the head's pose at both ends of each.

    A segment whose ends are one point is pressed: the tool goes down and up and does not travel.
    """

    start: F64  #: (n, 4) x y z c
    end: F64  #: (n, 4)
    bulge: F64  #: (n,)
    above_start: F64  #: (n, 4) where the head plunges from, if it does
    above_end: F64  #: (n, 4) where it lifts to, if it does
    down: Bool  #: (n,) the tool plunges before this segment
    up: Bool  #: (n,) it lifts after it
    track: I32  #: (n,) the track of each segment, ascending
    source: I32  #: (n,) row in Dieline
    swing: F64  #: (n,) bulge of the head's way round the tip where C turns in the board
    motion: U8  #: (n,) FEED, LEAD_IN or LEAD_OUT

    @classmethod
    def flat(
        cls,
        *,
        start: F64,
        end: F64,
        bulge: F64,
        down: Bool,
        up: Bool,
        track: I32,
        source: I32,
        height: float,
        swing: F64 | None = None,
        motion: U8 | None = None,
    ) -> Strokes:
        """Return the strokes of an upright tool, which plunges from ``height`` and lifts to it."""
        above_start, above_end = start.copy(), end.copy()
        above_start[:, 2] = above_end[:, 2] = height
        return cls(
            start=start,
            end=end,
            bulge=bulge,
            above_start=above_start,
            above_end=above_end,
            down=down,
            up=up,
            track=track,
            source=source,
            swing=np.zeros(len(bulge)) if swing is None else swing,
            motion=np.full(len(bulge), Motion.FEED, np.uint8) if motion is None else motion,
        )

    def merged(self, other: Strokes) -> Strokes:
        """Return these strokes and others, their tracks in order."""
        if len(other.track) == 0:
            return self
        order = np.argsort(np.concatenate([self.track, other.track]), kind="stable")
        columns = {
            field.name: np.concatenate([getattr(self, field.name), getattr(other, field.name)])
            for field in fields(self)
        }
        return Strokes(**{name: column[order] for name, column in columns.items()})

    def laid(self, operation: Operation) -> Toolpath:
        """Return the moves: jump or turn in the air, plunge, step, swivel, feed, lift."""
        pose, bulge, motion, feed, source, track = _laid(
            self.start,
            self.end,
            self.bulge,
            self.above_start,
            self.above_end,
            self.down,
            self.up,
            self.track,
            self.source,
            self.swing,
            self.motion,
            operation.feed,
            operation.plunge,
            operation.swivel,
        )
        # What cannot be written to goes into the record as it stands.
        for column in (pose, bulge, motion, feed, source, track):
            column.flags.writeable = False
        # The first row is the jump to the first track: where it ends the toolpath begins.
        return Toolpath(
            pose=pose,
            bulge=bulge[1:],
            motion=motion[1:],
            feed=feed[1:],
            source=source[1:],
            tool=np.full(len(motion) - 1, operation.station, np.uint8),
            track=track[1:],
        )


@kernel
def _laid(
    start: F64_2,
    end: F64_2,
    bulge: F64_1,
    above_start: F64_2,
    above_end: F64_2,
    down: Bool_1,
    up: Bool_1,
    track: I32_1,
    source: I32_1,
    swing: F64_1,
    motion: U8_1,
    feed: float,
    plunge: float,
    swivel: float,
) -> Any:
    """Lay out all strokes, each as those of its six moves that it needs."""
    count = len(bulge)
    travels = (start[:, 0] != end[:, 0]) | (start[:, 1] != end[:, 1])
    stepped = np.zeros(count, np.bool_)
    turned = np.zeros(count, np.bool_)
    for i in range(count):
        if not down[i]:
            stepped[i] = abs(start[i, 2] - end[i - 1, 2]) > _STILL
            turned[i] = abs(start[i, 3] - end[i - 1, 3]) > _STILL
    rows = 2 * down.sum() + stepped.sum() + turned.sum() + travels.sum() + up.sum()
    poses = np.empty((rows, 4))
    bent = np.zeros(rows)
    kind = np.empty(rows, np.uint8)
    speed = np.empty(rows)
    edge = np.empty(rows, np.int32)
    tracks = np.empty(rows, np.int32)
    row = 0
    for i in range(count):
        begun = row
        if down[i]:
            poses[row] = above_start[i]
            kind[row], speed[row] = _RAPID, 0.0
            poses[row + 1] = start[i]
            kind[row + 1], speed[row + 1] = _PLUNGE, plunge
            row += 2
        if stepped[i]:
            poses[row] = end[i - 1]
            poses[row, 2] = start[i, 2]
            kind[row], speed[row] = _PLUNGE, plunge
            row += 1
        if turned[i]:
            poses[row] = start[i]
            kind[row], speed[row], bent[row] = _SWIVEL, swivel, swing[i]
            row += 1
        if travels[i]:
            poses[row] = end[i]
            kind[row], speed[row], bent[row] = motion[i], feed, bulge[i]
            row += 1
        if up[i]:
            poses[row] = above_end[i]
            kind[row], speed[row] = _LIFT, plunge
            row += 1
        edge[begun:row] = source[i]
        tracks[begun:row] = track[i]
        if down[i]:
            edge[begun] = -1
            if i == 0 or track[i] != track[i - 1]:
                tracks[begun] = -1  # the jump to where a track begins belongs to none
    return poses, bent, kind, speed, edge, tracks
