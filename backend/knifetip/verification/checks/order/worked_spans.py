"""Find the stretches of cuts that a program has cut, and when each piece of a cut is complete."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import F64_1, I64_1, Bool_1, kernel
from knifetip.model.machine import Station
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.checks.order.cut_faces import GAP_LENGTH, CutFaces
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.intervals import add_interval
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.cutter_paths import cutter_paths, disc_reach
from knifetip.verification.expectation.edge_pieces import split_at_junctions
from knifetip.verification.expectation.edges import JOIN_DISTANCE, Edges
from knifetip.verification.expectation.outline import CutOutlines, find_outlines
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind, expected_tool

#: A shorter overlap with an edge is a crossing (mm).
MIN_LENGTH: Final = 0.1


#: At an inner corner of 28° a cutter cannot reach the first part of either edge.  The length of
#: this part is this number times the radius of the cutter.
_CORNER_RATIO: Final = 4.0


class _Stretches(NamedTuple):
    """k stretches of cuts, each made by one tip path."""

    edge: I32 | I64  #: (k,) index of the cut
    low: F64  #: (k,) mm along the cut
    high: F64  #: (k,)
    size: F64  #: (k,) mm, length of the part of the cut to which the stretch belongs
    path: I64  #: (k,) row of the tip path
    through: Bool  #: (k,) the work goes through the board


class _Parts(NamedTuple):
    """The parts of cuts between their junctions: a cut may be a part of an outline, and continue as
    a slit between two flaps.
    """

    bounds: CutOutlines  #: the p parts, and the outlines that they form
    owner: I64  #: (p,) index of the cut
    begin: F64  #: (p,) mm, start of the part along the cut


class _CutPieces(NamedTuple):
    """p pieces of cuts, and links."""

    owner: I64_1  #: (p,) index of the cut, -1 for a link
    begin: F64_1  #: (p,) mm, start of the piece on the cut
    end: F64_1  #: (p,) mm, its end


class _CutSpans(NamedTuple):
    """k stretches of cuts that tools have cut, sorted by cut and by program line."""

    edge: I64_1  #: (k,) index of the cut
    low: F64_1  #: (k,) mm, start of the stretch on the cut
    high: F64_1  #: (k,) mm, its end
    line: I64_1  #: (k,) program line, -1 if the stretch is not cut through the board


@dataclass(frozen=True, eq=False, slots=True)
class WorkedSpans:
    """k stretches of cuts that the tools have cut, sorted by edge and by program line."""

    edge: I64  #: (k,)
    low: F64  #: (k,) mm along the edge
    high: F64  #: (k,)
    line: I64  #: (k,)
    through: Bool  #: (k,) the work goes through the board
    travel: F64  #: (k,) mm, length of the tip paths of which the stretch is a part
    path: I64  #: (m,) rows of all tip paths on these stretches
    reach: float  #: mm, the radius of the widest cutter, 0 for knives


def find_worked_spans(context: CheckContext, work: TipPaths, cuts: Edges) -> WorkedSpans:
    """Return the stretches of the edges ``cuts`` that the tools have cut.

    ``work`` are all tip paths.  The path of a knife's tip lies on its cut; the path of a cutter's
    centre lies beside its cut.
    """
    stretches = [_knife_stretches(context, work, cuts)]
    mill = work.operation == OperationKind.MILL
    widest = 0.0
    if mill.any():
        pieces, owner, begin = split_at_junctions(cuts)
        parts = _Parts(find_outlines(pieces), owner, begin)
        for index in np.unique(work.station[mill]):
            station = context.machine.stations[int(index)]
            rows = np.flatnonzero(mill & (work.station == index))
            stretches.append(_milled_stretches(context, work, rows, parts, station))
            widest = max(widest, float(disc_reach(context.board, station).max()))
    edge, low, high, size, path, is_through = (
        np.concatenate(column) for column in zip(*stretches, strict=True)
    )
    order = np.lexsort((path, edge))
    edge, path = edge[order].astype(np.int64), path[order].astype(np.int64)
    low, high, size, is_through = low[order], high[order], size[order], is_through[order]
    line = work.line[path].astype(np.int64)
    # The head may follow an arc with a trailing knife on many tip paths, each very short.
    first = _first_rows(edge, low, high, path, line)
    if len(first):
        low, high = np.minimum.reduceat(low, first), np.maximum.reduceat(high, first)
        is_through = np.logical_and.reduceat(is_through, first)
    travel = np.add.reduceat(work.curve[path, 5], first) if len(first) else np.zeros(0)
    # Drop paths that only cross a cut or touch its end.
    long = high - low >= np.minimum(MIN_LENGTH, 0.5 * size[first])
    kept, many = first[long], np.diff(first, append=len(path))
    return WorkedSpans(
        edge[kept], low[long], high[long], line[kept], is_through[long], travel[long],
        path[np.repeat(long, many)], widest,
    )  # fmt: skip


def _knife_stretches(context: CheckContext, work: TipPaths, cuts: Edges) -> _Stretches:
    """Return the stretches of the edges ``cuts`` that knives have cut.

    ``work`` are all tip paths.
    """
    knife = np.flatnonzero(work.operation == OperationKind.CUT)
    near = cuts.find_overlaps(work.curve[knife], context.tolerance)
    near = near.select(near.best)
    low, high = near.place_range()
    through = np.ones(len(low), np.bool_)
    return _Stretches(near.edge, low, high, cuts.curve[near.edge, 5], knife[near.curve], through)


def _milled_stretches(
    context: CheckContext, work: TipPaths, rows: I64, parts: _Parts, station: Station
) -> _Stretches:
    """Return the stretches of cuts that the cutter of a station has cut.

    ``work`` are all tip paths, and ``rows`` the indices of those of the cutter's centre.
    """
    beside = cutter_paths(parts.bounds, disc_reach(context.board, station))
    length = beside.curve[:, 5]
    near = find_overlaps(
        work.curve[rows], beside.curve, np.zeros(len(length)), length, context.tolerance
    )
    crosses = _lies_inside(near.along, work.curve[rows[near.curve], 5])
    crosses &= _lies_inside(near.place, length[near.edge])
    near = near.select(~crosses)
    path, part = rows[near.curve], beside.edge[near.edge]
    low, high = beside.edge_intervals(near.edge, near.place)
    deep = context.board.caliper - work.z[path]
    planned = expected_tool(station.tool).through_depth(
        context.board.caliper, context.machine.into_mat
    )
    return _Stretches(
        parts.owner[part], low + parts.begin[part], high + parts.begin[part],
        parts.bounds.edges.curve[part, 5], path, deep >= planned - context.depth_tolerance,
    )  # fmt: skip


def _first_rows(edge: I64, low: F64, high: F64, path: I64, line: I64) -> I64:
    """Return the first row of each group of tip paths that follow each other along a cut, (g,).

    All paths of a group belong to one program line.

    ``edge``, ``low``, ``high``, ``path``, ``line`` (n,): index of the cut on which each tip path
    lies, the path's start and end on it (mm), the row of the path and its program line; sorted by
    cut and then by path.
    """
    follows = (edge[1:] == edge[:-1]) & (path[1:] == path[:-1] + 1) & (line[1:] == line[:-1])
    follows &= (low[1:] <= high[:-1] + JOIN_DISTANCE) & (low[:-1] <= high[1:] + JOIN_DISTANCE)
    return np.flatnonzero(np.concatenate([np.ones(min(len(edge), 1), np.bool_), ~follows]))


def _lies_inside(span: F64, size: F64) -> Bool:
    """Return the mask of the stretches that contain neither end of their line, (k,).

    ``span`` are the start and the end of each stretch on its line, in any order, (k, 2) mm, and
    ``size`` is the length of the line, (k,) mm.  Lines that cross at a small angle are near each
    other along such a stretch of both lines.
    """
    result: Bool = (span.min(axis=1) > JOIN_DISTANCE) & (span.max(axis=1) < size - JOIN_DISTANCE)
    return result


def completing_lines(faces: CutFaces, spans: WorkedSpans, count: int, rest: float) -> F64:
    """Return the program line that completes each of p pieces of cuts and links, (p,).

    A link is a straight line that closes a small gap between cuts.  A piece of a cut is complete
    when every length of it that remains uncut is too short to hold the part, such as a length
    beside an inner corner that the disc of a cutter cannot reach.  The line is infinite for a piece
    that is never completed, and -1 for a link.  If the machine has a cutter, the line is 0 for a
    piece that no tool touches: such a piece is out of the disc's reach and does not hold the part.

    Parameters
    ----------
    faces
        The pieces and the faces beside them.
    spans
        Stretches of cuts that the tools have cut.
    count
        Number of cuts.
    rest : mm
        Longest uncut length that does not hold the part.
    """
    begin = faces.begin
    line = np.where(spans.through, spans.line, -1)
    reach = spans.reach
    pieces = _CutPieces(faces.edge, begin, begin + faces.curve[:, 5])
    cut = _CutSpans(spans.edge, spans.low, spans.high, line)
    result: F64 = _completing_lines(pieces, cut, count, rest, reach)
    return result


def first_lines(faces: CutFaces, spans: WorkedSpans, count: int) -> F64:
    """Return the program line with which the cut between two faces begins, for each of p pieces of
    cuts and links, (p,).

    All pieces between the same two faces have the same line.  It is infinite if no tool cuts any of
    them, and -1 for a link.  A knife's overrun begins no cut: a stretch counts if it is at least
    ``GAP_LENGTH`` mm or half a piece long.  The parameters are those of ``completing_lines``.
    """
    pieces = _CutPieces(faces.edge, faces.begin, faces.begin + faces.curve[:, 5])
    cut = _CutSpans(spans.edge, spans.low, spans.high, spans.line)
    begun: F64 = _first_lines(pieces, cut, count)
    left, right = faces.face.T
    name = np.minimum(left, right) * faces.count + np.maximum(left, right)
    border = np.unique(name, return_inverse=True)[1].ravel()
    first = np.full(len(border), math.inf)
    cuts = faces.edge >= 0
    np.minimum.at(first, border[cuts], begun[cuts])
    return np.where(cuts, first[border], -1.0)


@kernel
def _first_lines(pieces: _CutPieces, spans: _CutSpans, count: int) -> Any:
    """Return the program line of the first stretch that lies on each of p pieces of cuts, (p,).

    The line is infinite for a piece that no tool touches, and for a link.  ``count`` is the number
    of cuts.
    """
    owner, begin, end = pieces
    edge, low, high, line = spans
    first = np.searchsorted(edge, np.arange(count + 1))
    begun = np.full(len(owner), math.inf)
    for p in range(len(owner)):
        if owner[p] < 0:
            continue
        least = min(GAP_LENGTH, 0.5 * (end[p] - begin[p]))
        for k in range(first[owner[p]], first[owner[p] + 1]):
            if min(high[k], end[p]) - max(low[k], begin[p]) >= least:
                begun[p] = line[k]
                break
    return begun


@kernel
def _completing_lines(
    pieces: _CutPieces, spans: _CutSpans, count: int, rest: float, reach: float
) -> Any:
    """Return the program line that completes each of p pieces of cuts and links, (p,).

    See ``completing_lines`` for the line of a piece that is never completed or never touched.

    ``rest`` mm: longest uncut length that does not hold the part.
    ``reach`` mm: radius of the widest cutter, 0 if there are only knives.
    """
    owner, begin, end = pieces
    edge, low, high, line = spans
    first = np.searchsorted(edge, np.arange(count + 1))
    complete = np.full(len(owner), 0.0 if reach > 0.0 else math.inf)
    for p in range(len(owner)):
        if owner[p] < 0:
            complete[p] = -1.0
            continue
        a, b = begin[p], end[p]
        permitted = max(rest, _CORNER_RATIO * reach) if reach > 0.0 else min(rest, 0.5 * (b - a))
        covered = np.empty((first[owner[p] + 1] - first[owner[p]] + 1, 2))
        many = 0
        for k in range(first[owner[p]], first[owner[p] + 1]):
            left, right = max(low[k], a), min(high[k], b)
            if right <= left:
                continue
            complete[p] = math.inf
            if line[k] < 0:
                continue
            many, _ = add_interval(covered, many, left, right)
            uncovered, position = 0.0, a
            for j in range(many):
                uncovered = max(uncovered, covered[j, 0] - position)
                position = covered[j, 1]
            if max(uncovered, b - position) <= permitted:
                complete[p] = line[k]
                break
    return complete


@kernel
def new_spans(edge: I64_1, low: F64_1, high: F64_1, through: Bool_1) -> Any:
    """Return the mask of the stretches of cuts that are not repetitions of earlier stretches, (k,).

    A stretch is no repetition if earlier stretches through the board cover at most half of it.
    ``edge``, ``low`` and ``high`` are the index of the cut of each of k stretches, and the
    stretch's start and end on it (mm), sorted by cut and then by program line; ``through`` is the
    mask of the stretches that are cut through.
    """
    fresh = np.zeros(len(edge), np.bool_)
    begin = 0
    while begin < len(edge):
        end = begin
        while end < len(edge) and edge[end] == edge[begin]:
            end += 1
        covered = np.empty((end - begin + 1, 2))
        many = 0
        for k in range(begin, end):
            repeated = 0.0
            for j in range(many):
                repeated += max(min(covered[j, 1], high[k]) - max(covered[j, 0], low[k]), 0.0)
            fresh[k] = repeated <= 0.5 * (high[k] - low[k])
            if through[k]:
                many, _ = add_interval(covered, many, low[k], high[k])
        begin = end
    return fresh
