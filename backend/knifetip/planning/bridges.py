"""bridges: find positions for the bridges (nicks) that hold a part in its sheet.

Bridges are first spaced equally around the contour.  Then each is moved to the nearest permitted
position: on a straight segment, 5 mm away from sharp corners, or in the middle of a segment that is
too short for this.  Arcs are used only if the straight segments do not suffice.  A narrow slot gets
no bridge if the cutter, while it cuts one side of the slot, also removes the other side.

The board is weak at a point at which a slit opens into the contour, or a crease ends on it.
Bridges stay 5 mm away from such points, if possible.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from knifetip.errors import NoRoomForBridges
from knifetip.geometry import arc
from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import ANGLE, BULGE, GAP, POINT
from knifetip.model.dieline import Dieline, LineType
from knifetip.planning.reachable import ReachableStretches

#: Distance of a bridge from a sharp corner (mm).
_CLEAR = 5.0
#: Least number of bridges on a contour, and on each part of a blank that cuts divide.
FEWEST = 2
#: Counts of bridges that are tried: up to this multiple of the least count, in this many steps.
_MORE = 4
_TRIES = 16


class Spacing(NamedTuple):
    """Length of bridges along a path, and the greatest distance between neighbouring bridges."""

    gap: float  #: mm of the path that a bridge takes
    most: float  #: greatest distance between the middles of two neighbouring bridges (mm)


def place_bridges(
    paths: Paths,
    selected: Bool,
    spacing: Spacing,
    source: I32,
    avoid: F64,
    reachable: ReachableStretches,
) -> tuple[I32, F64]:
    """Return the positions of k bridges: the path of each bridge, (k,), and the distance from the
    start of that path to the middle of the bridge, (k,) mm.

    Parameters
    ----------
    selected : (p,)
        Mask of the paths that get bridges; they must be closed.
    spacing
        Length of the bridges, and the greatest distance between them.
    source : (n,)
        Index in the dieline of the edge of each segment, for error messages.
    avoid : (m, 2) mm
        Ends of other edges.  If possible, bridges keep away from the ends that lie on the paths.
    reachable
        Stretches of the segments that the tool can reach; bridges lie only there.

    Raises
    ------
    NoRoomForBridges
        A contour has no room for two bridges, or two neighbouring bridges would be too far apart.
    """
    avoid_path, avoid_position = _positions_along(paths, selected, avoid)
    positions = [
        _place_on_contour(
            paths, int(path), spacing, source, avoid_position[avoid_path == path], reachable
        )
        for path in np.flatnonzero(selected)
    ]
    size = [len(middle) for middle in positions]
    path = np.repeat(np.flatnonzero(selected), size).astype(np.int32)
    return path, np.concatenate([*positions, np.zeros(0)])


def ends_of_others(dieline: Dieline, rows: I32) -> F64:
    """Return the ends, (m, 2) mm, of those edges of a dieline that are not in ``rows``.

    ``rows`` are indices of edges in the dieline.  Ignored and unclassified edges are left out too.
    """
    has_work = ~np.isin(dieline.line_type, (LineType.IGNORED, LineType.UNCLASSIFIED))
    has_work[rows] = False
    ends: F64 = dieline.ends[has_work].reshape(-1, 2)
    return ends


def _positions_along(paths: Paths, selected: Bool, points: F64) -> tuple[I32, F64]:
    """Return the path on which each point lies, and the position of the point along this path.

    Points that lie on no path are left out.

    ``selected`` (p,): mask of the paths that are searched.
    ``points`` (m, 2) mm: the points.
    Returns path of each located point (k,), and the point's distance from the start of that path
    (k,) mm.
    """
    rows = np.flatnonzero(selected[paths.path_of])
    start, end, bulge = paths.start[rows], paths.end[rows], paths.bulge[rows]
    point, row = box_pairs(arc.point_boxes(points), arc.bounding_boxes(start, end, bulge), GAP)
    segments = start[row], end[row], bulge[row]
    fraction = arc.nearest_fraction(*segments, points[point])
    touches = np.hypot(*(arc.point_at(*segments, fraction) - points[point]).T) <= GAP
    row, fraction = rows[row[touches]], fraction[touches]
    size = arc.length(paths.start, paths.end, paths.bulge)
    before = np.cumsum(size) - size
    path = paths.path_of[row]
    return path, before[row] - before[paths.first[:-1][path]] + fraction * size[row]


@dataclass(frozen=True, eq=False, slots=True)
class _FreeRanges:
    """Ranges along a closed contour, in ascending order, in which the middle of a bridge may lie.

    Positions are measured in mm from the start of the contour.
    """

    low: F64  #: mm
    high: F64  #: mm

    def without(self, positions: F64, clear: float, length: float) -> _FreeRanges:
        """Return the parts of the ranges that are at least ``clear`` mm away from given positions.

        ``positions`` are the given positions along the closed contour (mm), and ``length`` is the
        length of the contour (mm).
        """
        low, high = self.low, self.high
        for position in np.concatenate([positions - length, positions, positions + length]):
            before, after = np.minimum(high, position - clear), np.maximum(low, position + clear)
            begin, end = np.concatenate([low, after]), np.concatenate([before, high])
            order = np.argsort(begin, kind="stable")
            nonempty = order[(end >= begin)[order]]
            low, high = begin[nonempty], end[nonempty]
        return _FreeRanges(low, high)

    def nearest(self, desired: F64) -> F64:
        """Return the nearest permitted position for each of n desired positions, (n,) mm.

        ``desired`` are the desired positions along the contour, (n,) mm.
        """
        clipped = np.clip(desired[:, None], self.low, self.high)
        # Of two equally near positions the first is taken, whatever the rounding.
        far = np.abs(clipped - desired[:, None])
        best = (far <= far.min(axis=1, keepdims=True) + POINT).argmax(axis=1)
        chosen: F64 = clipped[np.arange(len(desired)), best]
        return chosen


def _place_on_contour(
    paths: Paths, path: int, bridge: Spacing, source: I32, avoid: F64, reachable: ReachableStretches
) -> F64:
    """Return the positions of the middles of the bridges along one closed path, ascending (mm).

    ``path``: index of the path in ``paths``.
    ``bridge``: length of the bridges, and the greatest distance between neighbouring bridges.
    ``source`` (n,): index in the dieline of the edge of each segment, for error messages.
    ``avoid`` (k,) mm: positions along the path from which bridges keep away, if possible.
    ``reachable``: stretches of the segments that the tool can reach; bridges lie only there.
    Raises ``NoRoomForBridges``: the path has no room for two bridges, or two neighbouring bridges
    would be too far apart.
    """
    gap, spacing = bridge
    length = float(paths.lengths[path])
    fewest = max(FEWEST, math.ceil(length / spacing - 1e-9))
    for kept_clear, arcs_too in (
        (avoid, False),
        (avoid, True),
        (avoid[:0], False),
        (avoid[:0], True),
    ):
        free = _free_ranges(paths, path, gap, reachable, arcs_too)
        free = free.without(kept_clear, _CLEAR + gap / 2.0, length)
        counts = np.unique(np.linspace(fewest, _MORE * fewest, _TRIES).astype(np.int64))
        for count in counts if len(free.low) else ():
            middle = np.unique(free.nearest((np.arange(count) + 0.5) * length / count))
            distances = np.diff(np.append(middle, middle[0] + length))
            if (
                len(middle) >= fewest
                and distances.min() > 2.0 * gap
                and distances.max() <= spacing + POINT
            ):
                return _drop_spare(middle, length, spacing)
    contour = source[paths.first[path] : paths.first[path + 1]]
    raise NoRoomForBridges(
        "bridges.no-room",
        edge=contour[0],
        length=length,
        fewest=fewest,
        gap=gap,
        spacing=spacing,
        at_edges=contour,
    )


def _drop_spare(middle: F64, length: float, spacing: float) -> F64:
    """Remove superfluous bridges; return the positions of the remaining bridges, ascending (mm).

    A bridge is superfluous if the bridges before and after it are not more than ``spacing`` mm
    apart.  At least two bridges remain.  ``middle`` are the positions of the bridges along a closed
    contour of ``length`` mm, ascending.
    """
    while len(middle) > FEWEST:
        neighbours = np.concatenate([middle[-1:] - length, middle, middle[:1] + length])
        gaps = neighbours[2:] - neighbours[:-2]
        spare = int(gaps.argmin())
        if gaps[spare] > spacing + POINT:
            break
        middle = np.delete(middle, spare)
    return middle


def _free_ranges(
    paths: Paths, path: int, gap: float, reachable: ReachableStretches, arcs_too: bool
) -> _FreeRanges:
    """Return the ranges along a path in which the middle of a bridge may lie.

    ``path``: index of the path in ``paths``.
    ``gap`` mm: length of the bridge along the path.
    ``reachable``: stretches of the segments that the tool can reach.
    ``arcs_too``: whether bridges may lie on arcs.
    """
    rows = slice(paths.first[path], paths.first[path + 1])
    start, end, bulge = paths.start[rows], paths.end[rows], paths.bulge[rows]
    size = arc.length(start, end, bulge)
    begin = np.cumsum(size) - size
    ahead, last = (unit_vectors(vectors) for vectors in arc.tangents(start, end, bulge))
    before = np.roll(last, 1, axis=0)
    straight_on = (before * ahead).sum(axis=1)
    sharp = straight_on < math.cos(math.radians(ANGLE))
    clear = np.minimum(_CLEAR + gap / 2.0, size / 2.0)
    # At a smooth joint, too, a bridge stays on one segment: it must not lie half on an arc.
    low = np.where(sharp, clear, gap / 2.0)
    high = size - np.where(np.roll(sharp, -1), clear, gap / 2.0)
    free = (size >= 2.0 * gap) & (high >= low - 1e-9)
    if not arcs_too:
        free &= np.abs(bulge) < BULGE
    stretches = slice(*np.searchsorted(reachable.segment, [rows.start, rows.stop]))
    local_segment = reachable.segment[stretches] - rows.start
    low = np.maximum(low[local_segment], reachable.low[stretches] + gap / 2.0)
    high = np.minimum(np.maximum(low, high[local_segment]), reachable.high[stretches] - gap / 2.0)
    free = free[local_segment] & (high >= low - 1e-9)
    return _FreeRanges(
        (begin[local_segment] + low)[free], (begin[local_segment] + np.maximum(low, high))[free]
    )
