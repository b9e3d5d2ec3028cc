"""Find the runs of a knife that close a path at a corner, where no overrun is needed.

A run is a chain of tracks of the tip, each of which begins where the previous one ended; a track is
a chain of tip paths between two lifts.  At a corner sharper than the knife's swivel angle the knife
is lifted and turned.  Both faces are cut as far as the corner from both sides, so a closed path may
also start and end there.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.model.tool import Knife
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.near_points import pair_distances
from knifetip.verification.expectation.edge_paths import count_joined_ends, turns_at_ends
from knifetip.verification.expectation.edges import (
    TOUCH_DISTANCE,
    Edges,
    angle_between,
    pairs_within,
)

#: Greatest error of the angle between two tip paths with rounded coordinates (degrees).
_ANGLE_ERROR: Final = 1.0
#: Greatest angle between a tip path, which may be a chord, and the edge along which it runs
#: (degrees).
ALONG_EDGE: Final = 15.0


class TrackEnds(NamedTuple):
    """The points at which a knife enters and leaves the board on each of t tracks."""

    start: F64  #: (t, 2) mm
    stop: F64  #: (t, 2) mm
    outset: F64  #: (t,) degrees, direction of travel at the start
    ahead: F64  #: (t,) degrees, direction of travel at the stop
    corner: Bool  #: (t,) the track begins at a vertex at which a path may be closed
    plain: Bool  #: (t,) the track begins at a vertex at which exactly two edges meet


def closing_vertices(
    check: StationCheck, edges: Edges, count: int, track: I64, end: I64
) -> tuple[Bool, Bool]:
    """Return the tracks that begin at a vertex at which a path may be closed, (t,), and those of
    them at whose vertex exactly two edges meet, (t,).

    A path may be closed at every vertex of at least two edges, even if more edges end there.

    Parameters
    ----------
    check
        The check of the knife's station.
    edges
        Edges that are cuts or half-cuts, without perforations.
    count
        Number of tracks, t.
    track, end : (k,)
        The k pairs of a track and an end of an edge at which it begins.
    """
    masks = np.zeros((2, count), np.bool_)
    if check.tool(Knife) is not None:
        others = count_joined_ends(edges)[end]
        masks[0, track[others > 0]] = True
        masks[1, track[others == 1]] = True
    return masks[0], masks[1]


def closes_at_corner(
    check: StationCheck, edges: Edges, tracks: TrackEnds, first: I64, last: I64
) -> Bool:
    """Return the mask of the k runs that end at a corner at which one of their tracks starts, (k,).

    A run that begins with an open cut may close the path that follows, so each track is compared.

    Parameters
    ----------
    check
        The check of the knife's station.
    edges
        Edges that are cuts or half-cuts, without perforations.
    first, last : (k,)
        First and last track of each run.
    """
    blade = check.tool(Knife)
    swivel = 180.0
    if blade:
        swivel = 360.0 if blade.free else blade.swivel
    result = np.zeros(len(first), np.bool_)
    run, track = pairs_within(tracks.stop[last], tracks.start, check.slack)
    closes = (track >= first[run]) & (track <= last[run]) & tracks.corner[track]
    run, track = run[closes], track[closes]
    stop = tracks.stop[last[run]]
    at_stop = edges.ends_touched_by(stop)
    arrival = _drawn_direction(edges, at_stop, tracks.ahead[last[run]])
    at_start = edges.ends_touched_by(tracks.start[track])
    outset = _drawn_direction(edges, at_start, tracks.outset[track] + 180.0) - 180.0
    turn = np.maximum(
        angle_between(arrival, outset),
        _drawn_turn(edges, stop, at_stop, check.context.resolution),
    )
    # A run that only returns along its own tracks closes nothing, although it ends where one began.
    encloses = (track == first[run]) | (turn < 180.0 - _ANGLE_ERROR)
    result[run[(turn > swivel - _ANGLE_ERROR) & encloses]] = True
    return result


def _drawn_turn(edges: Edges, point: F64, touched: tuple[I64, I64], shift: float) -> F64:
    """Return the greatest turn of two edges at a vertex within ``shift`` mm of each of k points,
    (k,) degrees; 0 for none.

    Coarse coordinates turn short tip paths, and contract the shortest edges to points, so the
    directions of the tip paths do not show every corner.

    ``point`` (k, 2) mm: ends of tip paths.
    ``touched``: the pairs of one of these points and an end that it touches.
    ``shift`` mm: greatest shift of a printed point by rounding.
    """
    row, end = touched
    near = pair_distances(point, row, edges.ends, end) <= shift
    result = np.zeros(len(point))
    np.maximum.at(result, row[near], turns_at_ends(edges)[end[near]])
    return result


def _drawn_direction(edges: Edges, touched: tuple[I64, I64], outward: F64) -> F64:
    """Return the direction out of the edge that ends at the end of each of k tip paths, (k,)
    degrees.

    A tip path that is a chord of an arc has another direction than the arc.  If several edges end
    there, the direction nearest to that of the tip path counts; if there is none within
    ``ALONG_EDGE``, the direction of the tip path.

    ``touched``: the pairs of the end of a tip path and an end of an edge that it touches.
    ``outward`` (k,) degrees: directions out of the tip paths at their ends.
    """
    row, end = touched
    error = angle_between(edges.outward[end], outward[row])
    order = np.lexsort((error, row))
    order = order[error[order] <= ALONG_EDGE]
    row, nearest = np.unique(row[order], return_index=True)
    result = outward.copy()
    result[row] = edges.outward[end[order[nearest]]]
    return result


def stops_at_own_corner(tracks: TrackEnds, first: I64, last: I64, edges: Edges, end: I64) -> Bool:
    """Return the mask of the k runs that end beside a vertex of two edges at which one of their own
    tracks begins, (k,).

    Such a run closes a path or returns along it, so it must not stop where an open path that ends
    there would stop.  Edges may be shorter than the distance within which their ends touch.  If no
    edge continues the run's last edge, a track that begins at the other end of that edge begins at
    another vertex; if several edges continue it, the run ends at their junction.

    Parameters
    ----------
    first, last : (k,)
        First and last track of each run.
    edges
        Edges that are cuts or half-cuts, without perforations.
    end : (k,)
        End of the edge at whose planned stop each run ends.
    """
    result = np.zeros(len(first), np.bool_)
    run, track = pairs_within(edges.ends[end], tracks.start, TOUCH_DISTANCE)
    own = (track >= first[run]) & (track <= last[run]) & tracks.plain[track]
    run, track = run[own], track[own]
    to_stop, to_start = (
        pair_distances(tracks.start, track, edges.ends, side[run]) for side in (end, end ^ 1)
    )
    others = count_joined_ends(edges)[end[run]]
    result[run[(others == 1) | ((others == 0) & (to_stop <= to_start))]] = True
    return result
