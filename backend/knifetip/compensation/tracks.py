"""Tracks: how a tool that goes down, along its path and up again becomes a Toolpath.

An engine says for every segment where the head stands at both its ends; this module lays out the
moves, all segments at once.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.azimuth import azimuth, turn
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.path import Paths
from knifetip.model.operation import Operation
from knifetip.model.toolpath import Motion, Toolpath

#: A smaller change of direction or depth needs no move of its own (degrees, mm).
_STILL = 1e-7


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
        )

    def merged(self, other: Strokes) -> Strokes:
        """Return these strokes and others, their tracks in order."""
        order = np.argsort(np.concatenate([self.track, other.track]), kind="stable")
        columns = {
            field.name: np.concatenate([getattr(self, field.name), getattr(other, field.name)])
            for field in fields(self)
        }
        return Strokes(**{name: column[order] for name, column in columns.items()})

    def laid(self, operation: Operation) -> Toolpath:
        """Return the moves: jump or turn in the air, plunge, step, swivel, feed, lift."""
        new = np.ones(len(self.bulge), np.bool_)
        new[1:] = self.track[1:] != self.track[:-1]
        before = np.roll(self.end, 1, axis=0)
        stepped = before.copy()
        stepped[:, 2] = self.start[:, 2]
        change = np.abs(self.start - before)
        straight = np.zeros(len(self.bulge))
        travels = (self.start[:, :2] != self.end[:, :2]).any(axis=1)
        # One slot for each kind of move, in order; a segment has those whose condition holds.
        slots: list[tuple[Motion, Bool, F64, F64, float]] = [
            (Motion.RAPID, self.down, self.above_start, straight, 0.0),
            (Motion.PLUNGE, self.down, self.start, straight, operation.plunge),
            (
                Motion.PLUNGE,
                ~self.down & (change[:, 2] > _STILL),
                stepped,
                straight,
                operation.plunge,
            ),
            (
                Motion.SWIVEL,
                ~self.down & (change[:, 3] > _STILL),
                self.start,
                self.swing,
                operation.swivel,
            ),
            (Motion.FEED, travels, self.end, self.bulge, operation.feed),
            (Motion.LIFT, self.up, self.above_end, straight, operation.plunge),
        ]
        wide = len(slots)
        mask = np.stack([slot[1] for slot in slots], axis=1).ravel()
        motion = np.tile(np.array([slot[0] for slot in slots], np.uint8), len(self.bulge))[mask]
        pose = np.stack([slot[2] for slot in slots], axis=1).reshape(-1, 4)[mask]
        bulge = np.stack([slot[3] for slot in slots], axis=1).ravel()[mask]
        feed = np.tile([slot[4] for slot in slots], len(self.bulge))[mask]
        track = np.repeat(self.track, wide)
        track[::wide][new] = -1  # the jump to where a track begins belongs to none
        source = np.repeat(self.source, wide)[mask]
        # The first row is the jump to the first track: where it ends the toolpath begins.
        return Toolpath(
            pose=pose,
            bulge=bulge[1:],
            motion=motion[1:],
            feed=feed[1:],
            source=np.where(motion == Motion.RAPID, -1, source)[1:],
            tool=np.full(len(motion) - 1, operation.station),
            track=track[mask][1:],
        )
