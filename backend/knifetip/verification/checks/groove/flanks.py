"""Find cuts so near to a V-groove that a flank of the groove damages the cut edge of the board.

In the top face a groove is a strip on both sides of its line, bounded by its flanks.  A cut inside
the strip loses its sharp edge.  Two kinds of cuts are permitted inside the strip: a cut on which
the groove ends or over which it runs out, and a cut that crosses the groove or one flank of it
(see ``_nearest_points``).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import left_distance, line_curves, point_at
from knifetip.verification.curves.intervals import Overlaps
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import TOUCH_DISTANCE, Edges

#: Greatest distance between an arc and the chords that replace it (mm).
CHORD_ERROR: Final = 1e-3
#: Number of points at which a stretch of a cut is measured.
SAMPLE_COUNT: Final = 9


@dataclass(frozen=True, eq=False, slots=True)
class DamagedCuts:
    """k pairs of a groove and a cut that a flank of the groove damages."""

    groove: I64  #: (k,) index of the groove
    cut: I64  #: (k,) index of the cut
    place: F64  #: (k,) mm from the groove's start to the nearest point of the cut
    nearest: F64  #: (k,) mm, smallest distance of the cut from the groove's line
    on_left: Bool  #: (k,) whether the nearest point of the cut lies to the left of the groove


def damaged_cuts(grooves: Edges, cuts: Edges, reach: float, run_out: F64) -> DamagedCuts:
    """Return the pairs of a groove and a cut that lies inside the groove's strip in the top face.

    The strip covers ``reach`` on both sides of the groove's line.  A cut that meets this line near
    an end of the groove, for example a cut on which the groove ends, is permitted.  If a cut meets
    the line within a length L of an end, the strip is therefore shortened by L at that end.  L is
    twice ``reach`` or the run-out at that end, whichever is longer.

    Parameters
    ----------
    grooves, cuts
        The n V-grooves, and the cuts, as drawn.
    reach : mm
        Distance from a groove's line to its flanks in the top face.
    run_out : (n, 2) mm
        Required run-out of each groove past its start and past its end.
    """
    margin = 2.0 * reach
    strip, before = _lengthen(grooves.curve, margin)
    size, nothing = strip[:, 5], np.zeros(len(strip))
    drawn = size - 2.0 * before
    near = np.unique(find_overlaps(cuts.curve, strip, nothing, size, reach + CHORD_ERROR).curve)
    pieces, owner = _flatten(cuts.curve, near.astype(np.int64))

    zone = np.maximum(margin, 1.001 * run_out) + TOUCH_DISTANCE
    touches = find_overlaps(pieces, strip, nothing, size, TOUCH_DISTANCE)
    groove = touches.edge.astype(np.int64)
    low, high = np.sort(touches.place, axis=1).T
    met = np.zeros((len(strip), 2), np.bool_)
    met[groove[low - before[groove] <= zone[groove, 0]], 0] = True
    met[groove[high - before[groove] >= (drawn - zone[:, 1])[groove]], 1] = True

    begin = before + np.where(met[:, 0], zone[:, 0], 0.0)
    end = before + drawn - np.where(met[:, 1], zone[:, 1], 0.0)
    overlaps = find_overlaps(pieces, strip, begin, end, reach)
    if len(overlaps.curve) == 0:
        none = np.zeros(0, np.int64)
        return DamagedCuts(none, none, np.zeros(0), np.zeros(0), np.zeros(0, np.bool_))
    return _nearest_points(overlaps, pieces, strip, owner, before, reach)


def _nearest_points(
    overlaps: Overlaps, pieces: F64, strip: F64, owner: I64, before: F64, reach: float
) -> DamagedCuts:
    """Return the pairs of a groove and a cut inside its strip, with the nearest point of the cut.

    The strip is the part of the top face that the groove removes.  The returned point is the one
    nearest to the groove's line.  Pairs in which the cut crosses the groove, ends within
    ``TOUCH_DISTANCE`` of its line, or enters the strip through a flank, are left out if the cut
    extends across the groove at least as far as along it.  Lines and arcs are rows of six numbers
    (see ``curves.curve``).

    ``overlaps``: stretches of the chords ``pieces`` inside the strips; ``overlaps.edge`` are rows
    of ``strip``.
    ``pieces``, ``owner`` (p, 6), (p,): p chords of cuts, and the index of the cut of each chord.
    ``strip``, ``before`` (n, 6), (n,): the lines or arcs of n grooves, lengthened at both ends, and
    the length that was added at the start of each (mm).
    ``reach`` mm: distance of the flanks from the groove's line.
    """
    fraction = np.linspace(0.0, 1.0, SAMPLE_COUNT)
    offset = np.stack(
        [
            left_distance(
                pieces[overlaps.curve], overlaps.along @ (1.0 - s, s), strip[overlaps.edge]
            )
            for s in fraction
        ],
        axis=1,
    )
    place = overlaps.place[:, :1] * (1.0 - fraction) + overlaps.place[:, 1:] * fraction
    pair, group = np.unique(
        np.stack([overlaps.edge.astype(np.int64), owner[overlaps.curve]], axis=1),
        axis=0,
        return_inverse=True,
    )
    group = group.reshape(-1)
    left, right = _group_extremes(offset, group, len(pair))
    first, last = _group_extremes(place, group, len(pair))
    crosses = (left <= TOUCH_DISTANCE) & (right >= -TOUCH_DISTANCE)
    crosses |= np.maximum(-left, right) >= reach - CHORD_ERROR
    across: Bool = crosses & (last - first <= right - left)
    # A cut with points on both sides of the line touches the line.
    least = np.abs(offset).min(axis=1)
    least[(offset.min(axis=1) <= 0.0) & (offset.max(axis=1) >= 0.0)] = 0.0
    order = np.lexsort((least, group))
    best = order[np.unique(group[order], return_index=True)[1]][~across]
    pair = pair[~across]
    column = np.argmin(np.abs(offset[best]), axis=1)
    position = place[best, column] - before[pair[:, 0]]
    return DamagedCuts(pair[:, 0], pair[:, 1], position, least[best], offset[best, column] > 0.0)


def clearing_shifts(damaged: DamagedCuts, count: int, reach: float, limit: float) -> F64:
    """Return how far each of ``count`` grooves must move to the left to clear cuts, (count,) mm.

    A negative shift is to the right.  The shift is 0 if the groove needs none, if cuts lie on both
    sides or on its line, or if the shift would be larger than ``limit`` (mm).

    Parameters
    ----------
    damaged
        Pairs of a groove and a cut inside the strip of the groove in the top face.
    reach : mm
        Distance from a groove's line to its flanks in the top face.
    """
    left, right = np.zeros(count), np.zeros(count)
    excess = reach - damaged.nearest
    np.maximum.at(left, damaged.groove[damaged.on_left], excess[damaged.on_left])
    np.maximum.at(right, damaged.groove[~damaged.on_left], excess[~damaged.on_left])
    least, most = np.minimum(left, right), np.maximum(left, right)
    possible = (least == 0.0) & (most <= min(limit + CHORD_ERROR, reach - TOUCH_DISTANCE))
    result: F64 = np.where(possible, right - left, 0.0)
    return result


def _group_extremes(values: F64, group: I64, count: int) -> tuple[F64, F64]:
    """Return the least and the greatest of all values in each of ``count`` groups, (count,) each.

    A group is a set of rows of ``values``, (k, j); ``group`` is the index of the group of each of
    the k rows, (k,).  A group without rows gets the least value inf and the greatest value -inf.
    """
    low, high = np.full(count, np.inf), np.full(count, -np.inf)
    np.minimum.at(low, group, values.min(axis=1))
    np.maximum.at(high, group, values.max(axis=1))
    return low, high


def _lengthen(curve: F64, extra: float) -> tuple[F64, F64]:
    """Return n lines and arcs lengthened at both ends, (n, 6), and the added length, (n,) mm.

    ``curve`` contains the lines and arcs as rows of six numbers (see ``curves.curve``), (n, 6).
    The length added at each end is ``extra`` (mm), or less for an arc that would become a full
    circle.
    """
    result = curve.copy()
    straight = curve[:, 0] == 0.0
    radius = np.where(straight, 1.0, curve[:, 3])
    rest = np.maximum(2.0 * math.pi * radius - curve[:, 5], 0.0)
    more = np.where(straight, extra, np.minimum(extra, 0.49 * rest))
    result[straight, 1:3] -= more[straight, None] * curve[straight, 3:5]
    result[~straight, 4] -= (curve[:, 0] * more / radius)[~straight]
    result[:, 5] += 2.0 * more
    return result, more


def _flatten(curves: F64, rows: I64) -> tuple[F64, I64]:
    """Return k chords that replace selected lines and arcs, (k, 6), and their origins, (k,).

    ``curves`` contains lines and arcs as rows of six numbers (see ``curves.curve``), and ``rows``
    the indices of the selected ones.  The chords are rows of six numbers too.  The origin of a
    chord is the index in ``curves`` of the line or arc that it replaces.
    """
    curve = curves[rows]
    round_ = curve[:, 0] != 0.0
    radius = np.where(round_, curve[:, 3], 1.0)
    step = 2.0 * radius * np.arccos(np.clip(1.0 - CHORD_ERROR / radius, 0.0, 1.0))
    many = np.where(round_, np.ceil(curve[:, 5] / step), 1.0).astype(np.int64)
    owner = np.repeat(np.arange(len(curve)), many)
    part = np.arange(len(owner)) - np.repeat(np.cumsum(many) - many, many)
    each = (curve[:, 5] / many)[owner]
    start, end = (point_at(curve[owner], each * at) for at in (part, part + 1))
    return line_curves(start, end), rows[owner]
