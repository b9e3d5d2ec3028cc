"""Find stretches of tip paths that lie on no edge: past an end, beside an edge, or elsewhere.

Each stretch gives a finding.  A stretch past an end is also recorded as overcut of the edge, and a
stretch beside an edge as deviation of the edge.
"""

from __future__ import annotations

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.checks.common.context import NEAR_EDGE
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import point_at
from knifetip.verification.curves.intervals import Overlaps, uncovered_curves
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import TOUCH_DISTANCE
from knifetip.verification.expectation.outline import count_enclosing, find_outlines
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.tools import OperationKind


def check_stray_work(
    check: StationCheck, overlaps: Overlaps, checked_length: F64, max_outside: float = 0.0
) -> None:
    """Add findings for stretches of tip paths on no edge, or outside the limits of their edge.

    The limits of an edge are the points at which the tip may start and must stop.

    Parameters
    ----------
    check
        The check of one station, whose tip paths and edges are used and to which the findings are
        added.
    overlaps
        Overlaps of the tip paths with the edges.
    checked_length : (n,) mm
        Only this length of each of n tip paths, from the start of the path, is checked.  The rest
        of the path is a planned overrun.
    max_outside : mm
        Greatest length of a stretch outside the board that is permitted.
    """
    path_rows, spans = uncovered_curves(overlaps, check.curve)
    spans[:, 1] = np.minimum(spans[:, 1], checked_length[path_rows])
    point = check.curve[path_rows, 5] < 1e-6
    keep = point | (spans[:, 1] - spans[:, 0] > 1e-7)
    if max_outside > 0.0 and len(path_rows):
        bounds = find_outlines(check.context.edges.with_types(LineType.CUT))
        middle = point_at(check.curve[path_rows], spans.mean(axis=1))
        short = spans[:, 1] - spans[:, 0] <= max_outside
        keep &= ~(short & bounds.outer.any() & (count_enclosing(middle, bounds) == 0))
    path_rows, spans = path_rows[keep], spans[keep]
    if len(path_rows) == 0:
        return
    size = spans[:, 1] - spans[:, 0]
    track = check.track[path_rows]
    # Join stretches that follow each other.
    joined = np.zeros(len(path_rows), np.bool_)
    joined[1:] = (
        (path_rows[1:] == path_rows[:-1] + 1)
        & (track[1:] == track[:-1])
        & (spans[1:, 0] <= 1e-7)
        & (spans[:-1, 1] >= check.curve[path_rows[:-1], 5] - 1e-7)
    )
    first = np.flatnonzero(~joined)
    total: F64 = np.add.reduceat(size, first)
    lone = check.curve[path_rows[first], 5] < 1e-6
    _report_stray(
        check, path_rows, spans, first, total, np.flatnonzero((total > check.slack) | lone)
    )


def _report_stray(
    check: StationCheck, path_rows: I32, spans: F64, first: I64, total: F64, bad: I64
) -> None:
    """Add a finding for each of the selected groups of stretches that lie on no edge.

    The finding states whether the group lies past an end of an edge, beside an edge, or elsewhere.

    ``check``: the check of one station, to which the findings are added.
    ``path_rows``, ``spans`` (k,), (k, 2) mm: index of the tip path of each of k stretches, and the
    stretch's start and end along it.
    ``first``, ``total`` (g,), (g,) mm: index of the first stretch of each of g groups of
    consecutive stretches, and the total length of the group.
    ``bad``: indices of the selected groups.
    """
    bad = bad[:MAX_FINDINGS]
    if len(bad) == 0 or check.findings.full:
        return
    curve, all_edges = check.curve[path_rows[first[bad]]], check.context.edges
    nothing = np.zeros(len(check.edges))
    touches = find_overlaps(curve, check.edges.curve, nothing, check.size, check.tolerance)
    near = find_overlaps(curve, check.edges.curve, nothing, check.size, NEAR_EDGE)
    other = all_edges.find_overlaps(curve, TOUCH_DISTANCE)
    clear = check.context.board.end_clearance if check.operation == OperationKind.CREASE else 0.0
    tool = check.operation.tool
    for k, group in enumerate(bad):
        line, length = int(check.line[path_rows[first[group]]]), float(total[group])
        span = spans[first[group]]
        if (edge := _edge_along(touches, k, span)) >= 0:
            check.record_overcut(np.array([edge]), np.array([max(length - clear, 0.0)]))
            message = Message("verify.past-stop", tool=tool, length=length)
            check.add_finding("overcut", edge, message, length, line=line)
            continue
        edge, measure = _edge_beside(near, k, span)
        if edge >= 0:
            row = check.edges.row[edge]
            one = np.array([row])
            nothing = np.zeros(1)
            check.figures.record_deviation(one, np.array([measure]), nothing, nothing)
            message = Message("verify.beside-line", tool=tool, distance=measure)
            check.add_finding("deviation", edge, message, measure, line=line)
            continue
        if (edge := _edge_touched(touches, k, span)) >= 0:
            check.record_overcut(np.array([edge]), np.array([length]))
            message = Message("verify.past-end", tool=tool, length=length)
            check.add_finding("overcut", edge, message, length, line=line)
            continue
        x, y = point_at(curve[k : k + 1], span[:1])[0]
        if (wrong := _edge_along(other, k, span)) >= 0:
            row, kind = all_edges.row[wrong], LineType(int(all_edges.line_type[wrong])).word
            if length > 0.0:
                message = Message(
                    "verify.stray-along", tool=tool, length=length, edge=row, type=kind
                )
            else:
                message = Message("verify.stray-plunge-along", tool=tool, edge=row, type=kind)
        elif length > 0.0:
            message = Message("verify.stray", tool=tool, length=length, x=x, y=y)
        else:
            message = Message("verify.stray-plunge", tool=tool, x=x, y=y)
        check.add_finding("stray", -1, message, length, line=line)


def _shared_lengths(overlaps: Overlaps, curve: int, span: F64) -> tuple[slice, F64, Bool]:
    """Return the length of each overlap of one curve that lies in a span of that curve.

    ``curve`` is the index of the curve, and ``span`` is the start and end of the span on it (mm).

    Returns the slice of ``overlaps`` that contains the k overlaps of the curve; the length of each
    of them inside the span, (k,) mm, negative if it is outside; and the mask of the overlaps that
    run along their edge instead of across it, (k,).
    """
    rows = slice(*np.searchsorted(overlaps.curve, [curve, curve + 1]))
    along, place = overlaps.along[rows], overlaps.place[rows]
    shared = np.minimum(along[:, 1], span[1]) - np.maximum(along[:, 0], span[0])
    size = along[:, 1] - along[:, 0]
    return rows, shared, np.abs(place[:, 1] - place[:, 0]) >= 0.5 * size


def _edge_along(overlaps: Overlaps, curve: int, span: F64) -> int:
    """Return the index of an edge that runs along at least half of a span of a curve, -1 for none.

    ``curve`` is the index of the curve, and ``span`` is the start and end of the span on it (mm).
    """
    rows, shared, parallel = _shared_lengths(overlaps, curve, span)
    good = np.flatnonzero((shared >= 0.5 * (span[1] - span[0])) & parallel)
    return int(overlaps.edge[rows][good[0]]) if len(good) else -1


def _edge_beside(overlaps: Overlaps, curve: int, span: F64) -> tuple[int, float]:
    """Return the index of the nearest edge beside a span of a curve, and the distance of the edge
    (mm).

    Only edges that run along at least 80 % of the span are considered; if there are none, -1 and 0
    are returned.  ``curve`` is the index of the curve, and ``span`` is the start and end of the
    span on it (mm).
    """
    rows, shared, parallel = _shared_lengths(overlaps, curve, span)
    good = np.flatnonzero((shared >= 0.8 * (span[1] - span[0])) & parallel)
    if len(good) == 0:
        return -1, 0.0
    return int(overlaps.edge[rows][good[0]]), float(overlaps.distance[rows][good[0]])


def _edge_touched(overlaps: Overlaps, curve: int, span: F64) -> int:
    """Return the index of an edge that a curve follows just before or after a span, -1 for none.

    ``curve`` is the index of the curve, and ``span`` is the start and end of the span on it (mm).
    """
    rows, _, _ = _shared_lengths(overlaps, curve, span)
    along = overlaps.along[rows]
    touching = (np.abs(along[:, 1] - span[0]) < 1e-6) | (np.abs(along[:, 0] - span[1]) < 1e-6)
    good = np.flatnonzero(touching)
    return int(overlaps.edge[rows][good[0]]) if len(good) else -1
