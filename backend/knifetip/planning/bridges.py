"""Bridges: the nicks that hold a part in its sheet until it is broken out.

    closed Paths -> open Paths between the bridges

Bridges stand at equal distances round the contour, each moved to the nearest place where it may
be: on a straight piece, 5 mm clear of a sharp corner, or in the middle of a piece too short for
that; on an arc only where the straight pieces leave no other way.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from knifetip.errors import NoRoomForBridges
from knifetip.geometry import arc
from knifetip.geometry.azimuth import unit
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.path import Paths, taken, trimmed
from knifetip.geometry.tolerance import ANGLE, BULGE, POINT

#: A bridge stays this far from a sharp corner (mm).
_CLEAR = 5.0
#: No contour is held by fewer.
_FEWEST = 2
#: Up to so many times the bridges that equal distances need are tried, in so many steps.
_MORE = 4
_TRIES = 16


def bridged(
    paths: Paths, which: Bool, width: float, spacing: float, source: I32
) -> tuple[Paths, I32, I32]:
    """Return the paths, the closed ones among ``which`` interrupted by bridges.

    Parameters
    ----------
    which : (p,)
        The paths to interrupt; they must be closed.
    width, spacing : mm
        Of a bridge, and the longest way from the middle of one to that of the next.
    source : (n,)
        The edge of each segment, for the error.

    Returns
    -------
    Paths, and for each the old path (q,), and for each segment the old one (m,)

    Raises
    ------
    NoRoomForBridges
        A contour has no places for two bridges, or none near enough to each other.
    """
    low, high, owner = [], [], []
    length = paths.lengths
    for path in range(len(paths)):
        if which[path]:
            middle = _places(paths, path, width, spacing, source)
            low.append(middle + width / 2.0)
            # The last piece goes on over the contour's start.
            high.append(np.append(middle[1:], middle[0] + length[path]) - width / 2.0)
        else:
            low.append(np.zeros(1))
            high.append(length[path : path + 1])
        owner.append(np.full(len(low[-1]), path))
    kept = np.concatenate(owner).astype(np.int32)
    twice, rows = _twice_round(paths, which)
    repeated, again = taken(twice, kept)
    begin, end = np.concatenate(low), np.concatenate(high)
    pieces, order = trimmed(repeated, begin, np.maximum(repeated.lengths - end, 0.0))
    return pieces, kept, rows[again[order]]


def _twice_round(paths: Paths, which: Bool) -> tuple[Paths, I32]:
    """Return the paths, those among ``which`` followed twice, and the segment of each new one."""
    count = np.diff(paths.first)
    times = np.where(which, 2, 1)
    first = np.concatenate([[0], np.cumsum(count * times)])
    owner = np.repeat(np.arange(len(paths)), count * times)
    rows = paths.first[owner] + (np.arange(first[-1]) - first[owner]) % count[owner]
    return Paths(paths.start[rows], paths.end[rows], paths.bulge[rows], first), rows.astype(
        np.int32
    )


@dataclass(frozen=True, eq=False, slots=True)
class _Room:
    """Where along a contour the middle of a bridge may be: from low to high, ascending."""

    low: F64  #: mm
    high: F64  #: mm

    def nearest(self, wanted: F64) -> F64:
        """Return the place nearest to each wanted one (mm)."""
        clipped = np.clip(wanted[:, None], self.low, self.high)
        # Of two as near as each other the first, also where the last digits say otherwise.
        best = np.round(np.abs(clipped - wanted[:, None]), 6).argmin(axis=1)
        chosen: F64 = clipped[np.arange(len(wanted)), best]
        return chosen


def _places(paths: Paths, path: int, width: float, spacing: float, source: I32) -> F64:
    """Return where along a closed path the middles of its bridges are, ascending (mm)."""
    length = float(paths.lengths[path])
    fewest = max(_FEWEST, math.ceil(length / spacing - 1e-9))
    for arcs_too in (False, True):
        room = _room(paths, path, width, arcs_too)
        counts = np.unique(np.linspace(fewest, _MORE * fewest, _TRIES).astype(np.int64))
        for count in counts if len(room.low) else ():
            middle = np.unique(room.nearest((np.arange(count) + 0.5) * length / count))
            apart = np.diff(np.append(middle, middle[0] + length))
            if (
                len(middle) >= fewest
                and apart.min() > 2.0 * width
                and apart.max() <= spacing + POINT
            ):
                return middle
    edge = int(source[paths.first[path]])
    raise NoRoomForBridges(
        f"The contour at edge {edge} is {length:.1f} mm round and has no places for {fewest} "
        f"bridges of {width:.2f} mm, at most {spacing:.1f} mm apart and clear of its corners.",
        "Ask for narrower bridges or a longer spacing, or cut this board without bridges.",
        [str(edge)],
    )


def _room(paths: Paths, path: int, width: float, arcs_too: bool) -> _Room:
    rows = slice(paths.first[path], paths.first[path + 1])
    start, end, bulge = paths.start[rows], paths.end[rows], paths.bulge[rows]
    size = arc.length(start, end, bulge)
    begin = np.cumsum(size) - size
    ahead, last = (unit(vectors) for vectors in arc.tangents(start, end, bulge))
    sharp = (np.roll(last, 1, axis=0) * ahead).sum(axis=1) < math.cos(math.radians(ANGLE))
    clear = np.minimum(_CLEAR + width / 2.0, size / 2.0)
    # Beside a smooth joint a bridge stays on its own piece too: half of it on an arc is on an arc.
    low = np.where(sharp, clear, width / 2.0)
    high = size - np.where(np.roll(sharp, -1), clear, width / 2.0)
    room = (size >= 2.0 * width) & (high >= low - 1e-9)
    if not arcs_too:
        room &= np.abs(bulge) < BULGE
    return _Room((begin + low)[room], (begin + np.maximum(low, high))[room])
