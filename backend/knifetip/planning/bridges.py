"""Bridges: the nicks that hold a part in its sheet until it is broken out.

    closed Paths -> the places of bridges on them

Bridges stand at equal distances round the contour, each moved to the nearest place where it may
be: on a straight piece, 5 mm clear of a sharp corner, or in the middle of a piece too short for
that; on an arc only where the straight pieces leave no other way, and never in a slot that a cutter
clears on its way along the other side.  Where a slit opens into the contour, or a crease ends on
it, it is weak, and bridges stay 5 mm clear of it too if they can.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from knifetip.errors import NoRoomForBridges
from knifetip.geometry import arc
from knifetip.geometry.azimuth import unit
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import ANGLE, BULGE, GAP, POINT
from knifetip.model.dieline import Dieline, LineType
from knifetip.planning.near import near
from knifetip.planning.reached import Reached

#: A bridge stays this far from a sharp corner (mm).
_CLEAR = 5.0
#: No contour is held by fewer.
_FEWEST = 2
#: Up to so many times the bridges that equal distances need are tried, in so many steps.
_MORE = 4
_TRIES = 16


def places(
    paths: Paths,
    which: Bool,
    gap: float,
    spacing: float,
    source: I32,
    avoid: F64,
    reached: Reached,
) -> tuple[I32, F64]:
    """Return the path of each bridge, (k,), and how far along it its middle is, (k,) mm.

    Parameters
    ----------
    which : (p,)
        The paths to interrupt; they must be closed.
    gap, spacing : mm
        What a bridge takes of its path, and the longest way from the middle of one to that of the
        next.
    source : (n,)
        The edge of each segment, for the error.
    avoid : (m, 2) mm
        Where other work ends: on the paths, bridges stay clear of it where they can.
    reached
        Where the tool comes to the paths: a bridge with nothing cut beside it is none.

    Raises
    ------
    NoRoomForBridges
        A contour has no places for two bridges, or none near enough to each other.
    """
    on, at = _along(paths, which, avoid)
    found = [
        _places(paths, int(path), gap, spacing, source, at[on == path], reached)
        for path in np.flatnonzero(which)
    ]
    size = [len(middle) for middle in found]
    path = np.repeat(np.flatnonzero(which), size).astype(np.int32)
    return path, np.concatenate([*found, np.zeros(0)])


def ends_of_others(dieline: Dieline, rows: I32) -> F64:
    """Return the ends, (m, 2) mm, of all edges that are worked, but for some rows."""
    worked = ~np.isin(dieline.line_type, (LineType.IGNORED, LineType.UNCLASSIFIED))
    worked[rows] = False
    ends: F64 = dieline.ends[worked].reshape(-1, 2)
    return ends


def _along(paths: Paths, which: Bool, points: F64) -> tuple[I32, F64]:
    """Return for points on some of the paths which, and how far along it they are (mm)."""
    rows = np.flatnonzero(which[paths.path_of])
    start, end, bulge = paths.start[rows], paths.end[rows], paths.bulge[rows]
    point, row = near(np.hstack([points, points]), arc.bounds(start, end, bulge), GAP)
    whole = start[row], end[row], bulge[row]
    share = arc.nearest(*whole, points[point])
    on = np.hypot(*(arc.point_at(*whole, share) - points[point]).T) <= GAP
    row, share = rows[row[on]], share[on]
    size = arc.length(paths.start, paths.end, paths.bulge)
    reached = np.cumsum(size) - size
    path = paths.path_of[row]
    return path, reached[row] - reached[paths.first[:-1][path]] + share * size[row]


@dataclass(frozen=True, eq=False, slots=True)
class _Room:
    """Where along a contour the middle of a bridge may be: from low to high, ascending."""

    low: F64  #: mm
    high: F64  #: mm

    def without(self, at: F64, clear: float, length: float) -> _Room:
        """Return what is left ``clear`` mm from places on a contour that is ``length`` mm round."""
        low, high = self.low, self.high
        for place in np.concatenate([at - length, at, at + length]):
            before, after = np.minimum(high, place - clear), np.maximum(low, place + clear)
            begin, end = np.concatenate([low, after]), np.concatenate([before, high])
            order = np.argsort(begin, kind="stable")
            some = order[(end >= begin)[order]]
            low, high = begin[some], end[some]
        return _Room(low, high)

    def nearest(self, wanted: F64) -> F64:
        """Return the place nearest to each wanted one (mm)."""
        clipped = np.clip(wanted[:, None], self.low, self.high)
        # Of two as near as each other the first, also where the last digits say otherwise.
        far = np.abs(clipped - wanted[:, None])
        best = (far <= far.min(axis=1, keepdims=True) + POINT).argmax(axis=1)
        chosen: F64 = clipped[np.arange(len(wanted)), best]
        return chosen


def _places(
    paths: Paths, path: int, gap: float, spacing: float, source: I32, at: F64, reached: Reached
) -> F64:
    """Return where along a closed path the middles of its bridges are, ascending (mm)."""
    length = float(paths.lengths[path])
    fewest = max(_FEWEST, math.ceil(length / spacing - 1e-9))
    for kept_clear, arcs_too in ((at, False), (at, True), (at[:0], False), (at[:0], True)):
        room = _room(paths, path, gap, reached, arcs_too)
        room = room.without(kept_clear, _CLEAR + gap / 2.0, length)
        counts = np.unique(np.linspace(fewest, _MORE * fewest, _TRIES).astype(np.int64))
        for count in counts if len(room.low) else ():
            middle = np.unique(room.nearest((np.arange(count) + 0.5) * length / count))
            apart = np.diff(np.append(middle, middle[0] + length))
            if len(middle) >= fewest and apart.min() > 2.0 * gap and apart.max() <= spacing + POINT:
                return _needed(middle, length, spacing)
    edge = int(source[paths.first[path]])
    raise NoRoomForBridges(
        "bridges.no-room",
        edge=edge,
        length=length,
        fewest=fewest,
        gap=gap,
        spacing=spacing,
        source=[str(edge)],
    )


def _needed(middle: F64, length: float, spacing: float) -> F64:
    """Return the middles of bridges without those between two that are near enough already."""
    while len(middle) > _FEWEST:
        around = np.concatenate([middle[-1:] - length, middle, middle[:1] + length])
        without = around[2:] - around[:-2]
        spare = int(without.argmin())
        if without[spare] > spacing + POINT:
            break
        middle = np.delete(middle, spare)
    return middle


def _room(paths: Paths, path: int, gap: float, reached: Reached, arcs_too: bool) -> _Room:
    rows = slice(paths.first[path], paths.first[path + 1])
    start, end, bulge = paths.start[rows], paths.end[rows], paths.bulge[rows]
    size = arc.length(start, end, bulge)
    begin = np.cumsum(size) - size
    ahead, last = (unit(vectors) for vectors in arc.tangents(start, end, bulge))
    before = np.roll(last, 1, axis=0)
    straight_on = (before * ahead).sum(axis=1)
    sharp = straight_on < math.cos(math.radians(ANGLE))
    clear = np.minimum(_CLEAR + gap / 2.0, size / 2.0)
    # Beside a smooth joint a bridge stays on its own piece too: half of it on an arc is on an arc.
    low = np.where(sharp, clear, gap / 2.0)
    high = size - np.where(np.roll(sharp, -1), clear, gap / 2.0)
    room = (size >= 2.0 * gap) & (high >= low - 1e-9)
    if not arcs_too:
        room &= np.abs(bulge) < BULGE
    some = slice(*np.searchsorted(reached.segment, [rows.start, rows.stop]))
    on = reached.segment[some] - rows.start
    low = np.maximum(low[on], reached.low[some] + gap / 2.0)
    high = np.minimum(np.maximum(low, high[on]), reached.high[some] - gap / 2.0)
    room = room[on] & (high >= low - 1e-9)
    return _Room((begin[on] + low)[room], (begin[on] + np.maximum(low, high))[room])
