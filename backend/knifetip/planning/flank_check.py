"""flank_check: shift V-grooves away from cuts beside them; check that no flank passes a cut.

On the top face, a groove of depth h and flank angle θ is a strip of half-width h tan θ.  A cut
inside this strip would lose its edge.  The flank passes the cut by h tan θ minus the distance of
the cut from the groove's line.  If such cuts lie on one side of a groove only, the groove may be
shifted by that length to the other side, as far as the board allows (``groove_shift``).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.errors import FlankOutside
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.spatial_index.box_pairs import box_pairs
from knifetip.geometry.tolerance import BULGE, GAP, POINT
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType

#: Greatest deviation of the chords that approximate an arc (mm).
_CHORD: Final = 0.5 * POINT


@dataclass(frozen=True, eq=False, slots=True)
class _NearbyChords:
    """k pairs of a groove and a chord of a nearby cut, in coordinates along and across the groove.

    Only the part of each chord between the chord parameters ``low`` and ``high`` (0 … 1) is
    considered.
    """

    path: I64  #: (k,) path of the groove
    cut: I64  #: (k,) row of the cut in the dieline
    along: F64  #: (k, 2) mm along the groove, at both ends of the chord
    offset: F64  #: (k, 2) mm to the left of the groove, at both ends of the chord
    low: F64  #: (k,) parameter on the chord, 0 … 1
    high: F64  #: (k,) parameter on the chord, 0 … 1

    def select(self, rows: I64 | Bool) -> _NearbyChords:
        """Return only the pairs of groove and chord that ``rows`` selects.

        ``rows`` are the indices, or the mask, of these pairs.
        """
        return _NearbyChords(*(getattr(self, name)[rows] for name in self.__slots__))

    def clip(self, column: F64, least: F64 | float, greatest: F64 | float) -> _NearbyChords:
        """Return the pairs, each chord shortened to the part on which a coordinate is in a range.

        The range is ``least`` … ``greatest`` (mm), for all chords or for each one.  ``column`` is
        ``self.along`` or ``self.offset``: the coordinate at the two ends of each chord, (k, 2) mm.
        A pair is left out if its chord has no part in the range.  A range whose ``least`` exceeds
        ``greatest`` contains nothing.
        """
        first, step = column[:, 0], column[:, 1] - column[:, 0]
        level = np.abs(step) < 1e-12
        safe = np.where(level, 1.0, step)
        one, other = (least - first) / safe, (greatest - first) / safe
        inside = (first >= least) & (first <= greatest)
        low = np.where(level, np.where(inside, 0.0, 2.0), np.minimum(one, other))
        high = np.where(level, 1.0, np.maximum(one, other))
        low, high = np.maximum(self.low, low), np.minimum(self.high, high)
        rows = np.flatnonzero((low <= high) & (least <= greatest))
        cut = self.select(rows)
        return _NearbyChords(cut.path, cut.cut, cut.along, cut.offset, low[rows], high[rows])

    def at_ends(self, column: F64) -> F64:
        """Return a coordinate at the parameters ``low`` and ``high`` of each chord, (k, 2) mm.

        ``column`` has this coordinate at the two ends of each chord, (k, 2) mm: ``self.along`` or
        ``self.offset``.
        """
        fraction = np.stack([self.low, self.high], axis=1)
        result: F64 = column[:, :1] + (column[:, 1:] - column[:, :1]) * fraction
        return result


def check_flanks(
    paths: Paths, source: I32, reach: float, run_out: F64, dieline: Dieline, limit: float
) -> None:
    """Raise ``FlankOutside`` if a flank of a groove passes through a cut.

    Parameters
    ----------
    paths
        Straight grooves.
    source : (n,)
        Index in the dieline of the edge of each segment of the grooves, for error messages.
    reach : mm
        Distance of the flanks from the groove's line on the top face.
    run_out : (p, 2) mm
        Run-out of each of p grooves beyond its start and its end.
    dieline
        Dieline that contains the cuts.
    limit : mm
        Greatest shift of a groove away from a cut, for error messages.

    Raises
    ------
    FlankOutside
        The error names the groove, the cut, and by how much the flank passes the cut.
    """
    strip = _find_damage(paths, reach, run_out, dieline)
    if len(strip.path) == 0:
        return
    offset = strip.at_ends(strip.offset)
    nearest = np.where(offset[:, 0] * offset[:, 1] <= 0.0, 0.0, np.abs(offset).min(axis=1))
    worst = int(np.argmin(nearest))
    groove, cut = int(source[paths.first[strip.path[worst]]]), int(strip.cut[worst])
    position = strip.at_ends(strip.along)[worst].mean()
    excess = math.ceil(100.0 * (reach - nearest[worst]) - 1e-6) / 100.0
    at_line = nearest[worst] <= GAP
    allowed = {} if at_line else {"limit": limit}
    message = Message(
        "groove.through-cut-at-it" if at_line else "groove.through-cut",
        groove=groove,
        width=2.0 * reach,
        through=excess,
        cut=cut,
        distance=nearest[worst],
        place=position,
        **allowed,
    )
    raise FlankOutside(message, at_edges=(groove, cut))


def clearing_shifts(
    paths: Paths, reach: float, run_out: F64, dieline: Dieline, limit: float
) -> F64:
    """Return how far each of p grooves must move so that its flanks pass no cut, (p,) mm.

    The shift is positive to the left of the groove.  It is 0 if no shift is necessary or possible.
    No shift is possible if cuts lie on both sides or on the line of the groove, if the shift would
    be larger than ``limit`` (mm), or if the groove is not one straight line.  The other parameters
    are those of ``check_flanks``.
    """
    strip = _find_damage(paths, reach, run_out, dieline)
    offset = strip.at_ends(strip.offset)
    nearest = np.where(offset[:, 0] * offset[:, 1] <= 0.0, 0.0, np.abs(offset).min(axis=1))
    need = np.zeros((len(paths), 2))
    np.maximum.at(need, (strip.path, (offset.sum(axis=1) < 0.0).astype(np.int64)), reach - nearest)
    greatest = need.max(axis=1)
    possible = (need.min(axis=1) == 0.0) & (greatest <= min(limit + POINT, reach - GAP))
    possible &= (np.diff(paths.first) == 1) & (paths.bulge[paths.first[:-1]] == 0.0)
    # Away from a cut on the left means to the right.
    return np.where(possible, np.where(need[:, 0] > 0.0, -greatest, greatest), 0.0)


def damaging_paths(paths: Paths, reach: float, run_out: F64, dieline: Dieline) -> I64:
    """Return the indices of the grooves of which a flank passes through a cut, ascending.

    The parameters are those of ``check_flanks``.
    """
    return np.unique(_find_damage(paths, reach, run_out, dieline).path)


def _find_damage(paths: Paths, reach: float, run_out: F64, dieline: Dieline) -> _NearbyChords:
    """Return the parts of cuts through which flanks of straight grooves pass.

    A groove that ends on a cut, or runs out over a cut, crosses that cut with its flanks.  At such
    an end, a stretch of the groove is not checked.  The stretch is twice ``reach`` long, or as long
    as the run-out if the run-out is longer.  A cut that crosses the groove, or comes from outside
    and ends between its flanks, is permitted.  The parameters are those of ``check_flanks``.
    """
    begin, finish = paths.start[paths.first[:-1]], paths.end[paths.first[1:] - 1]
    length = np.hypot(*(finish - begin).T)
    nearby = _find_nearby_chords(begin, finish, reach, dieline)
    # Over a slanting edge, one flank leaves the board as far before the end as the other after it.
    inset = np.maximum(2.0 * reach, run_out * 1.001 + GAP) * _ends_on_cuts(
        nearby, length, reach, run_out
    )
    strip = nearby.clip(nearby.offset, POINT - reach, reach - POINT)
    path = strip.path
    strip = strip.clip(strip.along, inset[path, 0], (length - inset[:, 1])[path])
    return strip.select(~_crosses_flank(strip, reach))


def _find_nearby_chords(begin: F64, finish: F64, reach: float, dieline: Dieline) -> _NearbyChords:
    """Return the chords of the cuts near straight grooves, in coordinates along and across each
    groove.

    ``begin``, ``finish`` (p, 2) mm: start and end points of the grooves.
    ``reach`` mm: distance of the flanks from the groove's line; cuts farther away than this may be
    left out.
    """
    cuts = np.flatnonzero(dieline.line_type == LineType.CUT)
    ends, bulge = dieline.ends[cuts], dieline.bulge[cuts]
    ahead = unit_vectors(finish - begin)
    # A cut this far beyond an end still counts as the cut on which the groove ends.
    first, last = begin - 2.0 * reach * ahead, finish + 2.0 * reach * ahead
    boxes = np.hstack([np.minimum(first, last), np.maximum(first, last)])
    path, cut = box_pairs(boxes, arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge), reach)

    cut_curves = ends[cut, 0], ends[cut, 1], bulge[cut]
    bent = np.abs(bulge[cut]) >= BULGE
    radius = np.where(bent, arc.radius(*cut_curves), 1.0)
    widest = 2.0 * np.arccos(np.clip(1.0 - _CHORD / radius, 0.0, 1.0))
    pieces = np.where(bent, np.ceil(np.abs(arc.sweep(bulge[cut])) / widest), 1.0).astype(np.int64)
    pair = np.repeat(np.arange(len(cut)), pieces)
    piece = np.arange(len(pair)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    cut_curves = cut_curves[0][pair], cut_curves[1][pair], cut_curves[2][pair]
    sides = []
    for fraction in (piece / pieces[pair], (piece + 1) / pieces[pair]):
        from_begin = arc.point_at(*cut_curves, fraction) - begin[path[pair]]
        direction = ahead[path[pair]]
        sides.append(
            (
                (from_begin * direction).sum(axis=1),
                (from_begin * left_normal(direction)).sum(axis=1),
            )
        )
    along, offset = (np.stack(column, axis=1) for column in zip(*sides, strict=True))
    count = len(pair)
    return _NearbyChords(
        path[pair], cuts[cut[pair]], along, offset, np.zeros(count), np.ones(count)
    )


def _ends_on_cuts(nearby: _NearbyChords, length: F64, reach: float, run_out: F64) -> Bool:
    """Return the mask of the ends of p grooves near which a cut meets the groove's line, (p, 2).

    The line of a groove is continued beyond both ends.  Beyond an end, a cut is near this end up to
    a distance of twice ``reach`` (mm).  Inside the groove, it is near up to twice ``reach`` or up
    to the length of the run-out at this end, whichever is longer.  ``length`` is the length of each
    groove, (p,) mm; ``run_out`` is the run-out at each end, (p, 2) mm.
    """
    result = np.zeros((len(length), 2), np.bool_)
    on_line = nearby.clip(nearby.offset, -GAP, GAP)
    past = 2.0 * reach
    inside = np.maximum(past, run_out * 1.001 + GAP)
    begins = on_line.clip(on_line.along, -past, inside[on_line.path, 0])
    result[begins.path, 0] = True
    ends = on_line.clip(
        on_line.along, (length - inside[:, 1])[on_line.path], (length + past)[on_line.path]
    )
    result[ends.path, 1] = True
    return result


def _crosses_flank(strip: _NearbyChords, reach: float) -> Bool:
    """Return the mask of the chords whose cut crosses a flank of the groove, (k,).

    ``strip`` contains the parts of the cuts between the flanks, which lie at ``reach`` mm on both
    sides of the groove's line.  Such a part crosses a flank if it begins at the flank, or has
    points on both sides of the groove's line or within ``GAP`` of it, and if it extends across the
    groove at least as far as along the groove.  The panels beside such a cut lose no more of their
    top corner than at a groove that ends on the cut.
    """
    if len(strip.path) == 0:
        return np.zeros(0, np.bool_)
    pair, group = np.unique(np.stack([strip.path, strip.cut], axis=1), axis=0, return_inverse=True)
    group = group.reshape(-1)
    low, high = np.full((len(pair), 2), np.inf), np.full((len(pair), 2), -np.inf)
    for column, values in enumerate((strip.along, strip.offset)):
        ends = strip.at_ends(values)
        np.minimum.at(low[:, column], group, ends.min(axis=1))
        np.maximum.at(high[:, column], group, ends.max(axis=1))
    meets_line = (low[:, 1] <= GAP) & (high[:, 1] >= -GAP)
    flank = reach - 2.0 * POINT
    begins_outside = (low[:, 1] <= -flank) | (high[:, 1] >= flank)
    steep = high[:, 0] - low[:, 0] <= high[:, 1] - low[:, 1]
    result: Bool = ((meets_line | begins_outside) & steep)[group]
    return result
