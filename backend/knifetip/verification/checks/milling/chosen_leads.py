"""Check that the cutter enters contours along the chosen lead-ins.

A cutter of radius r with a lead-in of length L at the angle φ to the contour moves straight from
the waste to its path beside the contour: by √(L² + r² − 2 L r sin φ) for φ ≥ 0.  For φ < 0 it moves
by L and then round a corner; where no corner has room, it comes perpendicular to the contour, by
L − r.  A lead-in without room is half as long, or left out.

Whether there is room is computed from the program and the drawing: the straight move is continued
backwards to its full length, and no cut may be nearer to it than the disc needs.  A contour that is
entered without a lead-in gets the move that it should have.  The last eighth of the move is left
out, since the disc touches the contour at its end, and the rest of it keeps √(r² + (s/16)²) from
cuts, where s is the length of the move: so much a compiler needs that looks at eight points.  A
move round a corner keeps r; which corner it could have used is not computed, and a move at -90°
runs beside the contour and counts as a part of it.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.job_options import ContourLead
from knifetip.model.machine import Station
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.common.followed_edges import follow_edges
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, point_at
from knifetip.verification.curves.point_distance import distance_from_curves
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import expected_tool

#: Parts of a straight move at which its distance from cuts is measured, from its end.
_MEASURED: Final = np.linspace(0.125, 1.0, 113)
#: A compiler may measure the distance at this many points of a move.
_COARSEST: Final = 8


def check_chosen_leads(context: CheckContext, paths: TipPaths) -> None:
    """Add a finding for each contour that is entered on another lead-in than the chosen one.

    ``paths`` are the tip paths of all programs of the sheet, with all passes.
    """
    if ContourLead not in context.chosen:
        return
    for index in np.unique(paths.station).tolist():
        station = context.machine.stations[index]
        if expected_tool(station.tool).disc is not None:
            _check_station(context, station, paths.select(paths.station == index))


def longest_chosen_lead(context: CheckContext) -> float:
    """Return the greatest length that is chosen for a lead-in (mm); 0 if there is none."""
    if ContourLead not in context.chosen:
        return 0.0
    return float(context.chosen[ContourLead].numbers("length", 0.0).max(initial=0.0))


def _check_station(context: CheckContext, station: Station, own: TipPaths) -> None:
    """Add a finding for each track of a cutter with another lead-in than the chosen one.

    ``own`` are the paths of the cutter's centre.
    """
    chosen = context.chosen[ContourLead]
    edges = context.edges.with_types(LineType.CUT)
    near = follow_edges(context, edges, station, own)
    size = np.diff(near.along)[:, 0]
    along = near.best & (size > 0.5 * own.curve[near.curve, 5])
    path, edge = near.curve[along], edges.row[near.edge[along]]
    is_chosen = chosen.index[edge] >= 0
    track, first_edge = np.unique(own.track[path[is_chosen]], return_index=True)
    start_of, start = np.unique(own.track, return_index=True)
    first, row = start[np.searchsorted(start_of, track)], edge[is_chosen][first_edge]
    # A track that begins beside the contour has no lead-in.
    entered = ~np.isin(first, path)
    _check_lead_ins(context, station, own, first[entered], row[entered])
    _check_bare_contours(context, station, own, first[~entered], row[~entered])


def _check_lead_ins(
    context: CheckContext, station: Station, own: TipPaths, first: I64, row: I32
) -> None:
    """Add a finding for each of m lead-ins that is no chosen one, or half as long without need.

    ``first`` (m,): first path of each track; ``row`` (m,): an edge of its contour.
    """
    limit = context.tolerance + 2.0 * context.resolution
    lengths = _possible_lengths(context, station, row)
    found = own.curve[first, 5]
    difference = np.abs(lengths - found)
    wrong = difference.min(axis=0, initial=math.inf) > limit
    for k in np.flatnonzero(wrong)[:MAX_FINDINGS]:
        _add_finding(context, "verify.other-lead", own, first[k], row[k], lengths[0, k], found[k])
    half = np.flatnonzero(~wrong & (difference[[0, 2]].min(axis=0, initial=math.inf) > limit))
    entry = own.curve[first[half]]
    back = np.radians(azimuth_at(entry, np.zeros(len(half))) + 180.0)
    away = 2.0 * entry[:, 5:] * np.column_stack([np.cos(back), np.sin(back)])
    _, angle = _chosen_values(context, station, row)
    goes_round = (angle[half] < 0.0) & (difference[1, half] <= limit)
    needed = _needed_distances(context, station, 2.0 * entry[:, 5], goes_round)
    roomy = half[_have_room(context, point_at(entry, entry[:, 5]), away, needed)]
    for k in roomy[:MAX_FINDINGS]:
        _add_finding(context, "verify.short-lead", own, first[k], row[k], 2.0 * found[k], found[k])


def _check_bare_contours(
    context: CheckContext, station: Station, own: TipPaths, first: I64, row: I32
) -> None:
    """Add a finding for each of m closed contours without a lead-in that has room for one.

    ``first`` (m,): first path of each track, beside the contour; ``row`` (m,): an edge of it.
    """
    disc = expected_tool(station.tool).disc
    assert disc is not None
    r, limit = disc.radius, context.tolerance + 2.0 * context.resolution
    cuts = context.edges.with_types(LineType.CUT).curve
    length, angle = _chosen_values(context, station, row)
    begin = point_at(own.curve[first], np.zeros(len(first)))
    heading = np.radians(azimuth_at(own.curve[first], np.zeros(len(first))))
    ahead = np.column_stack([np.cos(heading), np.sin(heading)])
    left = np.column_stack([-ahead[:, 1], ahead[:, 0]])
    # The contour is on the side on which the disc touches it.
    gaps = np.stack([distance_from_curves(begin + side * r * left, cuts) for side in (1.0, -1.0)])
    side = np.where(gaps[0] < gaps[1], 1.0, -1.0)
    # Pieces between bridges have no leads, and neither has a slit that is cut on its line.
    bare = _are_closed(own, first, begin, limit) & (gaps.min(axis=0, initial=math.inf) <= limit)
    bare &= (distance_from_curves(begin, cuts) > 0.5 * r) & (angle >= 0.0) & (length > r)
    normal = -side[:, None] * left
    direction = np.cos(angle)[:, None] * ahead - np.sin(angle)[:, None] * normal
    away = -r * normal - length[:, None] * direction
    wanted = np.flatnonzero(bare)
    full = np.hypot(*away.T)
    needed = _needed_distances(context, station, full[wanted], np.zeros(len(wanted), np.bool_))
    roomy = wanted[_have_room(context, begin[wanted], away[wanted], needed)]
    for k in roomy[:MAX_FINDINGS]:
        _add_finding(context, "verify.short-lead", own, first[k], row[k], full[k], 0.0)


def _are_closed(own: TipPaths, first: I64, begin: F64, limit: float) -> Bool:
    """Return whether a path of each of m tracks returns to its start, (m,).

    ``begin`` (m, 2) mm are the starts of the tracks, which begin with the paths ``first`` (m,).
    """
    rank = np.full(int(own.track.max(initial=0)) + 1, -1)
    rank[own.track[first]] = np.arange(len(first))
    of = rank[own.track]
    rows = np.flatnonzero(of >= 0)
    _, end = own.select(of >= 0).ends()
    back = np.hypot(*(end - begin[of[rows]]).T) <= limit
    closed: Bool = np.bincount(of[rows][back], minlength=len(first)) > 0
    return closed


def _needed_distances(context: CheckContext, station: Station, size: F64, goes_round: Bool) -> F64:
    """Return the distance that the centre of a cutter must keep from cuts on m moves, (m,) mm.

    ``size`` (m,) mm is the length of each move.  A move round a corner, marked by ``goes_round``
    (m,), may run along a contour.
    """
    disc = expected_tool(station.tool).disc
    assert disc is not None
    across = np.hypot(disc.radius, size / (2.0 * _COARSEST)) + context.tolerance
    needed: F64 = np.where(goes_round, disc.radius - 2.0 * context.resolution, across)
    return needed


def _have_room(context: CheckContext, end: F64, away: F64, needed: F64) -> Bool:
    """Return whether the centre of a cutter keeps a distance from all cuts on m moves, (m,).

    Parameters
    ----------
    end : (m, 2) mm
        Ends of the straight moves, at which the disc touches a contour.
    away : (m, 2) mm
        Vectors from there to the starts of the moves.
    needed : (m,) mm
        The distances to be kept.
    """
    cuts = context.edges.with_types(LineType.CUT).curve
    from_start = point_at(cuts, np.zeros(len(cuts)))
    clear = np.zeros(len(end), np.bool_)
    for k, size in enumerate(np.hypot(*away.T).tolist()):
        distance = np.hypot(*(from_start - end[k]).T)
        reached = cuts[distance <= cuts[:, 5] + size + needed[k]]
        points = end[k] + _MEASURED[:, None] * away[k]
        clear[k] = distance_from_curves(points, reached).min() >= needed[k]
    return clear


def _add_finding(
    context: CheckContext,
    code: str,
    own: TipPaths,
    first: int,
    row: int,
    length: float,
    found: float,
) -> None:
    """Add a finding about a lead-in of ``found`` mm instead of ``length`` mm.

    ``first`` is the first path of the track in ``own``, and ``row`` an edge of its contour.
    """
    message = Message(code, edge=int(row), length=float(length), found=float(found))
    line = int(own.line[first]) + context.lines_before
    context.findings.add("order", message, float(found), edge=int(row), line=line)


def _possible_lengths(context: CheckContext, station: Station, row: I32) -> F64:
    """Return the possible lengths of the straight moves to m contours, (4, m) mm, the full one
    first.

    ``row`` (m,): row in the dieline of an edge of each contour, for which a lead-in is chosen.
    """
    disc = expected_tool(station.tool).disc
    assert disc is not None
    r = disc.radius
    length, angle = _chosen_values(context, station, row)
    straight = np.sqrt(length**2 + r**2 - 2.0 * length * r * np.sin(np.maximum(angle, 0.0)))
    full = np.where(angle < 0.0, length, straight)
    other = np.where(angle < 0.0, length - r, full)
    result: F64 = np.stack([full, 0.5 * full, other, 0.5 * other])
    return result


def _chosen_values(context: CheckContext, station: Station, row: I32) -> tuple[F64, F64]:
    """Return the lengths (mm) and the angles (radians) of the lead-ins of m contours, (m,) each.

    ``row`` (m,): row in the dieline of an edge of each contour, for which a lead-in is chosen.
    """
    disc = expected_tool(station.tool).disc
    assert disc is not None
    chosen = context.chosen[ContourLead]
    length = chosen.numbers("length", disc.entry_length)[row]
    angle = chosen.numbers("approach", getattr(station.tool, "approach", 90.0))[row]
    return length, np.radians(angle)
