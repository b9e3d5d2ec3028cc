"""Find the areas of waste beside cuts that a cutter's disc cannot reach.

Each area is bounded by a loop of lines and arcs.  The loop follows a stretch of an edge that the
disc has not touched, with the waste on its left.  At the end of that stretch the disc touches the
edge, or is stopped between two corners.  From there the loop follows the disc's rim clockwise to
the start of the next stretch.  In a concave corner that turns by φ, a disc of radius r leaves the
area r² (tan φ/2 - φ/2).

The formula was derived for knifetip.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from knifetip.kernels import I64_1, kernel
from knifetip.model.verdict import UnreachedAreas
from knifetip.verification.columns import F64, I64
from knifetip.verification.curves.curve import azimuth_at, point_at
from knifetip.verification.expectation.edges import JOIN_DISTANCE, pairs_within
from knifetip.verification.expectation.outline import CutOutlines

#: Smaller areas are left out (mm²).
MIN_AREA: Final = 1e-3
#: Tolerance added to the disc's diameter in the search for the next stretch (mm).
_EXTRA_DISTANCE: Final = 0.05
#: A point within this fraction of the radius from the disc's rim is on the rim.
_RIM_TOLERANCE: Final = 0.1


def unreached_areas(
    bounds: CutOutlines, edge: I64, begin: F64, end: F64, reach: F64
) -> UnreachedAreas:
    """Return the areas of waste between untouched stretches of cuts and the disc, in sheet
    coordinates.

    Parameters
    ----------
    bounds
        Outlines that the cuts form.
    edge, begin, end : (k,)
        Index of the cut of each of k stretches that the disc does not touch, and the start and end
        of the stretch along the cut (mm).
    reach : (2,) mm
        Half-axes along X and Y of the disc within which the cutter removes board.
    """
    edges = bounds.edges
    long = bounds.closing[edge] & (end - begin > JOIN_DISTANCE)
    edge, begin, end = edge[long], begin[long], end[long]
    if len(edge) == 0 or reach.min() <= 0.0:
        return UnreachedAreas()
    forward = ~bounds.board_left[edge]
    curve = edges.curve[edge]
    start = point_at(curve, np.where(forward, begin, end))
    stop = point_at(curve, np.where(forward, end, begin))
    straight = curve[:, 0] == 0.0
    sweep = curve[:, 0] * (end - begin) / np.where(straight, 1.0, curve[:, 3])
    bulge = np.where(straight, 0.0, np.tan(sweep / 4.0)) * np.where(forward, 1.0, -1.0)
    heading = np.radians(azimuth_at(curve, np.where(forward, end, begin)))
    heading = np.where(forward, heading, heading + np.pi)
    ahead = np.stack([np.cos(heading), np.sin(heading)], axis=1)
    left = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)

    count = len(edge)
    onward = np.full(count, -1)
    tail, head = pairs_within(stop, start, JOIN_DISTANCE)
    onward[tail[tail != head]] = head[tail != head]
    tails = np.flatnonzero(onward < 0)
    heads = np.setdiff1d(np.arange(count), onward)
    backs = _following_stretches(
        stop[tails], ahead[tails], left[tails] * reach, start[heads], reach
    )
    rows = np.flatnonzero(backs >= 0)
    # The arcs along the disc follow the stretches in the arrays.
    onward[tails[rows]] = count + np.arange(len(rows))
    met = heads[backs[rows]]
    chord = start[met] - stop[tails[rows]]
    half = np.clip(np.hypot(*chord.T) / (2.0 * float(reach.mean())), 0.0, 1.0)
    ends = np.concatenate(
        [np.stack([start, stop], axis=1), np.stack([stop[tails[rows]], start[met]], axis=1)]
    )
    turned = np.concatenate([bulge, -np.tan(np.arcsin(half) / 2.0)])
    order, first = _trace_loops(np.concatenate([onward, met]).astype(np.int64))
    return _enclosing_loops(ends[order], turned[order], first)


def _following_stretches(stop: F64, ahead: F64, inward: F64, start: F64, reach: F64) -> I64:
    """Return, for each of t chains of untouched stretches, the index of the chain that follows it.

    The disc that touches the end of a chain also touches the start of the following chain.  The
    result is (t,), -1 for a chain that no chain follows.

    ``stop``, ``ahead`` (t, 2): end of each chain (mm), and the unit direction of the chain there.
    ``inward`` (t, 2) mm: vector from the end of the chain to the centre of the disc that touches
    the edge there.
    ``start`` (h, 2) mm: starts of the h chains that may follow; the result contains indices of
    these.
    ``reach`` (2,) mm: half-axes of the disc along X and Y.
    """
    result = np.full(len(stop), -1)
    widest = 2.0 * float(reach.max()) + _EXTRA_DISTANCE
    tail, head = pairs_within(stop, start, widest)
    to = start[head] - stop[tail]
    # The unreached area lies on the left.
    side = ahead[tail, 0] * to[:, 1] - ahead[tail, 1] * to[:, 0]
    candidates = (side > -_EXTRA_DISTANCE) & (np.hypot(*to.T) <= widest)
    tail, head, to = tail[candidates], head[candidates], to[candidates]
    # Prefer a chain that starts on the rim of the disc that touches here.  A disc between two
    # corners touches no edge; then take the nearest start.
    error = np.abs(np.hypot(*((to - inward[tail]) / reach).T) - 1.0)
    order = np.lexsort((np.where(error < _RIM_TOLERANCE, error, 1.0 + np.hypot(*to.T)), tail))
    tail, head = tail[order], head[order]
    once = np.ones(len(tail), np.bool_)
    once[1:] = tail[1:] != tail[:-1]
    result[tail[once]] = head[once]
    # Drop starts that two ends claim.
    taken = result[result >= 0]
    twice = np.flatnonzero(np.bincount(taken, minlength=len(start)) > 1)
    result[np.isin(result, twice)] = -1
    return result


@kernel
def _trace_loops(onward: I64_1) -> Any:
    """Return the indices of the lines and arcs of all l closed loops, loop by loop, and the
    position in that array at which each loop begins, (l + 1,).

    The last position is the length of the array.  ``onward`` is the index of the line or arc that
    follows each of n lines and arcs, (n,), -1 for none.  Chains that do not close are left out.
    """
    count = len(onward)
    order = np.empty(count, np.int64)
    first = np.zeros(count + 1, np.int64)
    visited = np.zeros(count, np.bool_)
    place = 0
    loops = 0
    for begin in range(count):
        if visited[begin]:
            continue
        row = begin
        stood = place
        while row >= 0 and not visited[row]:
            visited[row] = True
            order[place] = row
            place += 1
            row = onward[row]
        if row != begin:
            place = stood
            continue
        loops += 1
        first[loops] = place
    return order[:place], first[: loops + 1]


def _enclosing_loops(ends: F64, bulge: F64, first: I64) -> UnreachedAreas:
    """Return the loops that enclose more than ``MIN_AREA``, and the area that each encloses (mm²).

    A clockwise loop is the outline of a part inside an unreached area.  It is joined to the loop
    around it by two lines on one another, and its area is subtracted.

    ``ends``, ``bulge`` (n, 2, 2) mm and (n,): start and end points of the n lines and arcs of all
    loops, loop by loop, and their bulges.
    ``first`` (l + 1,): index of the first line or arc of each of l loops, followed by n.
    """
    if len(first) < 2:
        return UnreachedAreas()
    owner = np.repeat(np.arange(len(first) - 1), np.diff(first))
    origin = ends[first[:-1], 0][owner]
    a, b = ends[:, 0] - origin, ends[:, 1] - origin
    sweep = 4.0 * np.arctan(bulge)
    chord = np.hypot(*(b - a).T)
    bent = np.abs(bulge) > 1e-12
    radius = np.where(bent, chord / (2.0 * np.sin(np.where(bent, sweep, 1.0) / 2.0)), 0.0)
    twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] + radius**2 * (sweep - np.sin(sweep))
    area = np.bincount(owner, twice, minlength=len(first) - 1) / 2.0
    loops = {
        loop: (ends[first[loop] : first[loop + 1]], bulge[first[loop] : first[loop + 1]])
        for loop in np.flatnonzero(area > MIN_AREA).tolist()
    }
    for inner in np.flatnonzero(area < -MIN_AREA).tolist():
        rows = slice(first[inner], first[inner + 1])
        around = [loop for loop in loops if _encloses(loops[loop][0], ends[first[inner], 0])]
        if around:
            outer = min(around, key=lambda loop: area[loop])
            loops[outer] = _join_loops(loops[outer], (ends[rows], bulge[rows]))
            area[outer] += area[inner]
    if not loops:
        return UnreachedAreas()
    sizes = [len(loop[1]) for loop in loops.values()]
    return UnreachedAreas(
        np.concatenate([loop[0] for loop in loops.values()]),
        np.concatenate([loop[1] for loop in loops.values()]),
        np.concatenate([[0], np.cumsum(sizes)]),
        area[list(loops)],
    )


def _encloses(ends: F64, point: F64) -> bool:
    """Return whether a loop encloses a point.

    ``ends`` (n, 2, 2) are the starts and ends of the lines and arcs of the loop; arcs count as
    lines.
    """
    (x0, y0), (x1, y1) = (ends[:, side].T - point[:, None] for side in (0, 1))
    crossed = (y0 > 0.0) != (y1 > 0.0)
    beyond = x0 - y0 * (x1 - x0) / np.where(crossed, y1 - y0, 1.0) > 0.0
    return bool(np.count_nonzero(crossed & beyond) % 2)


def _join_loops(outer: tuple[F64, F64], inner: tuple[F64, F64]) -> tuple[F64, F64]:
    """Return one loop along two loops, with a line between their nearest vertices and back.

    Each loop consists of the starts and ends (n, 2, 2) and the bulges (n,) of its lines and arcs.
    """
    apart = np.hypot(*(outer[0][:, None, 0] - inner[0][None, :, 0]).transpose(2, 0, 1))
    one, other = np.unravel_index(int(apart.argmin()), apart.shape)
    starts = outer[0][one, 0], inner[0][other, 0]
    return (
        np.concatenate(
            [
                np.roll(outer[0], -one, axis=0),
                np.stack(starts)[None],
                np.roll(inner[0], -other, axis=0),
                np.stack(starts[::-1])[None],
            ]
        ),
        np.concatenate([np.roll(outer[1], -one), [0.0], np.roll(inner[1], -other), [0.0]]),
    )


def merge_unreached(
    parts: Sequence[UnreachedAreas], placement: tuple[float, float]
) -> UnreachedAreas:
    """Return one list of all areas of waste that the cutters of a machine cannot reach.

    The areas in ``parts``, one record for each cutter, are in sheet coordinates.  The returned
    areas are in drawing coordinates: the offset ``placement`` (x, y) mm from drawing to sheet is
    subtracted.  The areas are listed one after the other; areas that overlap are not united.
    """
    if not parts:
        return UnreachedAreas()
    pieces = np.cumsum([0] + [len(part.bulge) for part in parts])
    return UnreachedAreas(
        np.concatenate([part.ends for part in parts]) - np.array(placement),
        np.concatenate([part.bulge for part in parts]),
        np.concatenate(
            [
                [0],
                *(part.first[1:] + offset for part, offset in zip(parts, pieces[:-1], strict=True)),
            ]
        ),
        np.concatenate([part.area for part in parts]),
    )
