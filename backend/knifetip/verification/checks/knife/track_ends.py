"""Check that a knife enters and leaves the board at the planned points at the ends of edges."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from knifetip.messages import Message
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.checks.common.context import NEAR_EDGE, PRINT_TURN
from knifetip.verification.checks.knife.closed_runs import (
    ALONG_EDGE,
    TrackEnds,
    closes_at_corner,
    closing_vertices,
    stops_at_own_corner,
)
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, point_at
from knifetip.verification.curves.group_order import order_in_groups
from knifetip.verification.curves.near_points import pair_distances
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    TOUCH_DISTANCE,
    Edges,
    angle_between,
    pairs_within,
)
from knifetip.verification.expectation.expected_work import KnifeEnds
from knifetip.verification.findings import MAX_FINDINGS


class _RunStops(NamedTuple):
    """Points at which the knife leaves the board after each of k runs, and the indices of the runs
    that leave it at a wrong point.

    A run is a chain of tracks, each of which begins where the previous track ended.  A track is a
    chain of tip paths between two lifts.
    """

    wrong: I64  #: indices of the runs to report
    work: I64  #: (k,) last tip path
    stop: F64  #: (k, 2) mm, where the knife leaves the board
    ahead: F64  #: (k,) degrees, direction of travel at the stop
    ring: F64  #: (k, 2) mm, planned stop of a closed run
    gap: F64  #: (k,) mm between ``stop`` and ``ring``
    planned: I64  #: (k,) nearest end of an edge, -1 for none
    distance: F64  #: (k,) mm to the planned stop of that end


def check_track_ends(
    check: StationCheck,
    solid_edges: Edges,
    solid_rows: I64,
    ends: KnifeEnds,
    dashed: Bool,
    overrun: float,
) -> F64:
    """Check where the knife enters and leaves the board; return the overrun of each of t tracks,
    (t,) mm.

    A track is a chain of tip paths between two lifts.  A run is a chain of tracks, each of which
    begins where the previous track ended, for example at a corner at which the lifted knife turns.
    An open run must begin at an end of an edge and stop at a planned stop.  A closed run must stop
    on its own path, ``overrun`` after its start, or at its start if that is a corner at which the
    knife is lifted.

    Parameters
    ----------
    check
        The check of the knife's station, to which findings and figures are added.
    solid_edges
        Edges that are cuts or half-cuts, without perforations.
    solid_rows
        Index of each edge of ``solid_edges`` among all edges of the check.
    ends
        Planned stops of the knife at the ends of the edges ``solid_edges``.
    dashed : (t,)
        Mask of the tracks that are cuts of perforations or cuts between bridges.
    overrun : mm
        Planned overrun of the tip past the start of a closed run.
    """
    count = len(dashed)
    over = np.zeros(count)
    if count == 0:
        return over
    last = np.cumsum(np.bincount(check.track, minlength=count)) - 1
    first = np.concatenate([[0], last[:-1] + 1])
    start = point_at(check.curve[first], np.zeros(count))
    stop = point_at(check.curve[last], check.curve[last, 5])
    ahead = azimuth_at(check.curve[last], check.curve[last, 5])
    outset = azimuth_at(check.curve[first], np.zeros(count))
    begun, begun_at = solid_edges.ends_touched_by(start)
    tracks = TrackEnds(
        start, stop, outset, ahead, *closing_vertices(check, solid_edges, count, begun, begun_at)
    )

    run_over, at_junction = _stops_on_cuts(check, ends, stop)
    new = np.ones(count, np.bool_)
    jump = np.hypot(*(start[1:] - stop[:-1]).T)
    # A new run may begin near the overrun of the previous one, but not at the same point.
    beside = JOIN_DISTANCE + PRINT_TURN + 2.0 * check.context.resolution
    new[1:] = jump > np.where(run_over[:-1], PRINT_TURN, beside)
    after = at_junction[begun - 1] & (begun > 0)
    along = _start_along_edges(
        solid_edges, check.curve[first[begun[after]]], begun_at[after], check.slack
    )
    goes_on = np.zeros(count, np.bool_)
    goes_on[begun[after][along]] = True
    new[1:] |= at_junction[:-1] & ~goes_on[1:]
    opens = np.flatnonzero(new)
    closes = np.concatenate([opens[1:], [count]]) - 1
    plain = ~dashed[opens]
    opens, closes = opens[plain], closes[plain]
    if len(opens) == 0:
        return over

    reached = np.cumsum(check.curve[:, 5])
    size = reached[last[closes]] - reached[first[opens]] + check.curve[first[opens], 5]
    # A closed run shorter than twice the overrun overruns by half of its length.
    ring = _points_along_runs(check, first[opens], last[closes], np.minimum(overrun, size / 2.0))
    gap = np.hypot(*(stop[closes] - ring).T)
    closed = gap <= check.slack
    closed |= closes_at_corner(check, solid_edges, tracks, opens, closes)

    planned, distance = _nearest_stops(ends, stop[closes], ahead[closes], closed, check.slack)
    right = (distance <= check.slack) & (~closed | (distance < gap))
    near = np.flatnonzero(right)
    right[near] = ~stops_at_own_corner(
        tracks, opens[near], closes[near], solid_edges, planned[near]
    )

    # Without a near end ``planned`` is -1, which selects the appended False.
    ran = right & np.append(ends.meets, False)[planned]
    over[closes[ran]] = ends.overrun[planned[ran]]
    check.record_overcut(solid_rows[planned[ran] // 2], ends.overrun[planned[ran]])
    short = right & np.append(ends.free, False)[planned]
    # Coincident cuts end at the same points.
    free = np.flatnonzero(ends.free & ~np.isnan(ends.stop[:, 0]))
    together = pairs_within(ends.stop[planned[short]], ends.stop[free], JOIN_DISTANCE)[1]
    left_out = _ends_of_left_out_stubs(
        ends, solid_edges, start, stop[closes[right]], ahead[closes[right]], check.slack
    )
    stops = np.unique(np.concatenate([free[together], left_out]))
    _record_setback(check, solid_edges, solid_rows, ends, stops)

    runs = _RunStops(
        np.flatnonzero(~closed & ~right), last[closes], stop[closes], ahead[closes], ring, gap,
        planned, distance,
    )  # fmt: skip
    _report_wrong_stops(check, solid_rows, ends, runs)

    at_end = np.zeros(count, np.bool_)
    at_end[begun] = True
    for k in np.flatnonzero(~at_end[opens] & ~closed & right)[:MAX_FINDINGS]:
        check.add_finding(
            "overcut",
            int(solid_rows[planned[k] // 2]),
            Message("verify.goes-in-anywhere"),
            0.0,
            int(first[opens[k]]),
        )
    return over


def _nearest_stops(
    ends: KnifeEnds, stop: F64, ahead: F64, closed: Bool, slack: float
) -> tuple[I64, F64]:
    """Return the end of an edge whose planned stop is nearest to the stop of each of k runs, (k,),
    and its distance, (k,) mm.

    Where several edges end at one point, the stop of the edge along which the run arrives counts.
    The result is -1 and infinite for a run without a planned stop within ``NEAR_EDGE``, and for a
    closed run without one within ``slack``.

    ``ends``: planned stops of the knife.
    ``stop``, ``ahead`` (k, 2) mm and (k,) degrees: points at which the runs stop, and their
    directions of travel there.
    ``closed`` (k,): mask of the runs that stop where they should as closed runs.
    ``slack`` mm: greatest distance of a right stop from the planned one.
    """
    planned = np.full(len(stop), -1, np.int64)
    distance = np.full(len(stop), np.inf)
    stop_rows = np.flatnonzero(~np.isnan(ends.stop[:, 0]))
    planned_stops = ends.stop[stop_rows]
    left = np.arange(len(stop))
    # Most runs stop near a planned stop, which a narrow search finds faster.
    for reach in (max(slack, TOUCH_DISTANCE), NEAR_EDGE):
        run, end = pairs_within(stop[left], planned_stops, reach)
        run, end = left[run], stop_rows[end]
        apart = pair_distances(stop, run, ends.stop, end)
        across = angle_between(ahead[run], ends.ahead[end]) > ALONG_EDGE
        order = order_in_groups(run, across.astype(np.float64), apart)
        run, nearest = np.unique(run[order], return_index=True)
        best = order[nearest]
        planned[run], distance[run] = end[best], apart[best]
        # Search wider for runs without a stop so near, or with one of an edge across them only.
        is_left = ~closed
        is_left[run] = across[best]
        left = left[is_left[left]]
    return planned, distance


def _stops_on_cuts(check: StationCheck, ends: KnifeEnds, stop: F64) -> tuple[Bool, Bool]:
    """Return which stops of the knife, (t, 2) mm, lie at the overrun of an end of a cut on another
    cut, and which lie at such an end without an overrun, (t,) each.
    """
    meets = np.flatnonzero(ends.meets)
    masks = np.zeros((2, len(stop)), np.bool_)
    track, end = pairs_within(stop, ends.stop[meets], check.tolerance)
    over = ends.overrun[meets[end]] > 0.0
    masks[0, track[over]] = True
    masks[1, track[~over]] = True
    return masks[0], masks[1]


def _ends_of_left_out_stubs(
    ends: KnifeEnds, edges: Edges, start: F64, stop: F64, ahead: F64, slack: float
) -> I64:
    """Return the free ends of the stubs before whose corner a run stops and on which none starts.

    ``start`` (t, 2) mm: points at which the knife enters the board.
    ``stop``, ``ahead`` (k, 2) mm and (k,) degrees: points at which runs stop, and their directions
    of travel there.
    ``slack`` mm: greatest distance of these points from the planned ones.
    """
    stubs = np.unique(ends.stub_end[ends.stub_end >= 0])
    run, stub = pairs_within(stop, ends.stop[stubs], slack)
    arrives = angle_between(ahead[run], ends.ahead[stubs[stub]]) <= ALONG_EDGE
    left_out = np.unique(stubs[stub[arrives]])
    made = pairs_within(start, edges.ends[left_out], slack)[1]
    return np.delete(left_out, made)


def _start_along_edges(edges: Edges, paths: F64, end: I64, tolerance: float) -> Bool:
    """Return the mask of the k tip paths that begin at an end of an edge and run along this edge,
    (k,).

    The curves are compared by their points at the same distance from that end, at most at the end
    of the shorter one.  Their directions may differ: the path may be a chord of the edge, and
    coarse coordinates turn a short line.

    ``paths``, ``end`` (k, 6) and (k,): curves of the tip paths, and the end of an edge at which
    each begins.
    ``tolerance`` mm: greatest distance of a path from the edge.
    """
    edge = edges.curve[end // 2]
    size = np.minimum(paths[:, 5], edge[:, 5])
    away = point_at(paths, size) - point_at(edge, np.where(end % 2 == 0, size, edge[:, 5] - size))
    result: Bool = np.hypot(*away.T) <= tolerance
    return result


def _report_wrong_stops(
    check: StationCheck, solid_rows: I64, ends: KnifeEnds, runs: _RunStops
) -> None:
    """Add a finding for each run of the knife that stops neither at a planned stop nor at its own
    start.

    The indices of these runs are ``runs.wrong``; ``ends`` contains the planned stops at the ends of
    edges.  ``solid_rows`` is the index of each of these edges among all edges of the check.
    """
    for k in runs.wrong[:MAX_FINDINGS]:
        work = int(runs.work[k])
        edge = int(solid_rows[runs.planned[k] // 2]) if runs.planned[k] >= 0 else -1
        # A closed run with a wrong stop is compared with its own planned stop if that is nearest.
        if runs.gap[k] < min(runs.distance[k], NEAR_EDGE):
            target, measure, edge = runs.ring[k], float(runs.gap[k]), -1
        elif runs.planned[k] >= 0:
            target, measure = ends.stop[runs.planned[k]], float(runs.distance[k])
        else:
            check.add_finding(
                "uncut",
                -1,
                Message("verify.comes-out-anywhere"),
                float(runs.gap[k]),
                work,
            )
            continue
        angle = math.radians(float(runs.ahead[k]))
        x, y = runs.stop[k] - target
        past = x * math.cos(angle) + y * math.sin(angle) > 0.0
        check.add_finding(
            "overcut" if past else "uncut",
            edge,
            Message(
                "verify.comes-out-past" if past else "verify.comes-out-short", distance=measure
            ),
            measure,
            work,
        )


def overrun_starts(check: StationCheck, over: F64) -> F64:
    """Return the position along each of n tip paths at which the overrun of its track begins, (n,)
    mm.

    A track is a chain of tip paths between two lifts, and its overrun may cover several tip paths.
    For a tip path that lies before the overrun, the position is the length of the path; for one
    inside the overrun, it is 0.  ``over`` is the length of the overrun at the end of each of t
    tracks, (t,) mm.
    """
    start = check.curve[:, 5].copy()
    track = np.flatnonzero(over > 0.0)
    path_rows = np.searchsorted(check.track, track, side="right") - 1
    left = over[track]
    while len(path_rows):
        size = start[path_rows].copy()
        start[path_rows] = np.maximum(size - left, 0.0)
        continues = (left > size) & (path_rows > 0)
        continues &= check.track[path_rows] == check.track[path_rows - 1]
        path_rows, left = path_rows[continues] - 1, (left - size)[continues]
    return start


def _points_along_runs(check: StationCheck, first: I64, last: I64, distance: F64) -> F64:
    """Return one point of each of k runs of the knife, (k, 2) mm.

    ``first`` and ``last`` are the indices of the first and last tip path of each run, (k,), and
    ``distance`` is the distance of the point from the start of the run along the run, (k,) mm.
    """
    path_rows, left = first.copy(), distance
    while True:
        size = check.curve[path_rows, 5]
        continues = (left > size) & (path_rows < last)
        if not continues.any():
            return point_at(check.curve[path_rows], np.minimum(left, size))
        left = np.where(continues, left - size, left)
        path_rows = np.where(continues, path_rows + 1, path_rows)


def _record_setback(
    check: StationCheck,
    solid_edges: Edges,
    solid_rows: I64,
    ends: KnifeEnds,
    free_ends: I64,
) -> None:
    """Move the limits of edges inwards by the setback of free ends, and record the setback.

    The limits of an edge are the points at which the tip may start and must stop.  A free end lies
    inside a panel; the tip stops before it, so that the cut in the top face ends there.  The
    setback of an edge is the length that lies outside its limits; a stub is not set back, but left
    out.

    ``check``: the check of the knife's station, whose limits and figures are changed.
    ``solid_edges``, ``solid_rows``: edges that are cuts or half-cuts, and the index of each among
    all edges of the check.
    ``ends``: planned stops of the knife at the ends of the edges ``solid_edges``.
    ``free_ends``: indices of the free ends: 2i is the start and 2i + 1 the end of edge i of
    ``solid_edges``.
    """
    paths = ends.paths
    path = paths.path[free_ends // 2]
    begin = np.zeros(len(paths.length))
    finish = paths.length.copy()
    at_last = paths.last[path] == free_ends
    finish[path[at_last]] -= ends.setback[free_ends[at_last]]
    begin[path[~at_last]] += ends.setback[free_ends[~at_last]]
    low, high = paths.intervals(begin, finish, solid_edges.curve)
    back = solid_edges.curve[:, 5] - np.maximum(high - low, 0.0)
    left_out = np.isin(ends.stub_end, free_ends)
    back[left_out], low[left_out], high[left_out] = 0.0, 0.0, -1.0
    check.figures.setback[solid_edges.row] += back
    check.low[solid_rows], check.high[solid_rows] = low, high
