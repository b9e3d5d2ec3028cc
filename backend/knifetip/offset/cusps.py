"""cusps: sharp corners of contours whose two segments cross again near the corner.

At a cusp a contour turns by nearly 180°.  If its two segments are curved, or if the drawing is
rounded, they may cross a second time a few hundredths of a millimetre before the corner.  The
contour then has a loop behind the crossing, and the two sides of the contour are swapped there, so
the offset has no path round the corner.

A loop that is thinner than the tolerance is straightened: from a point well before the crossing,
both segments are replaced by their chords to the corner, which cannot cross.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.intersect import intersect_pairs
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import POINT

#: Largest distance of a segment from the chord that replaces its end at a cusp (mm).
_MAX_DEVIATION: Final = 0.001
#: Length of the replaced ends, as a multiple of their lengths behind the crossing.
_CHORD_FACTOR: Final = 2.0


@dataclass(frozen=True, eq=False, slots=True)
class CuspLoops:
    """Corners of paths whose two segments cross again; m loops between crossing and corner."""

    before: I32  #: (m,) segment that ends at the corner
    after: I32  #: (m,) segment that starts at the corner
    crossing: F64  #: (m, 2) mm, the crossing nearest to the corner
    size: F64  #: (m,) mm, distance of the crossing from the corner
    tail: F64  #: (m,) part of ``before`` behind the crossing, as a fraction of its length
    head: F64  #: (m,) part of ``after`` before the crossing, as a fraction of its length


def find_cusp_loops(paths: Paths) -> CuspLoops:
    """Return the loops between neighbouring segments that cross near their common vertex.

    Neighbours that overlap, as where a contour runs back on itself, are returned too.
    """
    after: I32 = np.arange(1, len(paths.bulge) + 1, dtype=np.int32)
    after[paths.first[1:] - 1] = np.where(paths.closed, paths.first[:-1], -1)
    before = np.flatnonzero((after >= 0) & (after != np.arange(len(after)))).astype(np.int32)
    after = after[before]
    crossings = intersect_pairs(
        paths.start[before], paths.end[before], paths.bulge[before],
        paths.start[after], paths.end[after], paths.bulge[after],
    )  # fmt: skip
    away = np.hypot(*np.moveaxis(crossings.points - paths.end[before][:, None], 2, 0))
    # Both ends of a path of two segments are common vertices.
    other_end = (crossings.first <= 0.0) & (crossings.second >= 1.0)
    away = np.where((away > POINT) & ~other_end, away, np.inf)
    nearest = away.argmin(axis=1)
    rows = np.flatnonzero(np.isfinite(away.min(axis=1)))
    at = rows, nearest[rows]
    return CuspLoops(
        before[rows],
        after[rows],
        crossings.points[at],
        away[at],
        1.0 - crossings.first[at],
        crossings.second[at],
    )


def straighten_cusps(paths: Paths) -> tuple[Paths, I32]:
    """Return paths with straight ends of segments at cusps, instead of loops.

    Loops remain where a chord would deviate from its segment by more than ``_MAX_DEVIATION``, or
    would replace half of it.

    Returns
    -------
    paths : Paths
        Paths with n segments: the given ``paths``, with the two segments at each straightened cusp
        shortened, and two lines from their new ends to the corner.
    rows : (n,)
        For each returned segment, the segment of the given ``paths`` that it is a part of.
    """
    loops = find_cusp_loops(paths)
    tail, head = _CHORD_FACTOR * loops.tail, _CHORD_FACTOR * loops.head
    deviation = np.maximum(_sagitta(paths, loops.before, tail), _sagitta(paths, loops.after, head))
    straightened = (deviation <= _MAX_DEVIATION) & (np.maximum(tail, head) < 0.5)
    count = len(paths.bulge)
    own: I32 = np.arange(count, dtype=np.int32)
    low, high = np.zeros(count), np.ones(count)
    high[loops.before[straightened]] -= tail[straightened]
    low[loops.after[straightened]] = head[straightened]
    has_head, has_tail = low > 0.0, high < 1.0
    changed = np.flatnonzero(has_head | has_tail)
    start, end, bulge = paths.start.copy(), paths.end.copy(), paths.bulge.copy()
    start[changed], end[changed], bulge[changed] = arc.sub_arc(
        start[changed], end[changed], bulge[changed], low[changed], high[changed]
    )
    rows = np.concatenate([own[has_head], own, own[has_tail]])
    starts = np.concatenate([paths.start[has_head], start, end[has_tail]])
    ends = np.concatenate([start[has_head], end, paths.end[has_tail]])
    bulges = np.concatenate([np.zeros(has_head.sum()), bulge, np.zeros(has_tail.sum())])
    order = np.argsort(rows, kind="stable")
    rows = rows[order]
    first = np.searchsorted(rows, paths.first).astype(np.int32)
    return Paths(starts[order], ends[order], bulges[order], first), rows


def _sagitta(paths: Paths, row: I32, fraction: F64) -> F64:
    """Return the heights of parts of m segments above their chords, (m,) mm.

    ``row`` (m,) are the segments, and ``fraction`` (m,) are the lengths of the parts as fractions
    of the lengths of the segments.
    """
    start, end, bulge = paths.start[row], paths.end[row], paths.bulge[row]
    a, b, part = arc.sub_arc(start, end, bulge, np.zeros(len(row)), np.minimum(fraction, 1.0))
    height: F64 = 0.5 * np.abs(part) * np.hypot(*(b - a).T)
    return height
