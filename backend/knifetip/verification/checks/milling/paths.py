"""Check that a cutter's centre goes along its cuts only, and that its disc enters no part."""

from __future__ import annotations

from itertools import chain
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.verification.checks.common.context import NEAR_EDGE
from knifetip.verification.checks.milling import geometry as milling_geometry
from knifetip.verification.checks.milling.geometry import spans_near_points
from knifetip.verification.checks.milling.work import MillingWork
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import left_distance, line_curves, point_at
from knifetip.verification.curves.intervals import EPSILON, uncovered_curves, uncovered_edges
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.cutter_paths import cutter_paths
from knifetip.verification.expectation.outline import count_enclosing
from knifetip.verification.findings import MAX_FINDINGS

#: Twice the rounding of printed coordinates (mm).
_PRINT_ROUNDING: Final = 1e-4


def check_centre_paths(work: MillingWork, on_cut: Bool) -> None:
    """Check the n paths of a cutter's centre, and add a finding for each fault.

    The disc must enter no part, a path must not go past the end of an open cut that it follows, and
    it must not be far from all cuts.  ``on_cut`` is the result of ``open_cut_mask``, (n,).
    """
    _check_parts(work, on_cut)
    _check_open_ends(work, on_cut)
    _check_stray_work(work, on_cut)


def _check_parts(work: MillingWork, on_cut: Bool) -> None:
    """Add a finding for each path on which the disc cuts into a part.

    The distance by which the disc extends past an edge into the part is recorded as the overcut
    of the edge.
    """
    closing = np.flatnonzero(work.bounds.closing)
    curve = work.edges.curve[closing]
    widest = float(work.reach.max())
    overlaps = find_overlaps(work.centres.curve, curve, np.zeros(len(curve)), curve[:, 5], widest)
    path, edge = overlaps.curve, overlaps.edge
    penetration = np.zeros(len(path))
    sides = np.zeros((2, len(path)))
    # The ends of a stretch beside an arc are inexact if the disc is nearly as wide as it.
    whole = overlaps.along.copy()
    bent = curve[edge, 0] != 0.0
    whole[bent, 0], whole[bent, 1] = 0.0, work.centres.curve[path[bent], 5]
    candidates = milling_geometry.nearest_candidates
    for position in chain(
        candidates(work.centres.curve[path], overlaps.along, curve[edge], work.disc_is_round),
        candidates(work.centres.curve[path], whole, curve[edge], True),
    ):
        centre = point_at(work.centres.curve[path], position)
        penetration = np.maximum(
            penetration,
            milling_geometry.disc_penetration(centre, curve[edge], work.reach),
        )
        beside = milling_geometry.is_beside_arc(centre, curve[edge], work.reach)
        offset = left_distance(work.centres.curve[path], position, curve[edge])
        offset = np.where(beside, offset, 0.0)
        sides = np.stack([np.minimum(sides[0], offset), np.maximum(sides[1], offset)])
    # A path with points on both sides of an edge crosses the edge.
    crosses = (sides[0] < -EPSILON) & (sides[1] > EPSILON)
    penetration = np.where(crosses, np.maximum(penetration, work.reach.min()), penetration)
    # An open cut is followed on its line, so the disc removes board on both sides.
    _record_overcut(work, closing[edge], path, np.where(on_cut[path], 0.0, penetration))

    corner = work.edges.ends[np.repeat(work.bounds.closing, 2)]
    met = find_overlaps(
        line_curves(corner, corner),
        work.centres.curve,
        np.zeros(len(work.centres.z)),
        work.centres.curve[:, 5],
        widest,
    )
    touched = met.edge
    near = np.full(len(touched), np.inf)
    for fraction in np.linspace(0.0, 1.0, 2 if work.disc_is_round else 33):
        centre = point_at(work.centres.curve[touched], fraction * work.centres.curve[touched, 5])
        near = np.minimum(near, np.hypot(*((centre - corner[met.curve]) / work.reach).T))
    foot = milling_geometry.nearest_along(
        work.centres.curve[touched], corner[met.curve], work.reach
    )
    centre = point_at(work.centres.curve[touched], foot)
    near = np.minimum(near, np.hypot(*((centre - corner[met.curve]) / work.reach).T))
    penetration = np.where(on_cut[touched], 0.0, (1.0 - near) * float(work.reach.min()))
    at_corner = np.repeat(closing, 2)[met.curve]
    _record_overcut(work, at_corner, touched, penetration)


def open_cut_mask(work: MillingWork) -> Bool:
    """Return the mask of the centre's n paths that follow an open cut, shape (n,).

    An open cut is a cut that does not separate a part from waste.  Paths along a contour, and
    its leads, may lie on an open cut, too, but they do not follow it.
    """
    own = work.edges.curve[~work.bounds.closing]
    size, track = work.centres.curve[:, 5], work.centres.track
    # An open cut that other cuts meet is divided there, so a path may follow several pieces.
    covered, touches = _lengths_along(work, np.arange(len(size)), own)
    result = touches & (size - covered <= 0.5 * size + EPSILON)
    # Tracks that lie mainly beside contours, and less of their length on open cuts.
    total, cut = np.bincount(track, size), np.bincount(track, covered)
    mixed = np.zeros(len(total), np.bool_)
    mixed[track[result]] = True
    mixed &= cut < total - work.slack
    rows = np.flatnonzero(mixed[track])
    if len(rows):
        pieces = cutter_paths(work.bounds, work.reach)
        beside = pieces.curve[work.bounds.closing[pieces.edge]]
        along = np.bincount(
            track[rows], _lengths_along(work, rows, beside)[0], minlength=len(total)
        )
        contour = (along > 0.5 * total) & (along > cut + work.slack)
        result[rows[contour[track[rows]]]] = False
    return result


def _lengths_along(work: MillingWork, rows: I64, lines: F64) -> tuple[F64, Bool]:
    """Return the length of each of k paths of the centre that lies on m lines and arcs, (k,)
    mm, and the mask of the paths that touch one of them, (k,).

    ``rows`` (k,): indices of the paths.
    ``lines`` (m, 6): lines and arcs as rows of six numbers (see ``curves.curve``).
    """
    curve = work.centres.curve[rows]
    overlaps = find_overlaps(curve, lines, np.zeros(len(lines)), lines[:, 5], work.tolerance)
    left, spans = uncovered_curves(overlaps, curve)
    touches = np.zeros(len(rows), np.bool_)
    touches[overlaps.curve] = True
    apart = np.bincount(left, np.diff(spans)[:, 0], minlength=len(rows))
    return curve[:, 5] - apart, touches


def _check_open_ends(work: MillingWork, on_cut: Bool) -> None:
    """Add a finding for each path of the centre that goes past an end of the open cut that it
    follows.

    An open cut is a cut that does not separate a part from waste.
    """
    rows = np.flatnonzero(on_cut)
    own = work.edges.curve[~work.bounds.closing]
    curve = work.centres.curve[rows]
    near = find_overlaps(curve, own, np.zeros(len(own)), own[:, 5], work.tolerance)
    path_rows, spans = uncovered_curves(near, curve)
    size = np.diff(spans)[:, 0]
    for k in np.flatnonzero(size > work.slack)[:MAX_FINDINGS]:
        work.add_finding(
            "overcut",
            -1,
            Message("verify.past-open-cut", length=size[k]),
            float(size[k]),
            int(rows[path_rows[k]]),
        )


def _record_overcut(work: MillingWork, edge: I64, path: I32 | I64, penetration: F64) -> None:
    """Record how far the disc extends past an edge in k pairs of an edge and a path, and add a
    finding for each pair in which it cuts into a part.

    ``edge``, ``path`` (k,): indices of the edge and the path; a pair may occur repeatedly.
    ``penetration`` (k,) mm: distance by which the disc extends past the edge; at most 0 if it does
    not.
    """
    penetration = np.where(penetration > EPSILON, penetration, 0.0)
    figure = penetration + np.where(penetration > 0.0, work.rounds[path], 0.0)
    row = work.edges.row[edge]
    np.maximum.at(
        work.context.figures.overcut,
        row,
        np.where(penetration > _PRINT_ROUNDING, penetration, 0.0),
    )
    bad = np.flatnonzero(figure > work.tolerance + _PRINT_ROUNDING)
    # Report only the worst place of each pair of edge and path.
    bad = bad[np.argsort(-penetration[bad], kind="stable")]
    reported = np.unique(np.stack([edge[bad], path[bad]], axis=1), axis=0, return_index=True)[1]
    for k in bad[np.sort(reported)][:MAX_FINDINGS]:
        work.add_finding(
            "overcut",
            int(edge[k]),
            Message("verify.cuts-part", depth=penetration[k]),
            float(penetration[k]),
            int(path[k]),
        )


def _check_stray_work(work: MillingWork, on_cut: Bool) -> None:
    """Add a finding for each path of the cutter inside a part or too far from every edge."""
    centres = work.centres
    first = np.unique(centres.track, return_index=True)[1]
    middle = 0.5 * centres.curve[first, 5]
    depth = count_enclosing(point_at(centres.curve[first], middle), work.bounds)
    slits = np.zeros(int(centres.track.max(initial=-1)) + 1, np.bool_)
    slits[centres.track[on_cut]] = True
    for row in first[(depth % 2 == 1) & ~slits[centres.track[first]]][:MAX_FINDINGS]:
        x, y = point_at(centres.curve[row : row + 1], np.zeros(1))[0]
        work.add_finding(
            "stray",
            -1,
            Message("verify.inside-part", x=x, y=y),
            float(centres.curve[row, 5]),
            int(row),
        )
    far = 2.0 * work.tool.radius + max(work.tool.entry_length, NEAR_EDGE)
    near = find_overlaps(centres.curve, work.edges.curve, np.zeros(len(work.edges)), work.size, far)
    ends = find_overlaps(
        line_curves(work.edges.ends, work.edges.ends),
        centres.curve,
        np.zeros(len(centres.z)),
        centres.curve[:, 5],
        far,
    )
    low, high = spans_near_points(centres.curve[ends.edge], work.edges.ends[ends.curve], far)
    nonempty = high > low
    path_rows, begin, end = uncovered_edges(
        np.concatenate([near.curve, ends.edge[nonempty]]).astype(np.int64),
        np.concatenate([near.along[:, 0], low[nonempty]]),
        np.concatenate([near.along[:, 1], high[nonempty]]),
        centres.curve[:, 5],
    )
    lost = end - begin > work.slack
    for k in np.flatnonzero(lost)[:MAX_FINDINGS]:
        x, y = point_at(centres.curve[path_rows[k : k + 1]], begin[k : k + 1])[0]
        work.add_finding(
            "stray",
            -1,
            Message("verify.stray", tool="cutter", length=end[k] - begin[k], x=x, y=y),
            float(end[k] - begin[k]),
            int(path_rows[k]),
        )
