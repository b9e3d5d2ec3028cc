"""Check the cuts of perforations, and the gaps between them that hold the board."""

from __future__ import annotations

import numpy as np

from knifetip.messages import Message
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.intervals import SHORT, Overlaps
from knifetip.verification.expectation.edge_paths import edge_paths, link_ends
from knifetip.verification.expectation.edges import STRAIGHT_ANGLE
from knifetip.verification.findings import MAX_FINDINGS


def check_perforations(
    check: StationCheck, overlaps: Overlaps, edge_rows: I64, dashed: Bool, lead: float
) -> None:
    """Check the lengths of the cuts of perforations and of the gaps between these cuts; add
    findings.

    The planned length of a tip path is the length of the cut less the blade's lead.

    Parameters
    ----------
    check
        The check of the station that makes the perforations.
    overlaps
        Overlaps of the tip paths with the edges.
    edge_rows
        Indices of the perforated edges.
    dashed
        Mask of the tracks that are cuts of perforations.  A track is a chain of tip paths
        between two lifts.
    lead : mm
        Length by which the blade cuts the top face ahead of its tip.
    """
    cut, gap = check.context.board.perforation
    perforated = np.zeros(len(check.edges), np.bool_)
    perforated[edge_rows] = True
    keep = np.flatnonzero(perforated[overlaps.edge])
    gaps, edge, begin, line = check.edge_gaps(overlaps, keep, edge_rows)
    wide = gaps > gap + lead + check.slack
    np.add.at(check.figures.uncut, check.edges.row[edge[wide]], gaps[wide])
    for row in np.flatnonzero(wide)[:MAX_FINDINGS]:
        check.add_finding(
            "uncut",
            int(edge[row]),
            Message("verify.perforation-gap", length=gaps[row], place=begin[row], planned=gap),
            gaps[row],
            line=int(line[row]),
        )
    _check_bridges(check, overlaps, perforated, lead)
    size = np.bincount(check.track, check.curve[:, 5], minlength=len(dashed))
    whole: F64 = (size + lead).astype(np.float64)
    # A perforation that is too short for a gap is one cut.
    alone = _tracks_without_gaps(check, overlaps, edge_rows, lead, len(dashed))
    alone &= _are_one_cut(whole, cut, gap, check.slack)
    wrong = dashed & ~alone & (np.abs(whole - cut) > check.slack)
    first = np.searchsorted(check.track, np.arange(len(dashed)))
    for track in np.flatnonzero(wrong)[:MAX_FINDINGS]:
        check.add_finding(
            "uncut",
            -1,
            Message("verify.perforation-cut", length=size[track], planned=cut - lead),
            float(abs(size[track] - (cut - lead))),
            int(first[track]),
        )


def _are_one_cut(length: F64, cut: float, gap: float, slack: float) -> Bool:
    """Return the mask of the perforations that have no gap because of their length, (k,).

    With gaps of at most g, a perforation of length l has n = (l + g) / (c + g) cuts of length c,
    rounded up.  If these are together as long as the perforation, it is one cut.

    ``length`` (k,) mm: lengths of perforations, measured with an error of up to ``slack``.
    ``cut``, ``gap`` mm: lengths c and g of the board.
    """
    result = np.zeros(len(length), np.bool_)
    for error in (-slack, slack):
        count = np.maximum(np.ceil((length + error + gap) / (cut + gap) - 1e-9), 1.0)
        result |= count * cut >= length + error
    return result


def _tracks_without_gaps(
    check: StationCheck, overlaps: Overlaps, edge_rows: I64, lead: float, count: int
) -> Bool:
    """Return the mask of the tracks that have no gap to another cut of their perforation,
    (``count``,).

    A perforation consists of edges that continue each other.  Where one ends and another begins,
    the blade may stop short of this point by its lead on both sides.

    ``check``: the check of the station that makes the perforations.
    ``overlaps``: overlaps of the tip paths with the edges.
    ``edge_rows``: indices of the perforated edges.
    ``lead`` mm: length by which the blade cuts the top face ahead of its tip.
    """
    edges = check.edges.select(edge_rows)
    paths = edge_paths(edges, link_ends(edges, STRAIGHT_ANGLE)[0])
    number = np.full(len(check.edges), -1, np.int64)
    number[edge_rows] = np.arange(len(edge_rows))
    # Tip paths that only cross a perforation, as those of other perforations, are not counted.
    along = overlaps.best & (number[overlaps.edge] >= 0)
    along &= np.abs(np.diff(overlaps.place)[:, 0]) > SHORT
    edge, track = number[overlaps.edge[along]], check.track[overlaps.curve[along]]
    place = overlaps.place[along]
    size = edges.curve[edge, 5][:, None]
    place = paths.begin[edge, None] + np.where(paths.flipped[edge, None], size - place, place)
    pairs, cuts = np.unique(
        np.stack([paths.path[edge], track], axis=1), axis=0, return_inverse=True
    )
    begin, end = np.full(len(pairs), np.inf), np.full(len(pairs), -np.inf)
    np.minimum.at(begin, cuts.ravel(), place.min(axis=1))
    np.maximum.at(end, cuts.ravel(), place.max(axis=1))
    order = np.lexsort((begin, pairs[:, 0]))
    path, track, begin, end = pairs[order, 0], pairs[order, 1], begin[order], end[order]
    parted = path[1:] == path[:-1]
    parted &= begin[1:] - end[:-1] > 2.0 * lead + check.slack
    result = np.zeros(count, np.bool_)
    result[track] = True
    result[track[1:][parted]] = result[track[:-1][parted]] = False
    return result


def _check_bridges(check: StationCheck, overlaps: Overlaps, perforated: Bool, lead: float) -> None:
    """Add a finding for each gap of a perforation that is too short to hold the board, and for
    each that differs from the gap before it.

    The gaps of a path of length L are equal, and as few as keep each of them at most as long as
    the board's gap g.  With n cuts of the board's length c, one cut less would make the gaps
    longer than g, so each gap is longer than g - (g + c) / (n - 1).  An edge of length l is a
    part of such a path, so n is at least (l + g) / (c + g), rounded up.  This limit was derived
    for knifetip.

    ``check``: the check of the station that makes the perforations.
    ``overlaps``: overlaps of the tip paths with the n edges.
    ``perforated`` (n,): mask of the perforated edges.
    ``lead`` mm: length by which the blade cuts the top face ahead of its tip.
    """
    cut, gap = check.context.board.perforation
    rows = overlaps.best & perforated[overlaps.edge]
    # A cut that begins at the end of the edge may overlap it by as much as rounding shifts it.
    rows &= np.abs(np.diff(overlaps.place)[:, 0]) > SHORT + 2.0 * check.context.resolution
    edge, track = overlaps.edge[rows].astype(np.int64), check.track[overlaps.curve[rows]]
    place, line = overlaps.place[rows], check.line[overlaps.curve[rows]]
    forward = place[:, 1] > place[:, 0]
    low = place.min(axis=1) - np.where(forward, 0.0, lead)
    high = place.max(axis=1) + np.where(forward, lead, 0.0)
    # A cut along an arc or a bend consists of several tip paths.
    pairs, cuts = np.unique(np.stack([edge, track], axis=1), axis=0, return_inverse=True)
    begin, end = np.full(len(pairs), np.inf), np.full(len(pairs), -np.inf)
    np.minimum.at(begin, cuts.ravel(), low)
    np.maximum.at(end, cuts.ravel(), high)
    first_line = np.zeros(len(pairs), np.int64)
    first_line[cuts.ravel()] = line
    order = np.lexsort((begin, pairs[:, 0]))
    edge, begin, end, first_line = pairs[order, 0], begin[order], end[order], first_line[order]
    bridge = np.flatnonzero(edge[1:] == edge[:-1])
    edge, length = edge[bridge], begin[bridge + 1] - end[bridge]
    count = np.ceil((check.size[edge] + gap) / (cut + gap) - 1e-9)
    least = np.maximum(gap - (gap + cut) / np.maximum(count - 1.0, 1.0), 0.0)
    for k in np.flatnonzero(length < least - check.slack)[:MAX_FINDINGS]:
        check.context.findings.add(
            "overcut",
            Message(
                "verify.perforation-bridge",
                length=max(length[k], 0.0),
                place=end[bridge[k]],
                least=least[k],
            ),
            float(least[k] - length[k]),
            edge=int(check.edges.row[edge[k]]),
            line=int(first_line[bridge[k] + 1]),
        )
    # Each of the four ends of two gaps is rounded.
    uneven = check.tolerance + 4.0 * check.context.resolution
    follows = (edge[1:] == edge[:-1]) & (bridge[1:] == bridge[:-1] + 1)
    fits = (length <= gap + check.slack) & (length >= least - check.slack)
    follows &= fits[1:] & fits[:-1]
    change = np.where(follows, np.abs(np.diff(length)), 0.0)
    for k in np.flatnonzero(change > uneven)[:MAX_FINDINGS]:
        check.context.findings.add(
            "deviation",
            Message(
                "verify.perforation-uneven",
                first=length[k],
                second=length[k + 1],
                place=end[bridge[k]],
            ),
            float(change[k]),
            edge=int(check.edges.row[edge[k]]),
            line=int(first_line[bridge[k] + 1]),
        )
