"""Check that a program begins edges in the order that the user has chosen.

A track is a part of the program without a lift.  An edge is begun by the first track whose tip
follows a part of it, or whose disc touches it from the side.  The first tip paths along the edges
must have the chosen order.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.model.tool import Knife
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.order.worked_spans import MIN_LENGTH, find_worked_spans
from knifetip.verification.columns import I64
from knifetip.verification.expectation.chosen_order import ExpectedOrder
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind

#: The operations that begin an edge of each line type.
_OPERATIONS: Final = {
    LineType.CUT: (OperationKind.CUT, OperationKind.HALF_CUT),
    LineType.HALF_CUT: (OperationKind.CUT, OperationKind.HALF_CUT),
    LineType.PERFORATION: (OperationKind.CUT, OperationKind.HALF_CUT),
    LineType.CREASE: (OperationKind.CREASE,),
    LineType.COMBI: (OperationKind.CREASE,),
    LineType.V_GROOVE: (OperationKind.GROOVE,),
}
#: Number of an edge that no tip path follows.
_NEVER: Final = np.iinfo(np.int64).max


def check_chosen_order(context: CheckContext, order: ExpectedOrder, paths: TipPaths) -> None:
    """Add a finding for each edge that is begun before one that the user has put before it.

    ``paths`` are the tip paths of all programs of the sheet, in the order of the work.
    """
    if not order:
        return
    begun = _first_paths(context, paths)
    latest, latest_row, found = -1, -1, 0
    for place in order:
        path = int(begun[place.rows].min())
        if path == _NEVER:
            # That the edge is uncut is a finding already.
            continue
        if path >= latest:
            latest, latest_row = path, place.row
        elif found < MAX_FINDINGS:
            found += 1
            line = int(paths.line[path])
            message = Message(
                "verify.other-order",
                edge=place.row,
                other=latest_row,
                line=max(line - context.lines_before, 0),
            )
            context.findings.add("order", message, 0.0, edge=place.row, line=line)


def _first_paths(context: CheckContext, paths: TipPaths) -> I64:
    """Return the first tip path that makes each of n rows of the dieline, (n,); ``_NEVER`` for
    none.
    """
    result = np.full(int(context.edges.row.max(initial=-1)) + 1, _NEVER)
    for line_type, operations in _OPERATIONS.items():
        edges = context.edges.with_types(line_type)
        rows = np.flatnonzero(np.isin(paths.operation, operations))
        if len(edges) and len(rows):
            edge, first = _followed(context, edges, paths, rows)
            np.minimum.at(result, edges.row[edge], first)
    cuts = context.edges.with_types(LineType.CUT)
    mills = paths.operation == OperationKind.MILL
    if len(cuts) and mills.any():
        milled = np.flatnonzero(mills)
        spans = find_worked_spans(context, paths.select(mills), cuts)
        size = np.minimum(spans.travel, cuts.curve[spans.edge, 5])
        made = spans.high - spans.low >= 0.5 * size
        first = milled[np.searchsorted(paths.line[milled], spans.line[made])]
        np.minimum.at(result, cuts.row[spans.edge[made]], first)
    return result


def _followed(context: CheckContext, edges: Edges, paths: TipPaths, rows: I64) -> tuple[I64, I64]:
    """Return the k pairs of an edge and a track that makes a part of it, as the index of the edge
    and the first tip path of the track along it, (k,) each.

    ``rows`` are the tip paths that are compared.  A track that only crosses an edge, or that a
    slanted blade runs on past the end of another edge, does not make it.
    """
    near = edges.find_overlaps(paths.curve[rows], context.tolerance)
    size = np.diff(near.along)[:, 0]
    counts = near.best & (np.abs(np.diff(near.place)[:, 0]) >= 0.5 * size)
    edge, path, size = near.edge[counts].astype(np.int64), rows[near.curve[counts]], size[counts]
    tracks = int(paths.track.max()) + 1
    pair, number = np.unique(edge * tracks + paths.track[path], return_inverse=True)
    length = np.bincount(number, size, len(pair))
    least = np.minimum(0.5 * edges.curve[pair // tracks, 5], _longest_overrun(context))
    pressed = np.zeros(len(pair), np.bool_)
    pressed[number[paths.curve[path, 5] == 0.0]] = True
    first = np.full(len(pair), _NEVER)
    np.minimum.at(first, number, path)
    made = (length > least) | pressed
    return pair[made] // tracks, first[made]


def _longest_overrun(context: CheckContext) -> float:
    """Return a length that a tool may run past the end of an edge, at least ``MIN_LENGTH`` (mm).

    A blade that is slanted by an angle cuts ahead of its tip by its depth times the tangent of the
    angle.
    """
    depth = context.board.caliper + context.machine.into_mat
    slants = [
        math.tan(math.radians(station.tool.blade_angle))
        for station in context.machine.stations
        if isinstance(station.tool, Knife)
    ]
    return max(MIN_LENGTH, depth * max(slants, default=0.0) + context.tolerance)
