"""loose: is anything worked on a piece of board that the cuts before have already set free?

    Bench, Work -> findings

The cuts are split where they meet, and contours are closed where ends of cuts lie within ``GAP`` of
another cut.  Each piece of a cut is done with the line of the program that completes it.  Two faces
beside a piece hang together until it is done, so a face is held by the sheet until

    free(face) = max over all ways from the face to the outside of min over the pieces on it of done

which joining the faces in the order of ``done``, the latest first, gives for all of them at once.
What is worked in a face after that line is worked on a loose piece.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_1, I64_1, I64_2, kernel
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.verification.checks.check_context import DEPTH_TOLERANCE, CheckContext
from knifetip.verification.checks.cut_faces import GAP_LENGTH, CutFaces, find_cut_faces
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import line_curves, point_at
from knifetip.verification.curves.intervals import add_interval
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.cutter_paths import cutter_paths
from knifetip.verification.expectation.edges import (
    TOUCH_DISTANCE,
    Edges,
    without_duplicates,
)
from knifetip.verification.expectation.outline import find_outlines
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind, expected_tool

#: Edges of these types are not worked.
_NO_WORK: Final = (LineType.UNCLASSIFIED, LineType.IGNORED)


#: A stretch on an edge that is shorter than this only crosses the edge (mm).
_MIN_LENGTH: Final = 0.1


#: Beside a corner of 28° a cutter leaves so many times its radius of either edge untouched.
_CORNER_RATIO: Final = 4.0


#: Where along other work it is looked at, in shares.
_PROBES: Final = (0.1, 0.5, 0.9)


@dataclass(frozen=True, eq=False, slots=True)
class _WorkedSpans:
    """Where cuts are worked, by edge and then by line."""

    edge: I64  #: (k,)
    low: F64  #: (k,) mm along the edge
    high: F64  #: (k,)
    line: I64  #: (k,)
    through: Bool  #: (k,)
    way: I64  #: (k,) row of the work
    reach: float  #: mm, the radius of the widest cutter, 0 for knives


def check_work_order(bench: CheckContext, work: TipPaths) -> None:
    """Judge whether everything inside a contour is worked before the contour is complete."""
    cuts, _, _ = without_duplicates(bench.edges.of(LineType.CUT))
    if len(cuts) == 0 or len(work.z) == 0:
        return
    net = find_cut_faces(cuts)
    done = _worked_spans(bench, work, cuts)
    complete = _completing_lines(
        net.edge, net.begin, net.begin + net.curve[:, 5], done.edge, done.low, done.high,
        np.where(done.through, done.line, -1), len(cuts), done.reach,
    )  # fmt: skip
    order = np.argsort(-complete, kind="stable")
    free = _freeing_lines(order, complete, net.face, net.count)
    _check_cuts(bench, cuts, net, done, free)
    _check_other_edges(bench, cuts, net, work, done, free)


def _check_cuts(
    bench: CheckContext, cuts: Edges, net: CutFaces, done: _WorkedSpans, free: F64
) -> None:
    """Judge the work on cuts: of the pieces of each stretch the one that is held longest.

    A line drawn across others is made in one go, and may lie in board that is held and in board
    that is loose; pieces shorter than ``GAP_LENGTH`` do not hold it.
    """
    pieces = np.flatnonzero(net.edge >= 0)
    first = np.searchsorted(net.edge[pieces], np.arange(len(cuts) + 1))
    held = free[net.face[pieces]].max(axis=1)
    begin = net.begin[pieces]
    until = _held_until(
        done.edge, done.low, done.high, first, begin, begin + net.curve[pieces, 5], held
    )
    late = done.line > until
    if done.reach == 0.0:
        # A knife runs on over its end, into a cut that may be made already.
        late &= _new_spans(done.edge, done.low, done.high)
    some = np.flatnonzero(late)
    for k in some[np.unique(done.edge[some], return_index=True)[1]][:MAX_FINDINGS]:
        edge = int(done.edge[k])
        place = point_at(
            cuts.curve[edge : edge + 1], np.array([0.5 * (done.low[k] + done.high[k])])
        )
        _add_finding(bench, int(cuts.row[edge]), place[0], int(done.line[k]), int(until[k]))


def _check_other_edges(
    bench: CheckContext, cuts: Edges, net: CutFaces, work: TipPaths, done: _WorkedSpans, free: F64
) -> None:
    """Judge what is worked on other edges: creases, grooves, half-cuts, perforations."""
    some = work.line > free.min()
    some[done.way] = False
    rows = np.flatnonzero(some)
    kinds = (kind for kind in LineType if kind not in (LineType.CUT, *_NO_WORK))
    edges = bench.edges.of(*kinds)
    near = find_overlaps(
        work.curve[rows], edges.curve, np.zeros(len(edges)), edges.curve[:, 5], TOUCH_DISTANCE
    )
    # What only crosses an edge is no work on it; a wheel that presses one place goes nowhere.
    size = np.diff(near.along)[:, 0]
    long = np.flatnonzero(
        near.best & (size >= np.minimum(_MIN_LENGTH, work.curve[rows[near.curve], 5]))
    )
    way, along = rows[near.curve[long]], near.along[long]
    until = np.full(len(long), math.inf)
    place = np.zeros((len(long), 2))
    for share in _PROBES:
        points = point_at(work.curve[way], along @ (1.0 - share, share))
        on = find_overlaps(
            line_curves(points, points),
            cuts.curve,
            np.zeros(len(cuts)),
            cuts.curve[:, 5],
            TOUCH_DISTANCE,
        )
        held = free[net.located(points)]
        held[on.curve] = math.inf
        sooner = held < until
        until[sooner], place[sooner] = held[sooner], points[sooner]
    late = np.flatnonzero(work.line[way] > until)
    late = late[np.unique(way[late], return_index=True)[1]]
    for k in late[:MAX_FINDINGS]:
        row = int(edges.row[near.edge[long[k]]])
        _add_finding(bench, row, place[k], int(work.line[way[k]]), int(until[k]))


def _add_finding(bench: CheckContext, edge: int, place: F64, line: int, closed: int) -> None:
    bench.found.add(
        "order",
        Message("verify.loose-piece", x=place[0], y=place[1], line=closed),
        0.0,
        edge=edge,
        line=line,
    )


def _worked_spans(bench: CheckContext, work: TipPaths, cuts: Edges) -> _WorkedSpans:
    """Return where along the cuts there is work: a knife's on the line, a cutter's beside it."""
    size = cuts.curve[:, 5]
    knife = np.flatnonzero(work.trade == OperationKind.CUT)
    near = find_overlaps(work.curve[knife], cuts.curve, np.zeros(len(cuts)), size, bench.tolerance)
    keep = near.best
    columns: list[tuple[I32 | I64, F64, F64, I64, Bool]] = [
        (near.edge[keep], near.place[keep].min(axis=1), near.place[keep].max(axis=1),
         knife[near.curve[keep]], np.ones(int(keep.sum()), np.bool_)),
    ]  # fmt: skip
    mill = work.trade == OperationKind.MILL
    bounds = find_outlines(cuts) if mill.any() else None
    widest = 0.0
    for index in np.unique(work.station[mill]):
        held = bench.machine.stations[int(index)]
        assert bounds is not None
        tool = expected_tool(held.tool)
        assert tool.disc is not None
        give = next((one for one in bench.board.deflection if one.tool == held.name), None)
        reach = np.full(2, tool.disc.radius) - ((give.x, give.y) if give else 0.0)
        widest = max(widest, float(reach.max()))
        beside = cutter_paths(bounds, reach)
        rows = np.flatnonzero(mill & (work.station == index))
        length = beside.curve[:, 5]
        near = find_overlaps(
            work.curve[rows], beside.curve, np.zeros(len(length)), length, bench.tolerance
        )
        low, high = beside.on_edge(near.edge, near.place)
        deep = bench.board.caliper - work.z[rows[near.curve]]
        planned = tool.through_depth(bench.board.caliper, bench.machine.into_mat)
        through = deep >= planned - DEPTH_TOLERANCE
        columns.append((beside.edge[near.edge], low, high, rows[near.curve], through))
    edge, low, high, way, through = (np.concatenate(one) for one in zip(*columns, strict=True))
    # What only crosses a cut, or touches its end, is no work on it.
    long = np.flatnonzero(high - low >= np.minimum(_MIN_LENGTH, 0.5 * size[edge]))
    long = long[np.lexsort((work.line[way[long]], edge[long]))]
    way = way[long].astype(np.int64)
    return _WorkedSpans(
        edge[long].astype(np.int64), low[long], high[long], work.line[way].astype(np.int64),
        through[long], way, widest,
    )  # fmt: skip


@kernel
def _completing_lines(
    owner: I64_1, begin: F64_1, end: F64_1, edge: I64_1, low: F64_1, high: F64_1,
    line: I64_1, count: int, reach: float,
) -> Any:  # fmt: skip
    """Return the line that completes each piece, infinite for none; before all others for links.

    A cutter does not come to all of a piece beside an inner corner, and to none of a short one, and
    passes round both: what is left so is no hold.
    """
    first = np.searchsorted(edge, np.arange(count + 1))
    complete = np.full(len(owner), 0.0 if reach > 0.0 else math.inf)
    for p in range(len(owner)):
        if owner[p] < 0:
            complete[p] = -1.0
            continue
        a, b = begin[p], end[p]
        most = _CORNER_RATIO * reach if reach > 0.0 else min(GAP_LENGTH, 0.5 * (b - a))
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
            bare, at = 0.0, a
            for j in range(many):
                bare = max(bare, covered[j, 0] - at)
                at = covered[j, 1]
            if max(bare, b - at) <= most:
                complete[p] = line[k]
                break
    return complete


@kernel
def _new_spans(edge: I64_1, low: F64_1, high: F64_1) -> Any:
    """Return which stretches, by edge and then by line, are new for half of their length."""
    fresh = np.zeros(len(edge), np.bool_)
    begin = 0
    while begin < len(edge):
        end = begin
        while end < len(edge) and edge[end] == edge[begin]:
            end += 1
        covered = np.empty((end - begin + 1, 2))
        many = 0
        for k in range(begin, end):
            many, gained = add_interval(covered, many, low[k], high[k])
            fresh[k] = gained >= 0.5 * (high[k] - low[k])
        begin = end
    return fresh


@kernel
def _held_until(
    edge: I64_1, low: F64_1, high: F64_1, first: I64_1, begin: F64_1, end: F64_1, held: F64_1
) -> Any:
    """Return until which line each stretch is held: by a short piece only if it has no other."""
    until = np.full(len(edge), -1.0)
    for k in range(len(edge)):
        for least in (GAP_LENGTH, 0.0):
            for p in range(first[edge[k]], first[edge[k] + 1]):
                shared = min(high[k], end[p]) - max(low[k], begin[p])
                if (
                    shared >= min(_MIN_LENGTH, 0.5 * (end[p] - begin[p]))
                    and end[p] - begin[p] > least
                ):
                    until[k] = max(until[k], held[p])
            if until[k] >= 0.0:
                break
        if until[k] < 0.0:
            until[k] = math.inf
    return until


@kernel
def _freeing_lines(order: I64_1, complete: F64_1, face: I64_2, count: int) -> Any:
    """Return the line after which each face is loose, infinite for those that stay held.

    ``order`` has the pieces that are done last first.
    """
    free = np.full(count, math.inf)
    parent = np.arange(count)
    onward = np.arange(count)
    for p in order:
        if complete[p] <= 0.0:
            # What only links part from the rest, or pieces that no cutter reaches, is too small.
            break
        a, b = face[p, 0], face[p, 1]
        while parent[a] != a:
            parent[a] = parent[parent[a]]
            a = parent[a]
        while parent[b] != b:
            parent[b] = parent[parent[b]]
            b = parent[b]
        if a == b:
            continue
        if b == 0:
            a, b = b, a
        if a == 0:
            # The faces of b, a ring of them, are held until now.
            each = b
            while True:
                free[each] = complete[p]
                each = onward[each]
                if each == b:
                    break
        onward[a], onward[b] = onward[b], onward[a]
        parent[b] = a
    return free
